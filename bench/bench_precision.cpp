// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Work and precision: every method of every case at every tolerance, as CSV. Errors are against the engine at its
// tightest over the short horizon; the residual and the time are those of the whole horizon.
//   bench_precision [--quick] [case ...]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <vector>

#include "bench/run_cases.h"

namespace gudgeon::bench {
namespace {

constexpr double kTightest = 1e-12;
// A ladder ends where a rung has taken this long [s].
constexpr double kMostSeconds = 20.0;

void climb(const RunCase& at, const Method& method, const Outcome& reference, bool quick) {
  for (double tolerance = 1e-3; tolerance > (quick ? 0.5e-3 : 0.5e-10); tolerance *= 0.1) {
    const Outcome near = method.run(tolerance, at.short_horizon);
    const Outcome whole = quick ? near : method.run(tolerance, at.horizon);
    std::printf("%s,%s,%.0e,%.4g,%.4g,%ld,%.6g\n", at.name.c_str(), method.name.c_str(), tolerance,
                find_error(near, reference), whole.finished ? whole.residual.value_or(std::nan("")) : INFINITY,
                whole.evaluations, whole.finished ? whole.seconds : INFINITY);
    std::fflush(stdout);
    if (whole.seconds > kMostSeconds) break;
  }
}

}  // namespace
}  // namespace gudgeon::bench

int main(int argc, char** argv) {
  using namespace gudgeon::bench;
  bool quick = false;
  std::vector<std::string_view> wanted;
  for (int k = 1; k < argc; ++k) {
    if (std::string_view(argv[k]) == "--quick") {
      quick = true;
    } else {
      wanted.emplace_back(argv[k]);
    }
  }
  std::printf("case,method,tolerance,error,residual_J,evaluations,seconds\n");
  for (const RunCase& at : make_run_cases()) {
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), at.name) == wanted.end()) continue;
    const std::vector<Method> methods = make_methods(at);
    const Outcome reference = methods.front().run(quick ? 1e-8 : kTightest, at.short_horizon);
    for (const Method& method : methods) climb(at, method, reference, quick);
  }
}
