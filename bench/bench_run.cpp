// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Whole stages at default tolerance, recording included.
#include <benchmark/benchmark.h>

#include "gudgeon/sim/run_study.h"
#include "tests/oracle/mechanisms.h"

namespace gudgeon {
namespace {

void run_stage(benchmark::State& bench, const Mechanism& mechanism, int cycles) {
  Study study;
  study.cycles = cycles;
  study.compare_ideal = false;
  double evaluations = 0.0;
  for (auto _ : bench) {
    const auto stages = run_study(mechanism, study);
    if (stages.back().status != StageStatus::finished) bench.SkipWithError(stages.back().message.c_str());
    evaluations += static_cast<double>(stages.back().solver.evaluations);
  }
  bench.counters["evaluations/s"] = benchmark::Counter(evaluations, benchmark::Counter::kIsRate);
}

BENCHMARK_CAPTURE(run_stage, nine_bar_10_cycles, oracle::make_nine_bar(), 10)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(run_stage, slider_crank_20_turns, oracle::make_slider_crank_clearance(), 20)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(run_stage, n_four_bar_2_10_s, oracle::make_n_four_bar(2), 10)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gudgeon
