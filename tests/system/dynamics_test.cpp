// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The engine against the textbook form: accelerations, efforts, reactions and energies on random consistent states.
// Beside singular positions, where dense solves lose digits too, against a closed form.
#include "gudgeon/system/dynamics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "gudgeon/system/body_motion.h"
#include "gudgeon/system/load_forces.h"
#include "gudgeon/system/poses.h"
#include "gudgeon/system/reactions.h"
#include "tests/oracle/mechanisms.h"
#include "tests/oracle/textbook.h"

namespace gudgeon {
namespace {

// Relative difference that rounding of a well-conditioned dense solve explains.
constexpr double kDynamicsTolerance = 1e-9;

class RandomStates {
 public:
  explicit RandomStates(const Mechanism& mechanism)
      : system(compile(mechanism, assemble(mechanism))),
        workspace(system.tables),
        start_(make_state(system, assemble(mechanism))),
        contact_modes(system.tables.contacts.size(), ContactMode{true, 0.07}) {}

  // A state near the start on which all closures hold to rounding; empty when the draw cannot be closed.
  std::optional<State> draw(double time, double spread) {
    State state = start_;
    for (double& q : state.q) q += spread * uniform_(random_);
    for (double& v : state.v) v += 3.0 * uniform_(random_);
    const std::vector<ContactMode> open(contact_modes.size());
    std::vector<double> correction(state.q.size());
    const auto n_free = static_cast<std::size_t>(system.tables.counts.n_free());
    for (int pass = 0; pass < 25; ++pass) {
      eval_dynamics(system.tables, time, state.q.data(), state.v.data(), open, {}, workspace);
      const auto gap = workspace.closure_gap;
      find_correction(system.tables, gap, workspace, correction.data());
      for (std::size_t k = 0; k < n_free; ++k) state.q[k] += correction[k];
    }
    eval_dynamics(system.tables, time, state.q.data(), state.v.data(), open, {}, workspace);
    const auto rate = workspace.closure_rate;
    find_correction(system.tables, rate, workspace, correction.data());
    for (std::size_t k = 0; k < n_free; ++k) state.v[k] += correction[k];
    eval_dynamics(system.tables, time, state.q.data(), state.v.data(), contact_modes, {}, workspace);
    for (const Vec2 gap : workspace.closure_gap) {
      if (!(norm(gap) < 1e-13)) return std::nullopt;
    }
    return state;
  }

  System system;
  Workspace workspace;

 private:
  State start_;
  std::mt19937 random_{20260101};
  std::uniform_real_distribution<double> uniform_{-1.0, 1.0};

 public:
  std::vector<ContactMode> contact_modes;
};

oracle::TextbookState make_textbook_state(const RandomStates& states, const oracle::Textbook& textbook) {
  oracle::TextbookState state = textbook.make_state();
  const auto poses = find_poses(states.system.mechanism, states.system.topology, states.workspace.coordinates);
  for (std::size_t b = 1; b < poses.size(); ++b) {
    state.bodies[b] =
        textbook.place(static_cast<int>(b), poses[b].position, poses[b].angle, poses[b].velocity, poses[b].angle_rate);
  }
  for (auto& contact : state.contacts) contact = {true, 0.07};
  return state;
}

bool has_clearance(const Mechanism& mechanism) {
  return std::ranges::any_of(mechanism.joints, [](const Joint& j) { return gudgeon::has_clearance(j.kind); });
}

class EngineAgainstTextbook : public testing::TestWithParam<Mechanism> {
 protected:
  // Calls check(workspace, motions, solution, textbook state) on random states.
  template <class Check>
  void for_random_states(Check&& check) {
    const Mechanism& mechanism = GetParam();
    RandomStates states(mechanism);
    const oracle::Textbook textbook(mechanism);
    BodyMotionFinder finder(states.system);
    int n_checked = 0;
    for (int draw = 0; draw < 20; ++draw) {
      const double time = 0.013 * draw;
      if (!states.draw(time, has_clearance(mechanism) ? 2e-3 : 0.2)) continue;
      const auto state = make_textbook_state(states, textbook);
      const auto rows = textbook.eval_rows(state, time);
      ASSERT_LT(rows.residual.lpNorm<Eigen::Infinity>(), 1e-12);
      ASSERT_LT(rows.rate.lpNorm<Eigen::Infinity>(), 1e-9);
      check(states, finder.update(states.workspace), textbook.solve(state, time), textbook.eval_energy(state));
      ++n_checked;
    }
    EXPECT_GE(n_checked, 8) << mechanism.name;
  }
};

TEST_P(EngineAgainstTextbook, AccelerationsAgree) {
  for_random_states([](const RandomStates& states, const std::vector<BodyMotion>& motions,
                       const oracle::TextbookSolution& solution, const oracle::TextbookEnergy&) {
    double scale = 0.0;
    for (const auto& a : solution.accelerations) scale = std::max({scale, norm(a.center), std::abs(a.angle)});
    for (std::size_t b = 0; b < motions.size(); ++b) {
      const auto& expected = solution.accelerations[b];
      const std::string& name = states.system.mechanism.bodies[b].name;
      EXPECT_NEAR(motions[b].acceleration.x, expected.center.x, kDynamicsTolerance * scale) << name;
      EXPECT_NEAR(motions[b].acceleration.y, expected.center.y, kDynamicsTolerance * scale) << name;
      EXPECT_NEAR(motions[b].angle_acceleration, expected.angle, kDynamicsTolerance * scale) << name;
    }
  });
}

TEST_P(EngineAgainstTextbook, EffortsAndReactionsAgree) {
  std::unique_ptr<ReactionFinder> finder;
  for_random_states([&](const RandomStates& states, const std::vector<BodyMotion>& motions,
                        const oracle::TextbookSolution& solution, const oracle::TextbookEnergy&) {
    if (solution.n_redundant_rows > 0) return;  // reactions are not unique
    if (!finder) finder = std::make_unique<ReactionFinder>(states.system);
    const auto& reactions = finder->update(states.workspace, motions);
    double scale = 1e-3;
    for (const auto& r : solution.reactions) scale = std::max({scale, norm(r.force), std::abs(r.moment)});
    for (std::size_t j = 0; j < reactions.size(); ++j) {
      const std::string& name = states.system.mechanism.joints[j].name;
      EXPECT_NEAR(reactions[j].force.x, solution.reactions[j].force.x, kDynamicsTolerance * scale) << name;
      EXPECT_NEAR(reactions[j].force.y, solution.reactions[j].force.y, kDynamicsTolerance * scale) << name;
      EXPECT_NEAR(reactions[j].moment, solution.reactions[j].moment, kDynamicsTolerance * scale) << name;
    }
    const auto& counts = states.system.tables.counts;
    for (int d = 0; d < counts.n_driven(); ++d) {
      const double expected = solution.efforts[states.system.tables.driven[d].driver];
      EXPECT_NEAR(states.workspace.effort[d], expected, kDynamicsTolerance * scale);
      if (d < counts.n_driven_turns) {
        EXPECT_NEAR(finder->root_moments()[counts.n_free_turns + d], expected, kDynamicsTolerance * scale);
      }
    }
    for (int turn = 0; turn < counts.n_free_turns; ++turn) {
      EXPECT_NEAR(finder->root_moments()[turn], 0.0, kDynamicsTolerance * scale) << "moment left over on a free turn";
    }
  });
}

TEST_P(EngineAgainstTextbook, EnergiesAgree) {
  std::optional<double> datum;
  for_random_states([&](const RandomStates& states, const std::vector<BodyMotion>& motions,
                        const oracle::TextbookSolution&, const oracle::TextbookEnergy& expected) {
    const double kinetic = find_kinetic_energy(states.system.mechanism, motions);
    const double potential = find_potential_energy(states.system.tables, states.workspace);
    EXPECT_NEAR(kinetic, expected.kinetic, kDynamicsTolerance * (1.0 + expected.kinetic));
    const double by_tables = find_kinetic_energy(states.system.tables, states.workspace.coordinates);
    EXPECT_NEAR(by_tables, expected.kinetic, kDynamicsTolerance * (1.0 + expected.kinetic));
    // Potential energies may differ by a constant.
    if (!datum) datum = potential - expected.potential;
    EXPECT_NEAR(potential - *datum, expected.potential, kDynamicsTolerance * (1.0 + std::abs(expected.potential)));
    EXPECT_NEAR(find_elastic_energy(states.workspace), expected.elastic, kDynamicsTolerance * (1.0 + expected.elastic));
  });
}

TEST_P(EngineAgainstTextbook, LoadPowersAgree) {
  for_random_states([](const RandomStates& states, const std::vector<BodyMotion>&,
                       const oracle::TextbookSolution& solution, const oracle::TextbookEnergy&) {
    const LoadScratch& loads = states.workspace.loads;
    const double scale = 1.0 + std::abs(solution.loads.work_power) + solution.loads.damper_power;
    EXPECT_NEAR(loads.work_power, solution.loads.work_power, kDynamicsTolerance * scale);
    EXPECT_NEAR(loads.damper_power, solution.loads.damper_power, kDynamicsTolerance * scale);
    EXPECT_NEAR(find_spring_energy(states.workspace), solution.loads.stored_energy,
                kDynamicsTolerance * (1.0 + solution.loads.stored_energy));
  });
}

std::string find_name(const testing::TestParamInfo<Mechanism>& entry) {
  return entry.param.name + "_" + std::to_string(entry.index);
}

INSTANTIATE_TEST_SUITE_P(AllMechanisms, EngineAgainstTextbook, testing::ValuesIn(oracle::make_all_mechanisms()),
                         find_name);
INSTANTIATE_TEST_SUITE_P(LoadedMechanisms, EngineAgainstTextbook, testing::ValuesIn(oracle::make_loaded_mechanisms()),
                         find_name);

// Contact by contact, whatever the sums are; slots must have been touched on every side.
TEST(EngineAgainstTextbookContacts, EachForceAgrees) {
  for (const Mechanism& mechanism : oracle::make_all_mechanisms()) {
    if (!has_clearance(mechanism)) continue;
    RandomStates states(mechanism);
    const oracle::Textbook textbook(mechanism);
    std::vector<int> touched(states.contact_modes.size());
    for (int draw = 0; draw < 60; ++draw) {
      if (!states.draw(0.0, 2e-3)) continue;
      const auto expected = textbook.eval_contacts(make_textbook_state(states, textbook));
      ASSERT_EQ(expected.size(), states.workspace.contact_forces.size());
      for (std::size_t k = 0; k < expected.size(); ++k) {
        const ContactForces& forces = states.workspace.contact_forces[k];
        const double scale = std::max(expected[k].normal_force, 1.0);
        EXPECT_NEAR(forces.gap.penetration, expected[k].penetration, 1e-14) << mechanism.name;  // lengths of 1 m
        EXPECT_NEAR(forces.normal_force, expected[k].normal_force, kDynamicsTolerance * scale) << mechanism.name;
        EXPECT_NEAR(norm(forces.force_on_journal - expected[k].force), 0.0, kDynamicsTolerance * scale)
            << mechanism.name;
        EXPECT_NEAR(forces.gap.penetration_rate, expected[k].penetration_rate, 1e-12) << mechanism.name;
        touched[k] += forces.normal_force > 0.0 ? 1 : 0;
      }
    }
    for (const int n : touched) EXPECT_GE(n, 3) << mechanism.name;
  }
}

// Posts and beams of one length and mass: n + 1 posts turn alike by θ and n beams stay level, so Lagrange's equation is
// that of one pendulum, ((n + 1)/3 + n) l θ̈ = -((n + 1)/2 + n) g cos θ, with nothing special at θ = 0. There all lie on
// one line, and each loop could as well fold. The line is oblique: rounding does not cancel then.
TEST(Dynamics, AccelerationsBesideASingularPositionKeepTheirDigits) {
  constexpr int kLoops = 40;
  constexpr double kTilt = 0.7;  // [rad]
  Mechanism mechanism = oracle::make_n_four_bar(kLoops);
  const double gravity = norm(mechanism.gravity);
  mechanism.gravity = gravity * Vec2{std::sin(kTilt), -std::cos(kTilt)};
  for (Point& foot : mechanism.bodies[0].points) {
    foot.position = foot.position.x * Vec2{std::cos(kTilt), std::sin(kTilt)};
  }
  for (Body& body : mechanism.bodies) {
    if (body.start.angle) *body.start.angle += kTilt;
  }
  const Assembly assembly = assemble(mechanism);
  const System system = compile(mechanism, assembly);
  const State start = make_state(system, assembly);
  Workspace workspace(system.tables);
  BodyMotionFinder finder(system);
  for (const double distance : {1e-3, 1e-4, 1e-5}) {
    State state = start;
    for (std::size_t k = 0; k < state.q.size(); ++k) {
      const bool is_post = start.q[k] > 1.0 + kTilt;  // [rad] posts start upright
      state.q[k] = kTilt + (is_post ? distance : 0.0);
      state.v[k] = is_post ? -1.0 : 0.0;
    }
    eval_dynamics(system.tables, 0.0, state.q.data(), state.v.data(), {}, {}, workspace);
    const double expected =
        -gravity * std::cos(distance) * ((kLoops + 1) / 2.0 + kLoops) / ((kLoops + 1) / 3.0 + kLoops);
    const std::vector<BodyMotion>& motions = finder.update(workspace);
    // Rounding of the closures' accelerations, 40 loops of 11 m/s², is magnified by the inverse of the distance.
    const double tolerance = 1e-13 / distance;
    for (std::size_t b = 1; b < motions.size(); ++b) {
      const bool is_post = mechanism.bodies[b].name.starts_with("post");
      EXPECT_NEAR(motions[b].angle_acceleration, is_post ? expected : 0.0, tolerance)
          << mechanism.bodies[b].name << " at " << distance;
    }
  }
}

}  // namespace
}  // namespace gudgeon
