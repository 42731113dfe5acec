// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Whole simulations at equal achieved accuracy: every method takes the loosest tolerance with which its motion is as
// near to the reference over the short horizon, and its energy residual as small over the whole one, as the case wants;
// a method that does not know its energy takes none looser than gudgeon's. Then all run the whole horizon in turn.
// Columns: seconds, tolerance and time over gudgeon's for each method.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <optional>

#include "bench/run_cases.h"
#include "bench/spread_columns.h"

namespace gudgeon::bench {
namespace {

constexpr double kTightest = 1e-12;
constexpr double kLoosest = 1e-3;
constexpr double kRung = 0.31622776601683794;  // half a decade
constexpr int kRounds = 5;
constexpr std::array kMethods{"gudgeon",        "gudgeon_stiff", "textbook_pair",
                              "textbook_cvode", "sparse_pair",   "hand_written_pair"};

// The loosest tolerance that reaches what the case wants; none when no tolerance does. Without a residual it is at most
// the one given.
std::optional<double> find_tolerance(const RunCase& at, const Method& method, const Outcome& reference,
                                     double without_residual) {
  for (double tolerance = kLoosest; tolerance > kTightest; tolerance *= kRung) {
    if (find_error(method.run(tolerance, at.short_horizon), reference) > at.wanted_error) continue;
    const Outcome whole = method.run(tolerance, at.horizon);
    if (!whole.finished) continue;
    if (!whole.residual) return std::min(tolerance, without_residual);
    if (*whole.residual <= at.wanted_residual) return tolerance;
  }
  return std::nullopt;
}

void run(benchmark::State& bench, const RunCase& at) {
  const std::vector<Method> methods = make_methods(at);
  const Outcome reference = methods.front().run(kTightest, at.short_horizon);
  std::vector<Contestant> contestants;
  for (const char* name : kMethods) bench.counters[std::string(name) + ".tolerance"] = std::nan("");
  double engine_tolerance = kLoosest;
  for (const Method& method : methods) {
    const auto tolerance = find_tolerance(at, method, reference, engine_tolerance);
    if (!tolerance) continue;
    if (method.name == "gudgeon") engine_tolerance = *tolerance;
    bench.counters[method.name + ".tolerance"] = *tolerance;
    contestants.push_back({method.name, [&at, &method, tolerance](int n) {
                             double seconds = 0.0;
                             for (int i = 0; i < n; ++i) seconds += method.run(*tolerance, at.horizon).seconds;
                             return seconds;
                           }});
  }
  PairedRounds rounds(std::move(contestants), 0.0);
  for (auto _ : bench) bench.SetIterationTime(rounds.run());
  const auto base = rounds.find("gudgeon");
  for (const char* name : kMethods) {
    const auto k = rounds.find(name);
    bench.counters[std::string(name) + "_s"] = k ? rounds.find_time(*k).median : std::nan("");
    put_spread(bench, std::string(name) + "/gudgeon",
               k && base ? std::optional(rounds.find_ratio(*k, *base)) : std::nullopt);
  }
}

void add_all() {
  for (const RunCase& at : make_run_cases()) {
    benchmark::RegisterBenchmark(at.name.c_str(), [at](benchmark::State& bench) { run(bench, at); })
        ->UseManualTime()
        ->Iterations(kRounds)
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace
}  // namespace gudgeon::bench

int main(int argc, char** argv) {
  gudgeon::bench::add_all();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
}
