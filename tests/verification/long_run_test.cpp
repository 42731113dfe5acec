// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Four hundred cycles of the nine-bar press; scripts/long_checks.sh goes on to ten thousand.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "gudgeon/io/model_reader.h"
#include "gudgeon/sim/motion_integrator.h"

namespace gudgeon {
namespace {

struct LongRun {
  double tolerance;
  bool is_worn;
};

std::string name_run(const testing::TestParamInfo<LongRun>& info) {
  return std::string(info.param.is_worn ? "Worn" : "New") + (info.param.tolerance < 1e-5 ? "Default" : "Loose");
}

class NineBarLife : public testing::TestWithParam<LongRun> {};

TEST_P(NineBarLife, GoesThrough) {
#ifdef GUDGEON_SANITIZE
  constexpr int kCycles = 10;
#else
  constexpr int kCycles = 400;
#endif
  ModelFile model = read_model(std::string(GUDGEON_SOURCE_DIR) + "/examples/nine_bar/nine_bar.toml");
  ASSERT_FALSE(model.diagnostics.has_errors());
  model.study.relative_tolerance = GetParam().tolerance;
  const Assembly assembly = assemble(model.mechanism);
  System system = compile(model.mechanism, assembly);
  if (GetParam().is_worn) {
    // Uneven all around, by a tenth of the clearance.
    std::vector<double> depths(1000);
    for (std::size_t k = 0; k < depths.size(); ++k) {
      depths[k] = 2.5e-5 * (1.0 + std::sin(0.05 * static_cast<double>(k)));
    }
    for (std::size_t k = 0; k < 2; ++k) set_surfaces(system, k, depths, depths);
  }
  MotionIntegrator integrator(system, model.study, 1.0);
  ASSERT_TRUE(integrator.begin(make_state(system, assembly)));
  while (integrator.time() < kCycles) {
    ASSERT_TRUE(integrator.advance(kCycles)) << "at " << integrator.time();
    for (std::size_t k = 0; k < integrator.gaps().size(); ++k) {
      // Angles and time are known to 1e-12 after hundreds of turns.
      if (integrator.equations().contact_modes[k].in_contact) continue;
      ASSERT_LE(integrator.gaps()[k].penetration, 1e-12) << "at " << integrator.time();
    }
  }
  EXPECT_GT(integrator.statistics().onsets, 50 * kCycles);
}

INSTANTIATE_TEST_SUITE_P(Tolerances, NineBarLife,
                         testing::Values(LongRun{1e-4, false}, LongRun{1e-6, false}, LongRun{1e-4, true},
                                         LongRun{1e-6, true}),
                         name_run);

}  // namespace
}  // namespace gudgeon
