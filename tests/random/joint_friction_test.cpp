// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Mechanisms drawn from seeds, with friction in all of their ideal joints: what bodies lose is what joints took, or the
// joint that jams is named.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/results/energy_balance.h"
#include "gudgeon/sim/run_study.h"
#include "tests/random/random_mechanism.h"

namespace gudgeon::random {
namespace {

constexpr int kFrictionSeeds = 12;

AnyFriction draw_law(std::size_t k, bool bristles) {
  switch (k % 4) {
    case 0:
      return CoulombSmooth{0.1, 5e-3};
    case 1:
      return StribeckSmooth{.static_coefficient = 0.15, .kinetic_coefficient = 0.1};
    case 2:
      return CoulombRamp{0.08};
    default:
      break;
  }
  if (bristles) return Dahl{.kinetic_coefficient = 0.1, .bristle_stiffness = 1e4};
  return Threlfall{0.1, 1e-2};
}

void add_friction(Mechanism& mechanism) {
  for (std::size_t k = 0; k < mechanism.joints.size(); ++k) {
    AnyJoint& kind = mechanism.joints[k].kind;
    if (auto* pin = std::get_if<Revolute>(&kind)) pin->friction = JointFriction{draw_law(k, true), 0.01};
    if (auto* slot = std::get_if<PinInSlot>(&kind)) slot->friction = JointFriction{draw_law(k, false), 0.01};
    if (auto* guide = std::get_if<Prismatic>(&kind)) {
      guide->friction = JointFriction{draw_law(k, true), 0.0, k % 2 == 0 ? 0.0 : 0.5, k % 2 == 0 ? 0.0 : 0.05};
    }
  }
}

/// Whether it went to its end.
bool check_friction(Family family, std::uint64_t seed) {
  RandomModel model = make_model(family, seed);
  add_friction(model.mechanism);
  model.study.compare_ideal = true;
  model.study.wear_stages = 0;
  SCOPED_TRACE(fmt::format("{} {}", name_family(family), seed));
  try {
    const StageRecord stage = run_study(make_ideal(model.mechanism), model.study).front();
    if (stage.status != StageStatus::finished) {
      EXPECT_NE(stage.message.find("E-NUM-0"), std::string::npos) << stage.message;
      fmt::print("{} {} stops: {}\n", name_family(family), seed, stage.message);
      return false;
    }
    EXPECT_TRUE(is_balanced(stage.energy)) << stage.energy.residual() << " J of " << stage.energy.exchanged;
    EXPECT_GE(stage.energy.friction, 0.0);
    return true;
  } catch (const ModelError& error) {
    const std::string& code = error.diagnostics().items().front().code;
    EXPECT_TRUE(code == "E-MODEL-092" || code == "E-MODEL-093" || !model.can_move) << code;
    fmt::print("{} {} is refused: {}\n", name_family(family), seed, error.diagnostics().items().front().message);
  }
  return false;
}

class RandomFriction : public testing::TestWithParam<Family> {};

TEST_P(RandomFriction, IsAllThatMechanismsLose) {
  int n_finished = 0;
  for (int seed = 1; seed <= kFrictionSeeds; ++seed) {
    if (check_friction(GetParam(), static_cast<std::uint64_t>(seed))) ++n_finished;
  }
  EXPECT_GE(n_finished, kFrictionSeeds / 2);
}

INSTANTIATE_TEST_SUITE_P(Families, RandomFriction,
                         testing::Values(Family::trees, Family::loops, Family::driven, Family::loads),
                         [](const auto& entry) { return std::string(name_family(entry.param)); });

}  // namespace
}  // namespace gudgeon::random
