// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A depth-first walk over the joints that fix relative angles.
#include "gudgeon/system/angle_groups.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "gudgeon/base/diagnostics.h"

namespace gudgeon {

namespace {

struct RelativeAngle {
  int joint;
  int first;
  int second;
  double angle;  // θ_second − θ_first
};

std::optional<double> find_relative_angle(const AnyJoint& joint) {
  if (const auto* prismatic = std::get_if<Prismatic>(&joint)) return prismatic->relative_angle;
  if (const auto* rigid = std::get_if<Rigid>(&joint)) return rigid->relative_angle;
  return std::nullopt;
}

std::vector<RelativeAngle> find_relative_angles(const Mechanism& mechanism, const std::vector<JointEnds>& ends,
                                                const std::vector<PinnedPair>& pairs) {
  std::vector<RelativeAngle> found;
  for (std::size_t j = 0; j < ends.size(); ++j) {
    if (const auto angle = find_relative_angle(mechanism.joints[j].kind)) {
      found.push_back({static_cast<int>(j), ends[j].first.body, ends[j].second.body, *angle});
    }
  }
  for (const PinnedPair& pair : pairs) {
    found.push_back({pair.joint, ends[pair.joint].first.body, ends[pair.joint].second.body, pair.relative_angle});
  }
  return found;
}

void throw_if_conflicting(const Mechanism& mechanism, const RelativeAngle& relative, double implied) {
  const double difference = std::remainder(implied - relative.angle, 2.0 * std::numbers::pi);
  // Model files give angles with some ten digits; a real contradiction is far larger.
  if (std::abs(difference) < 1e-9) return;
  Diagnostics diagnostics;
  const std::string& name = mechanism.joints[relative.joint].name;
  if (!find_relative_angle(mechanism.joints[relative.joint].kind)) {
    diagnostics.error("E-MODEL-060", "joints." + name,
                      fmt::format("joint '{}' pins two bodies a second time and so holds them at {} rad to each other, "
                                  "but guides and rigid joints already hold them at {} rad",
                                  name, relative.angle, implied),
                      {"make the angles agree, or pin the bodies once"});
    throw ModelError(diagnostics);
  }
  diagnostics.error("E-MODEL-060", "joints." + name + ".relative_angle",
                    fmt::format("joint '{}': relative_angle is {} rad, but other guides and rigid joints already hold "
                                "the two bodies at {} rad",
                                name, relative.angle, implied),
                    {"make the angles agree, or use a revolute joint where the bodies may turn"});
  throw ModelError(diagnostics);
}

}  // namespace

AngleGroups find_angle_groups(const Mechanism& mechanism, const std::vector<JointEnds>& ends,
                              const std::vector<PinnedPair>& pairs) {
  const int n_bodies = static_cast<int>(mechanism.bodies.size());
  AngleGroups groups{std::vector<int>(n_bodies, -1), std::vector<double>(n_bodies, 0.0), {}, {}, 0};
  const std::vector<RelativeAngle> relatives = find_relative_angles(mechanism, ends, pairs);
  std::vector<bool> used(relatives.size(), false);
  std::vector<std::vector<std::size_t>> at_body(n_bodies);
  for (std::size_t k = 0; k < relatives.size(); ++k) {
    for (const int body : {relatives[k].first, relatives[k].second}) at_body[body].push_back(k);
  }

  for (int seed = 0; seed < n_bodies; ++seed) {
    if (groups.group[seed] >= 0) continue;
    groups.group[seed] = groups.n_groups;
    std::vector<int> open{seed};
    while (!open.empty()) {
      const int body = open.back();
      open.pop_back();
      for (const std::size_t k : at_body[body]) {
        const RelativeAngle& relative = relatives[k];
        if (used[k]) continue;
        used[k] = true;
        const int other = relative.first == body ? relative.second : relative.first;
        const double step = relative.first == body ? relative.angle : -relative.angle;
        if (groups.group[other] < 0) {
          groups.group[other] = groups.n_groups;
          groups.offset[other] = groups.offset[body] + step;
          groups.ties.push_back(relative.joint);
          open.push_back(other);
        } else {
          throw_if_conflicting(mechanism, relative, groups.offset[relative.second] - groups.offset[relative.first]);
          groups.redundant.push_back(relative.joint);
        }
      }
    }
    ++groups.n_groups;
  }
  return groups;
}

}  // namespace gudgeon
