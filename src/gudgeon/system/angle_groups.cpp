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

std::vector<RelativeAngle> find_relative_angles(const Mechanism& mechanism) {
  std::vector<RelativeAngle> found;
  for (int j = 0; j < static_cast<int>(mechanism.joints.size()); ++j) {
    const Joint& joint = mechanism.joints[j];
    if (const auto angle = find_relative_angle(joint.kind)) {
      const auto [first, second] = anchors(joint.kind);
      found.push_back({j, find_body(mechanism, first.body), find_body(mechanism, second.body), *angle});
    }
  }
  return found;
}

void throw_if_conflicting(const Mechanism& mechanism, const RelativeAngle& relative, double implied) {
  const double difference = std::remainder(implied - relative.angle, 2.0 * std::numbers::pi);
  // Model files give angles with some ten digits; a real contradiction is far larger.
  if (std::abs(difference) < 1e-9) return;
  Diagnostics diagnostics;
  const std::string& name = mechanism.joints[relative.joint].name;
  diagnostics.error("E-MODEL-060", "joints." + name + ".relative_angle",
                    fmt::format("joint '{}': relative_angle is {} rad, but other guides and rigid joints already hold "
                                "the two bodies at {} rad",
                                name, relative.angle, implied),
                    {"make the angles agree, or use a revolute joint where the bodies may turn"});
  throw ModelError(diagnostics);
}

}  // namespace

AngleGroups find_angle_groups(const Mechanism& mechanism) {
  const int n_bodies = static_cast<int>(mechanism.bodies.size());
  AngleGroups groups{std::vector<int>(n_bodies, -1), std::vector<double>(n_bodies, 0.0), {}, {}, 0};
  const std::vector<RelativeAngle> relatives = find_relative_angles(mechanism);
  std::vector<bool> used(relatives.size(), false);

  for (int seed = 0; seed < n_bodies; ++seed) {
    if (groups.group[seed] >= 0) continue;
    groups.group[seed] = groups.n_groups;
    std::vector<int> open{seed};
    while (!open.empty()) {
      const int body = open.back();
      open.pop_back();
      for (std::size_t k = 0; k < relatives.size(); ++k) {
        const RelativeAngle& relative = relatives[k];
        if (used[k] || (relative.first != body && relative.second != body)) continue;
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
