// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One right-hand side: the tables of absolute angles beside the dense textbook form in maximal coordinates.
#include <benchmark/benchmark.h>

#include "gudgeon/sim/motion_equations.h"
#include "tests/oracle/mechanisms.h"
#include "tests/oracle/textbook_start.h"

namespace gudgeon {
namespace {

void eval_tables(benchmark::State& bench, const Mechanism& mechanism, bool in_contact) {
  const Assembly assembly = assemble(mechanism);
  const System system = compile(mechanism, assembly);
  const State state = make_state(system, assembly);
  MotionEquations equations(system, {});
  std::vector<double> y(equations.size(), 0.0);
  std::ranges::copy(state.q, y.begin());
  std::ranges::copy(state.v, y.begin() + static_cast<std::ptrdiff_t>(equations.n_free()));
  // A milliradian pushes every journal well into its bearing.
  if (in_contact) y[0] += 5e-3, y[1] += 5e-3;
  for (ContactLatch& latch : equations.latches) latch = {in_contact, 0.05};
  std::vector<double> slope(equations.size());
  for (auto _ : bench) {
    equations.eval(0.0, y.data(), slope.data());
    benchmark::DoNotOptimize(slope.data());
  }
}

void eval_textbook(benchmark::State& bench, const Mechanism& mechanism, bool in_contact) {
  const oracle::Textbook textbook(mechanism);
  const oracle::TextbookState state =
      in_contact ? oracle::make_pressed_state(mechanism) : oracle::find_start(mechanism);
  for (auto _ : bench) benchmark::DoNotOptimize(textbook.solve(state, 0.0));
}

#define GUDGEON_BENCH_EVAL(name, mechanism, in_contact)        \
  BENCHMARK_CAPTURE(eval_tables, name, mechanism, in_contact); \
  BENCHMARK_CAPTURE(eval_textbook, name, mechanism, in_contact)

GUDGEON_BENCH_EVAL(slider_crank, oracle::make_slider_crank(), false);
GUDGEON_BENCH_EVAL(four_bar, oracle::make_four_bar(), false);
GUDGEON_BENCH_EVAL(pendulum_chain_5, oracle::make_pendulum_chain(5), false);
GUDGEON_BENCH_EVAL(nine_bar_flight, oracle::make_nine_bar(), false);
GUDGEON_BENCH_EVAL(nine_bar_contact, oracle::make_nine_bar(), true);
BENCHMARK_CAPTURE(eval_tables, n_four_bar_10, oracle::make_n_four_bar(10), false);
BENCHMARK_CAPTURE(eval_tables, n_four_bar_100, oracle::make_n_four_bar(100), false);

}  // namespace
}  // namespace gudgeon
