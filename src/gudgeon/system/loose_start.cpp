// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Shifts of whole loose groups.
#include "gudgeon/system/loose_start.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/system/compile_contacts.h"
#include "gudgeon/system/resting_start.h"
#include "gudgeon/system/start_loads.h"
#include "gudgeon/system/topology.h"

namespace gudgeon {

namespace {

// Which bodies move along when one is shifted: those of its tree, and trees that a pin in a slot ties to it. One entry
// a body; a cluster has the number of one of its bodies, the frame's has 0.
std::vector<int> find_clusters(const Mechanism& mechanism, const Topology& topology) {
  std::vector<int> cluster(mechanism.bodies.size());
  for (std::size_t b = 0; b < cluster.size(); ++b) {
    int root = static_cast<int>(b);
    while (topology.bodies[root].parent >= 0) root = topology.bodies[root].parent;
    cluster[b] = root;
  }
  for (const Closure& closure : topology.closures) {
    if (closure.joint < 0) continue;
    const auto& [first, second] = topology.ends[closure.joint];
    const auto [low, high] = std::minmax({cluster[first.body], cluster[second.body]});
    std::ranges::replace(cluster, high, low);
  }
  return cluster;
}

Vec2 find_world(const Mechanism& mechanism, const Assembly& assembly, const Anchor& anchor) {
  const int body = find_body(mechanism, anchor.body);
  return assembly.poses[body].find_point(find_point(mechanism.bodies[body], anchor.point)->position);
}

/// A spring whose points coincide pulls in no direction.
void check_springs(const Mechanism& mechanism, const Assembly& assembly, Diagnostics& diagnostics) {
  constexpr double kNoLength = 1e-12;  // [m] what rounding leaves of the distance of two points that coincide
  for (const Load& load : mechanism.loads) {
    const auto* spring = std::get_if<Spring>(&load.kind);
    if (spring == nullptr) continue;
    const Vec2 first = find_world(mechanism, assembly, spring->first);
    const double scale = std::max(norm(first), 1.0);
    if (norm(find_world(mechanism, assembly, spring->second) - first) > kNoLength * scale) continue;
    diagnostics.error(
        "E-MODEL-075", "loads." + load.name,
        fmt::format("load '{}': its two points coincide at the start, so the spring has no direction", load.name),
        {"give it two points apart, or use a bushing, which pulls two points together from wherever they are"});
  }
}

bool lies_in_slot(const Mechanism& mechanism, int body) {
  return std::ranges::any_of(mechanism.joints, [&](const Joint& joint) {
    const auto* guide = std::get_if<PrismaticClearance>(&joint.kind);
    const std::string& name = mechanism.bodies[body].name;
    return guide != nullptr && (guide->journal.body == name || guide->bearing.body == name);
  });
}

// Turns a loose body, and what moves along with it, about its origin to the angle and rate given for it.
void turn_cluster(const BodyStart& start, int loose, const std::vector<int>& cluster, std::vector<BodyPose>& poses) {
  const BodyPose pivot = poses[loose];
  const double turn = std::remainder(start.angle.value_or(pivot.angle) - pivot.angle, 2.0 * std::numbers::pi);
  const double spin = start.angle_rate.value_or(pivot.angle_rate) - pivot.angle_rate;
  const Rotation rotation = make_rotation(turn);
  for (std::size_t body = 0; body < cluster.size(); ++body) {
    if (cluster[body] != cluster[loose]) continue;
    BodyPose& pose = poses[body];
    const Vec2 arm = rotation * (pose.position - pivot.position);
    pose.position = pivot.position + arm;
    pose.velocity = pivot.velocity + rotation * (pose.velocity - pivot.velocity) + spin * perp(arm);
    pose.angle += turn;
    pose.angle_rate += spin;
  }
}

}  // namespace

void place_loose_bodies(const Mechanism& mechanism, Assembly& assembly) {
  const Topology topology = find_topology(mechanism);
  const std::vector<int> cluster = find_clusters(mechanism, topology);
  std::vector<bool> placed(cluster.size(), false);
  placed[0] = true;
  for (const auto& [loose, slide] : topology.loose) {
    const BodyStart& start = mechanism.bodies[loose].start;
    // The ideal guide of a block would not let it tilt.
    const bool turns = (start.angle || start.angle_rate) && lies_in_slot(mechanism, loose);
    if (placed[cluster[loose]] || (!start.position && !start.velocity && !turns)) continue;
    placed[cluster[loose]] = true;
    if (turns) turn_cluster(start, loose, cluster, assembly.poses);
    const BodyPose pose = assembly.poses[loose];
    const Vec2 shift = start.position.value_or(pose.position) - pose.position;
    const Vec2 push = start.velocity.value_or(pose.velocity) - pose.velocity;
    for (std::size_t body = 0; body < cluster.size(); ++body) {
      if (cluster[body] != cluster[loose]) continue;
      assembly.poses[body].position += shift;
      assembly.poses[body].velocity += push;
    }
  }
}

namespace {

// A journal may be given to touch; rounding of its position must not count as overlap.
constexpr double kTouching = 1e-9;

class StartCheck {
 public:
  StartCheck(const Mechanism& mechanism, const Assembly& assembly) : mechanism_(mechanism), assembly_(assembly) {}

  void check(const Joint&, const auto&) {}

  void check(const Joint& joint, const RevoluteClearance& kind) {
    const RelativeMotion motion = find_motion(kind, find_local(kind.journal));
    const double eccentricity = norm(motion.offset);
    if (eccentricity <= kind.radial_clearance * (1.0 + kTouching)) return;
    report(overlaps, joint,
           fmt::format("its journal starts {:.6g} mm off the middle of its bearing, and radial_clearance is "
                       "{:.6g} mm",
                       1e3 * eccentricity, 1e3 * kind.radial_clearance));
  }
  void check(const Joint& joint, const PrismaticClearance& kind) { check_slot(joint, kind, "a corner of its block"); }
  void check(const Joint& joint, const PinInSlotClearance& kind) { check_slot(joint, kind, "its pin"); }

  Diagnostics overlaps;  // journals inside a surface
  Diagnostics overruns;  // and past the end of a slot

 private:
  // The deepest circle is told, and the one farthest past an end.
  template <class Slot>
  void check_slot(const Joint& joint, const Slot& kind, const char* journal) {
    double deepest = kTouching * kind.clearance;
    double farthest = kTouching * kind.bearing_length;
    for (const ContactCircle& circle : find_circles(kind, find_local(kind.journal))) {
      const ContactGap gap = find_gap(make_surfaces(kind, circle.bearing_surface), find_motion(kind, circle.center));
      deepest = std::max(deepest, gap.penetration);
      farthest = std::max(farthest, std::abs(gap.bearing_position) - 0.5 * kind.bearing_length);
    }
    if (deepest > kTouching * kind.clearance) {
      report(overlaps, joint,
             fmt::format("{} starts {:.6g} mm inside a side of its slot, and clearance is {:.6g} mm", journal,
                         1e3 * deepest, 1e3 * kind.clearance));
    }
    if (farthest > kTouching * kind.bearing_length) {
      report(overruns, joint,
             fmt::format("{} starts {:.6g} mm past the end of its slot, and bearing_length is {:.6g} mm", journal,
                         1e3 * farthest, 1e3 * kind.bearing_length));
    }
  }

  static void report(Diagnostics& diagnostics, const Joint& joint, const std::string& what) {
    diagnostics.error("E-MODEL-074", "joints." + joint.name, fmt::format("joint '{}': {}", joint.name, what),
                      {"change the start of the bodies it connects; journals that are loose start in the middle when "
                       "no start is given, and may press no deeper than their load presses them"});
  }

  Vec2 find_local(const Anchor& anchor) const {
    return find_point(mechanism_.bodies[find_body(mechanism_, anchor.body)], anchor.point)->position;
  }

  template <ClearanceJoint Kind>
  RelativeMotion find_motion(const Kind& kind, Vec2 journal_local) const {
    const BodyPose& bearing = assembly_.poses[find_body(mechanism_, kind.bearing.body)];
    const BodyPose& journal = assembly_.poses[find_body(mechanism_, kind.journal.body)];
    const Vec2 offset = journal.find_point(journal_local) - bearing.find_point(find_local(kind.bearing));
    return {offset, {}, bearing.angle, journal.angle, 0.0, 0.0};
  }

  const Mechanism& mechanism_;
  const Assembly& assembly_;
};

}  // namespace

bool lies_within_play(const Mechanism& mechanism, const Assembly& assembly) {
  StartCheck start(mechanism, assembly);
  for (const Joint& joint : mechanism.joints) {
    std::visit([&](const auto& kind) { start.check(joint, kind); }, joint.kind);
  }
  return !start.overlaps.has_errors() && !start.overruns.has_errors();
}

void require_clear_start(const Mechanism& mechanism, const Assembly& assembly) {
  StartCheck start(mechanism, assembly);
  for (const Joint& joint : mechanism.joints) {
    std::visit([&](const auto& kind) { start.check(joint, kind); }, joint.kind);
  }
  Diagnostics diagnostics = start.overruns;
  check_springs(mechanism, assembly, diagnostics);
  check_start_loads(mechanism, assembly, diagnostics);
  if (start.overlaps.has_errors()) {
    const System system = compile(mechanism, assembly);
    if (!rests_on_contacts(system, make_state(system, assembly))) diagnostics.append(start.overlaps);
  }
  if (diagnostics.has_errors()) throw ModelError(diagnostics);
}

}  // namespace gudgeon
