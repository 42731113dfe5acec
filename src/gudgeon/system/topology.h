// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The mechanism as a spanning tree of absolute angles: which body shares which angle, how each body hangs from the
// frame, and which joints remain to close loops.
#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "gudgeon/base/vec2.h"
#include "gudgeon/model/mechanism.h"
#include "gudgeon/system/pinned_bodies.h"

namespace gudgeon {

/// Turns are the absolute angles of groups of bodies that keep their relative angles; slides are the displacements that
/// scale a vector. Both are numbered with the unknown ones first, then the driven ones, then one that never changes:
/// the frame's angle, always zero, and the unit slide, always one.
struct CoordinateCounts {
  int n_free_turns = 0;
  int n_driven_turns = 0;
  int n_free_slides = 0;
  int n_driven_slides = 0;

  [[nodiscard]] int n_turns() const { return n_free_turns + n_driven_turns + 1; }
  [[nodiscard]] int n_slides() const { return n_free_slides + n_driven_slides + 1; }
  [[nodiscard]] int frame_turn() const { return n_turns() - 1; }
  [[nodiscard]] int unit_slide() const { return n_slides() - 1; }
  [[nodiscard]] int n_free() const { return n_free_turns + n_free_slides; }
  [[nodiscard]] int n_driven() const { return n_driven_turns + n_driven_slides; }
};

/// One term of a path: a constant vector, turned by one angle and scaled by one slide.
struct Term {
  int turn = 0;
  int slide = 0;
  Vec2 vector;
};
/// A point's position is the sum of its terms, frame first.
using Path = std::vector<Term>;

/// Where a body hangs in the tree.
struct BodyNode {
  int turn = 0;
  double offset = 0.0;  ///< body angle − turn angle [rad]
  int parent = -1;      ///< body nearer to the frame; -1 for the frame and for bodies loose from it
  int joint = -1;       ///< the joint to the parent
  int depth = 0;
  Path origin;  ///< path to the body's origin
};

/// What must vanish for a loop to be closed.
enum class ClosureKind {
  point,  ///< both components of the second point minus the first
  line,   ///< the component across a line that turns with the first body: a free prismatic joint, a pin in a slot
  angle,  ///< the angle of a body against another one minus what their driver asks for [rad]
};

/// How many rows a closure has.
constexpr int count_rows(ClosureKind kind) { return kind == ClosureKind::point ? 2 : 1; }

/// A joint that closes a loop, or a driver between two moving bodies.
struct Closure {
  int joint = -1;   ///< -1 for a driver's
  int driver = -1;  ///< index into Topology::driven; -1 for a joint's
  ClosureKind kind = ClosureKind::point;
};

/// A joint that ties the angles of two bodies and is not implied by other such joints: a prismatic or rigid one, or the
/// later of two pins.
struct AngleTie {
  int joint = 0;
};

/// The motion that one driver asks for: value = start + speed t + f(t).
struct DrivenMotion {
  int driver = 0;      ///< index into Mechanism::drivers
  double start = 0.0;  ///< of the turn or slide, offsets removed
  double speed = 0.0;
  std::variant<std::monostate, Expression, SampledCurve> motion = std::monostate{};  ///< f, none if uniform
  double difference_step = 0.0;  ///< [s] that an expression's rate is found with, once it is compiled

  [[nodiscard]] bool is_uniform() const { return std::holds_alternative<std::monostate>(motion); }
};

struct Topology {
  CoordinateCounts counts;
  std::vector<JointEnds> ends;            ///< one a joint
  std::vector<BodyNode> bodies;           ///< one a body
  std::vector<int> joint_slide;           ///< one a joint: its slide, or -1
  std::vector<int> free_slide_joint;      ///< one a free slide: its joint, or -1 for a loose body's x or y
  std::vector<std::array<int, 2>> loose;  ///< one a loose body: body, and its first slide (x; y follows)
  std::vector<Closure> closures;
  std::vector<AngleTie> angle_ties;
  std::vector<int> redundant_ties;   ///< joints whose angle condition others imply
  std::vector<PinnedPair> pinned;    ///< joints that make two bodies one rigid body
  std::vector<int> implied;          ///< joints within a rigid body and outside the tree: the others keep them closed
  std::vector<DrivenMotion> driven;  ///< one a driver: turns, then slides, in coordinate order, then angles of closures

  /// The path to a point given in a body's own axes.
  [[nodiscard]] Path find_path(int body, Vec2 local) const;
};

/// What holds a closure, in words: "joint 'A'" or "driver 'elbow'".
std::string name_closure(const Mechanism& mechanism, const Topology& topology, const Closure& closure);

/// Direction [rad] of the line that a prismatic joint or a pin in a slot has in its first body's axes.
double find_line_direction(const AnyJoint& joint);

/// Grows the tree. Throws ModelError when drivers or angle conditions contradict each other.
Topology find_topology(const Mechanism& mechanism);

}  // namespace gudgeon
