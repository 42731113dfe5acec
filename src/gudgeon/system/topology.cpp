// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Numbering of turns and slides, growth of the tree, and the paths along it.
#include "gudgeon/system/topology.h"

#include <fmt/format.h>

#include <algorithm>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/system/angle_groups.h"
#include "gudgeon/system/spanning_tree.h"

namespace gudgeon {

namespace {

[[noreturn]] void throw_driver_error(const Driver& driver, const std::string& reason, const std::string& next_step) {
  Diagnostics diagnostics;
  diagnostics.error("E-MODEL-061", "drivers." + driver.name, fmt::format("driver '{}': {}", driver.name, reason),
                    {next_step});
  throw ModelError(diagnostics);
}

class TopologyBuilder {
 public:
  explicit TopologyBuilder(const Mechanism& mechanism)
      : mechanism_(mechanism),
        names_(mechanism),
        ends_(find_joint_ends(mechanism)),
        pinned_(find_pinned_bodies(mechanism, ends_)),
        groups_(find_angle_groups(mechanism, ends_, pinned_.pairs)) {
    topology_.bodies.resize(mechanism.bodies.size());
    topology_.joint_slide.assign(mechanism.joints.size(), -1);
    topology_.redundant_ties = groups_.redundant;
    topology_.pinned = pinned_.pairs;
    for (const int joint : groups_.ties) topology_.angle_ties.push_back({joint});
  }

  Topology build() {
    find_drivers();
    number_turns();
    grow_tree();
    number_slides();
    trace_paths();
    collect_closures();
    topology_.ends = std::move(ends_);
    return std::move(topology_);
  }

 private:
  void find_drivers() {
    angle_driver_.assign(groups_.n_groups, -1);
    slide_driver_.assign(mechanism_.joints.size(), -1);
    for (int d = 0; d < static_cast<int>(mechanism_.drivers.size()); ++d) {
      const Driver& driver = mechanism_.drivers[d];
      if (const auto* slide = std::get_if<DrivenSlide>(&driver.target)) {
        int& slot = slide_driver_[names_.find_joint(slide->joint)];
        if (slot >= 0) throw_driver_error(driver, "its joint is driven already", "remove one of the two drivers");
        slot = d;
        continue;
      }
      const DrivenAngle& angle = std::get<DrivenAngle>(driver.target);
      const int group = groups_.group[names_.find_body(angle.body)];
      const int against = groups_.group[names_.find_body(angle.against)];
      if (against != groups_.group[0]) {
        if (group == against) {
          throw_driver_error(driver, "guides, rigid joints or two pins hold the angle between its two bodies",
                             "remove the driver, or join the bodies by a revolute joint");
        }
        relative_drivers_.push_back(d);
        continue;
      }
      if (group == groups_.group[0]) {
        throw_driver_error(driver, "guides, rigid joints or two pins hold its body's angle to the frame",
                           "drive the prismatic joint (slide = \"…\") instead");
      }
      if (angle_driver_[group] >= 0) {
        throw_driver_error(driver, "its body's angle is driven already, through a guide, a rigid joint or two pins",
                           "remove one of the two drivers");
      }
      angle_driver_[group] = d;
    }
  }

  void number_turns() {
    CoordinateCounts& counts = topology_.counts;
    counts.n_driven_turns = static_cast<int>(std::ranges::count_if(angle_driver_, [](int d) { return d >= 0; }));
    counts.n_free_turns = groups_.n_groups - 1 - counts.n_driven_turns;
    std::vector<int> turn_of_group(groups_.n_groups, -1);
    turn_of_group[groups_.group[0]] = counts.frame_turn();
    int next_free = 0;
    int next_driven = counts.n_free_turns;
    for (int g = 0; g < groups_.n_groups; ++g) {
      if (g != groups_.group[0]) turn_of_group[g] = angle_driver_[g] >= 0 ? next_driven++ : next_free++;
    }
    for (std::size_t b = 0; b < topology_.bodies.size(); ++b) {
      topology_.bodies[b].turn = turn_of_group[groups_.group[b]];
      topology_.bodies[b].offset = groups_.offset[b];
    }
    for (int g = 0; g < groups_.n_groups; ++g) {
      if (angle_driver_[g] < 0) continue;
      topology_.driven.push_back(make_motion(angle_driver_[g]));
    }
  }

  // What a driver asks of its turn or slide, or of the difference of two turns.
  DrivenMotion make_motion(int index) const {
    const Driver& driver = mechanism_.drivers[index];
    DrivenMotion motion{index, 0.0, 0.0, driver.motion};
    if (driver.is_uniform()) motion.start = driver.start, motion.speed = driver.speed;
    if (const auto* angle = std::get_if<DrivenAngle>(&driver.target)) {
      motion.start += groups_.offset[names_.find_body(angle->against)];
      motion.start -= groups_.offset[names_.find_body(angle->body)];
    }
    return motion;
  }

  void grow_tree() {
    std::vector<TreeEdge> edges;
    for (int j = 0; j < static_cast<int>(mechanism_.joints.size()); ++j) {
      const AnyJoint& kind = mechanism_.joints[j].kind;
      if (has_clearance(kind) || std::holds_alternative<PinInSlot>(kind)) continue;
      const bool adds_slide = std::holds_alternative<Prismatic>(kind) && slide_driver_[j] < 0;
      edges.push_back({j, ends_[j].first.body, ends_[j].second.body, {!pinned_.is_inner[j], adds_slide}});
    }
    tree_ = grow_spanning_tree(mechanism_.bodies.size(), edges);
    joint_in_tree_.assign(mechanism_.joints.size(), false);
    for (std::size_t b = 0; b < tree_.links.size(); ++b) {
      const TreeLink& link = tree_.links[b];
      topology_.bodies[b].parent = link.parent;
      topology_.bodies[b].joint = link.joint;
      topology_.bodies[b].depth = link.depth;
      if (link.joint >= 0) joint_in_tree_[link.joint] = true;
    }
    for (const int body : tree_.roots) {
      if (body != 0) topology_.loose.push_back({body, -1});
    }
  }

  void number_slides() {
    CoordinateCounts& counts = topology_.counts;
    loose_slide_.assign(mechanism_.bodies.size(), -1);
    for (auto& [body, slide] : topology_.loose) {
      slide = counts.n_free_slides;
      loose_slide_[body] = slide;
      counts.n_free_slides += 2;
      topology_.free_slide_joint.insert(topology_.free_slide_joint.end(), {-1, -1});
    }
    for (int j = 0; j < static_cast<int>(mechanism_.joints.size()); ++j) {
      if (joint_in_tree_[j] && std::holds_alternative<Prismatic>(mechanism_.joints[j].kind) && slide_driver_[j] < 0) {
        topology_.joint_slide[j] = counts.n_free_slides++;
        topology_.free_slide_joint.push_back(j);
      }
    }
    for (int j = 0; j < static_cast<int>(mechanism_.joints.size()); ++j) {
      if (slide_driver_[j] < 0) continue;
      topology_.joint_slide[j] = counts.n_free_slides + counts.n_driven_slides++;
      topology_.driven.push_back(make_motion(slide_driver_[j]));
    }
  }

  // The line of a prismatic joint as a term: along it, scaled by its slide.
  Term line_term(int joint) const {
    const auto& prismatic = std::get<Prismatic>(mechanism_.joints[joint].kind);
    const BodyNode& first = topology_.bodies[ends_[joint].first.body];
    const Rotation along = make_rotation(first.offset + prismatic.direction);
    return {first.turn, topology_.joint_slide[joint], {along.c, along.s}};
  }

  void trace_paths() {
    for (const int b : tree_.order) {
      BodyNode& node = topology_.bodies[b];
      if (node.parent < 0) {
        if (b != 0) node.origin = loose_origin(b);
        continue;
      }
      const auto& [first, second] = ends_[node.joint];
      const bool forward = first.body == node.parent;
      const JointEnd& outer = forward ? second : first;
      const JointEnd& inner = forward ? first : second;
      node.origin = topology_.find_path(node.parent, inner.point);
      if (topology_.joint_slide[node.joint] >= 0) {
        Term line = line_term(node.joint);
        if (!forward) line.vector = -line.vector;
        node.origin.push_back(line);
      }
      const Vec2 back = make_rotation(node.offset) * -outer.point;
      node.origin.push_back({node.turn, topology_.counts.unit_slide(), back});
    }
  }

  // A loose body's x and y are those of its centre of mass, which decouples them from its angle.
  Path loose_origin(int body) const {
    const CoordinateCounts& counts = topology_.counts;
    const int slide = loose_slide_[body];
    const BodyNode& node = topology_.bodies[body];
    const Vec2 back = make_rotation(node.offset) * -mechanism_.bodies[body].center_of_mass;
    return {{counts.frame_turn(), slide, {1.0, 0.0}},
            {counts.frame_turn(), slide + 1, {0.0, 1.0}},
            {node.turn, counts.unit_slide(), back}};
  }

  void collect_closures() {
    for (int j = 0; j < static_cast<int>(mechanism_.joints.size()); ++j) {
      const AnyJoint& kind = mechanism_.joints[j].kind;
      if (joint_in_tree_[j] || has_clearance(kind)) continue;
      if (pinned_.is_inner[j]) {
        topology_.implied.push_back(j);
        continue;
      }
      const bool is_line =
          std::holds_alternative<PinInSlot>(kind) || (std::holds_alternative<Prismatic>(kind) && slide_driver_[j] < 0);
      topology_.closures.push_back({j, -1, is_line ? ClosureKind::line : ClosureKind::point});
    }
    for (const int d : relative_drivers_) {
      topology_.closures.push_back({-1, static_cast<int>(topology_.driven.size()), ClosureKind::angle});
      topology_.driven.push_back(make_motion(d));
    }
  }

  const Mechanism& mechanism_;
  NameIndex names_;
  std::vector<JointEnds> ends_;
  PinnedBodies pinned_;
  AngleGroups groups_;
  Topology topology_;
  std::vector<int> angle_driver_;  // one a group, or -1
  std::vector<int> slide_driver_;  // one a joint, or -1
  std::vector<int> relative_drivers_;
  SpanningTree tree_;
  std::vector<bool> joint_in_tree_;
  std::vector<int> loose_slide_;  // one a body: its x, or -1
};

}  // namespace

Path Topology::find_path(int body, Vec2 local) const {
  const BodyNode& node = bodies[body];
  Path path = node.origin;
  const Vec2 vector = make_rotation(node.offset) * local;
  if (!path.empty() && path.back().turn == node.turn && path.back().slide == counts.unit_slide()) {
    path.back().vector += vector;
  } else {
    path.push_back({node.turn, counts.unit_slide(), vector});
  }
  return path;
}

std::string name_closure(const Mechanism& mechanism, const Topology& topology, const Closure& closure) {
  if (closure.joint >= 0) return fmt::format("joint '{}'", mechanism.joints[closure.joint].name);
  return fmt::format("driver '{}'", mechanism.drivers[topology.driven[closure.driver].driver].name);
}

double find_line_direction(const AnyJoint& joint) {
  const auto* slot = std::get_if<PinInSlot>(&joint);
  return slot != nullptr ? slot->direction : std::get<Prismatic>(joint).direction;
}

Topology find_topology(const Mechanism& mechanism) { return TopologyBuilder(mechanism).build(); }

}  // namespace gudgeon
