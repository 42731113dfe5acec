// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Errors against step and tolerance: the order of the integrator, and what impacts do to it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gudgeon/sim/run_study.h"
#include "tests/oracle/mechanisms.h"
#include "tests/verification/book/recorder.h"

namespace gudgeon {
namespace {

StageRecord run_for(const Mechanism& mechanism, double duration, double tolerance, double max_step = 0.0) {
  Study study;
  study.cycle_time = duration;
  study.cycles = 1;
  study.outputs_per_cycle = 10;
  study.compare_ideal = false;
  study.relative_tolerance = tolerance;
  study.absolute_tolerance = 1e-2 * tolerance;
  study.max_step = max_step;
  auto stages = run_study(mechanism, study);
  EXPECT_EQ(stages.back().status, StageStatus::finished) << stages.back().message;
  return stages.back();
}

double find_last(const StageRecord& stage, const std::string& channel) { return find_values(stage, channel)->back(); }

TEST(Convergence, OrderOfTheIntegrator) {
  book::Recorder recorder(
      {"Convergence", "Order of the integrator", "Tsitouras 2011: order 5",
       "Equal steps h, h/2 … on a pendulum swinging through 5 s; the order is "
       "log₂(error(h)/error(h/2)), the error being that of its angle against a run at a tolerance of 1e-13.",
       "the next term of the error series changes the measured order by about h"});
  const Mechanism mechanism = oracle::make_point_mass_pendulum();
  // [s] The pair's leading error is so small that after one second the next term is as large.
  constexpr double kSwinging = 5.0;
  const double exact = find_last(run_for(mechanism, kSwinging, 1e-13), "bar.angle");
  // With a tolerance of one the steps are as long as they are allowed to be.
  double before = 0.0;
  for (const double step : {40e-3, 20e-3, 10e-3}) {
    const double error = std::abs(find_last(run_for(mechanism, kSwinging, 1.0, step), "bar.angle") - exact);
    if (before > 0.0) {
      recorder.verify(fmt::format("order between steps of {:g} and {:g} ms", 2e3 * step, 1e3 * step), 5.0,
                      std::log2(before / error), 0.5);
    }
    before = error;
  }
}

TEST(Convergence, NineBarThroughItsFirstImpacts) {
  book::Recorder recorder(
      {"Convergence", "Nine-bar press: error against tolerance", "a run at a relative tolerance of 1e-12",
       "Error of the slider's position after the impacts of the first 0.1 s. Each impact multiplies "
       "the errors that are there; the tolerance still rules them.",
       "a hundred times the tolerance: the impacts' share"});
  const Mechanism press = oracle::make_nine_bar();
  const StageRecord whole = run_for(press, 0.1, 1e-12);
  for (const auto& [tolerance, bound] : {std::pair{1e-8, 1e-6}, {1e-9, 1e-7}, {1e-10, 1e-8}}) {
    const double error =
        std::abs(find_last(run_for(press, 0.1, tolerance), "slider_9.x") - find_last(whole, "slider_9.x"));
    recorder.verify(fmt::format("error after {} impacts at tolerance {:.0e} [m]", whole.solver.onsets, tolerance), 0.0,
                    error, bound);
  }
}

}  // namespace
}  // namespace gudgeon
