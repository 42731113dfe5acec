// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// States read from channels, and compared.
#include "tests/random/recorded_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace gudgeon::random {

namespace {

/// Force and moment about the centre of mass that a body feels from all its joints and drivers.
struct Feeling {
  Vec2 force;
  double moment = 0.0;
};

class Feelings {
 public:
  Feelings(const oracle::Textbook& textbook, const oracle::TextbookState& state)
      : textbook_(textbook), state_(state), bodies_(state.bodies.size()) {}

  /// A joint's force on its second body at its second anchor, and its moment; the first body feels the opposite there.
  void add_joint(const AnyJoint& joint, Vec2 force, double moment) {
    const auto [first, second] = anchors(joint);
    const oracle::TextbookPoint at = textbook_.eval_point(state_, second);
    add(at.body, at.position, force, moment);
    add(find_body(textbook_.mechanism(), first.body), at.position, -force, -moment);
  }

  void add_driver(const Driver& driver, double effort) {
    const Mechanism& mechanism = textbook_.mechanism();
    if (const auto* angle = std::get_if<DrivenAngle>(&driver.target)) {
      bodies_[static_cast<std::size_t>(find_body(mechanism, angle->body))].moment += effort;
      bodies_[static_cast<std::size_t>(find_body(mechanism, angle->against))].moment -= effort;
      return;
    }
    const AnyJoint& joint = mechanism.joints[find_joint(mechanism, std::get<DrivenSlide>(driver.target).joint)].kind;
    const auto& slide = std::get<Prismatic>(joint);
    const int body = find_body(mechanism, slide.first.body);
    const double line = state_.bodies[static_cast<std::size_t>(body)].angle + slide.direction;
    add_joint(joint, effort * Vec2{std::cos(line), std::sin(line)}, 0.0);
  }

  [[nodiscard]] const std::vector<Feeling>& bodies() const { return bodies_; }

 private:
  void add(int body, Vec2 at, Vec2 force, double moment) {
    Feeling& feeling = bodies_[static_cast<std::size_t>(body)];
    feeling.force += force;
    feeling.moment += moment + cross(at - state_.bodies[static_cast<std::size_t>(body)].center, force);
  }

  const oracle::Textbook& textbook_;
  const oracle::TextbookState& state_;
  std::vector<Feeling> bodies_;
};

bool carries_moment(const AnyJoint& joint) {
  return std::holds_alternative<Prismatic>(joint) || std::holds_alternative<Rigid>(joint);
}

oracle::TextbookReaction read_reaction(const RecordedMotion& motion, const Joint& joint, std::size_t sample) {
  const double moment = carries_moment(joint.kind) ? motion.value(joint.name + ".moment", sample) : 0.0;
  return {{motion.value(joint.name + ".x_force", sample), motion.value(joint.name + ".y_force", sample)}, moment};
}

void expect_same_accelerations(const RecordedMotion& motion, std::size_t sample,
                               const oracle::TextbookSolution& solution, double tolerance) {
  double scale = 1.0;
  for (const auto& a : solution.accelerations) scale = std::max({scale, norm(a.center), std::abs(a.angle)});
  const Mechanism& mechanism = motion.textbook().mechanism();
  for (std::size_t b = 1; b < mechanism.bodies.size(); ++b) {
    const std::string& name = mechanism.bodies[b].name;
    const oracle::TextbookAcceleration& expected = solution.accelerations[b];
    const double allowed = tolerance * scale;
    EXPECT_NEAR(motion.value(name + ".x_acceleration", sample), expected.center.x, allowed) << name;
    EXPECT_NEAR(motion.value(name + ".y_acceleration", sample), expected.center.y, allowed) << name;
    EXPECT_NEAR(motion.value(name + ".angle_acceleration", sample), expected.angle, allowed) << name;
  }
}

}  // namespace

double RecordedMotion::value(const std::string& channel, std::size_t sample) const {
  const std::vector<double>* values = find_values(stage_, channel);
  if (values == nullptr) throw std::out_of_range("not recorded: " + channel);
  return values->at(sample);
}

oracle::TextbookState RecordedMotion::state(std::size_t sample) const {
  oracle::TextbookState state = textbook_.make_state();
  for (std::size_t b = 1; b < state.bodies.size(); ++b) {
    const std::string& name = textbook_.mechanism().bodies[b].name;
    const auto read = [&](const char* what) { return value(name + what, sample); };
    state.bodies[b] = {
        {read(".x"), read(".y")}, read(".angle"), {read(".x_velocity"), read(".y_velocity")}, read(".angle_rate")};
  }
  return state;
}

double find_largest_gap(const RecordedMotion& motion, std::size_t sample) {
  const Eigen::VectorXd gaps = motion.textbook().eval_rows(motion.state(sample), motion.time(sample)).residual;
  return gaps.size() == 0 ? 0.0 : gaps.lpNorm<Eigen::Infinity>();
}

void expect_same_dynamics(const RecordedMotion& motion, std::size_t sample, double tolerance) {
  const oracle::Textbook& textbook = motion.textbook();
  const Mechanism& mechanism = textbook.mechanism();
  const oracle::TextbookState state = motion.state(sample);
  const oracle::TextbookSolution solution = textbook.solve(state, motion.time(sample));
  expect_same_accelerations(motion, sample, solution, tolerance);

  Feelings found(textbook, state);
  Feelings expected(textbook, state);
  double scale = 1.0;
  for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
    const Joint& joint = mechanism.joints[j];
    const oracle::TextbookReaction ours = read_reaction(motion, joint, sample);
    const oracle::TextbookReaction& theirs = solution.reactions[j];
    found.add_joint(joint.kind, ours.force, ours.moment);
    expected.add_joint(joint.kind, theirs.force, theirs.moment);
    scale = std::max({scale, norm(theirs.force), std::abs(theirs.moment), norm(ours.force), std::abs(ours.moment)});
  }
  for (std::size_t d = 0; d < mechanism.drivers.size(); ++d) {
    const double effort = motion.value(mechanism.drivers[d].name + ".effort", sample);
    found.add_driver(mechanism.drivers[d], effort);
    expected.add_driver(mechanism.drivers[d], solution.efforts[d]);
    if (solution.n_redundant_rows == 0) {
      EXPECT_NEAR(effort, solution.efforts[d], tolerance * scale);
    }
  }
  for (std::size_t b = 1; b < mechanism.bodies.size(); ++b) {
    const std::string& name = mechanism.bodies[b].name;
    const Feeling& ours = found.bodies()[b];
    const Feeling& theirs = expected.bodies()[b];
    EXPECT_NEAR(ours.force.x, theirs.force.x, tolerance * scale) << "joints of " << name;
    EXPECT_NEAR(ours.force.y, theirs.force.y, tolerance * scale) << "joints of " << name;
    EXPECT_NEAR(ours.moment, theirs.moment, tolerance * scale) << "joints of " << name;
  }
  if (solution.n_redundant_rows > 0) return;
  for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
    const oracle::TextbookReaction ours = read_reaction(motion, mechanism.joints[j], sample);
    EXPECT_LT(norm(ours.force - solution.reactions[j].force), tolerance * scale) << mechanism.joints[j].name;
    EXPECT_NEAR(ours.moment, solution.reactions[j].moment, tolerance * scale) << mechanism.joints[j].name;
  }
}

TextbookEnd integrate(const oracle::Textbook& textbook, const oracle::TextbookState& start, double from, double to) {
  constexpr int kFewest = 60;
  constexpr int kMost = 480;
  constexpr double kGood = 1e-7;  // [m, rad]
  const auto run = [&](int n) {
    oracle::TextbookState state = start;
    const double step = (to - from) / n;
    for (int i = 0; i < n; ++i) state = textbook.step_rk4(state, from + i * step, step);
    return state;
  };
  TextbookEnd end{run(kFewest), std::numeric_limits<double>::infinity()};
  for (int n = 2 * kFewest; n <= kMost && !(end.error <= kGood); n *= 2) {
    oracle::TextbookState finer = run(n);
    const double change = find_distance(end.state, finer);
    // Where a load bends, halving gains no more than two, and now and then nothing changes by chance.
    end.error = std::isfinite(end.error) ? std::max(change, 0.5 * end.error) : change;
    end.state = std::move(finer);
  }
  // What has come apart meanwhile, and where drivers would have it, is an error that halving may not show.
  end.error = std::max(end.error, textbook.eval_rows(end.state, to).residual.lpNorm<Eigen::Infinity>());
  return end;
}

double find_distance(const oracle::TextbookState& a, const oracle::TextbookState& b) {
  double distance = 0.0;
  for (std::size_t i = 1; i < a.bodies.size(); ++i) {
    const double moved = norm(a.bodies[i].center - b.bodies[i].center);
    const double turned = std::abs(a.bodies[i].angle - b.bodies[i].angle);
    if (!std::isfinite(moved + turned)) return std::numeric_limits<double>::infinity();
    distance = std::max({distance, moved, turned});
  }
  return distance;
}

}  // namespace gudgeon::random
