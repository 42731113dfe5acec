// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The cases.
#include "bench/run_cases.h"

#include "tests/oracle/mechanisms.h"

namespace gudgeon::bench {

namespace {

constexpr double kSliderTurn = 60.0 / 5000.0;  // [s]

RunCase make_slider_crank_case(double friction) {
  RunCase run{friction == 0.0 ? "slider_crank" : "slider_crank_friction", oracle::make_slider_crank_clearance()};
  for (Joint& joint : run.mechanism.joints) {
    auto* clearance = std::get_if<RevoluteClearance>(&joint.kind);
    if (clearance != nullptr && friction > 0.0) clearance->contact.friction = CoulombSmooth{friction, 1e-3};
  }
  run.cycle_time = kSliderTurn;
  run.short_horizon = 0.25 * kSliderTurn;
  run.horizon = 20.0 * kSliderTurn;
  run.probes = {{"rod", 2}, {"slider", 0}};
  run.wanted_error = 1e-5;
  run.wanted_residual = 1e-2;
  return run;
}

RunCase make_nine_bar_case() {
  RunCase run{"nine_bar", oracle::make_nine_bar()};
  run.short_horizon = 0.05;
  run.horizon = 10.0;
  run.probes = {{"rod_6"}, {"panel_7"}, {"rod_2"}, {"rod_3"}, {"rod_8"}};
  run.wanted_error = 1e-5;
  run.wanted_residual = 1e-2;
  return run;
}

RunCase make_n_four_bar_case(int n) {
  RunCase run{"n_four_bar_" + std::to_string(n), oracle::make_n_four_bar(n)};
  run.short_horizon = 1.0;
  run.horizon = 10.0;
  run.probes = {{"post_0"}};
  run.wanted_error = 1e-2;
  run.wanted_residual = 0.1;
  return run;
}

}  // namespace

std::vector<RunCase> make_run_cases() {
  std::vector<RunCase> cases{make_slider_crank_case(0.0), make_slider_crank_case(0.1), make_nine_bar_case()};
  for (const int n : {2, 10, 40, 100, 400}) cases.push_back(make_n_four_bar_case(n));
  return cases;
}

}  // namespace gudgeon::bench
