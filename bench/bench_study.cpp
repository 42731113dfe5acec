// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The paper's whole programme and what surrounds the equations in it, as CSV: what,case,value,unit.
//   bench_study [--cycles N] [programme | integrator | recording | share | bristles | memory ...]
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "bench/study_parts.h"

int main(int argc, char** argv) {
  using namespace gudgeon::bench;
  const std::map<std::string, std::function<void(int)>> parts{
      {"programme", measure_programme}, {"integrator", measure_integrator}, {"recording", measure_recording},
      {"share", measure_share},         {"bristles", measure_bristles},     {"memory", measure_memory}};
  int cycles = 100;
  std::vector<std::string> wanted;
  for (int k = 1; k < argc; ++k) {
    if (std::strcmp(argv[k], "--cycles") == 0 && k + 1 < argc) {
      cycles = std::atoi(argv[++k]);
    } else if (parts.contains(argv[k])) {
      wanted.emplace_back(argv[k]);
    } else {
      std::fprintf(stderr, "bench_study: unknown word '%s'\n", argv[k]);
      return 2;
    }
  }
  if (wanted.empty()) wanted = {"memory", "recording", "share", "bristles", "programme"};
  std::printf("what,case,value,unit\n");
  for (const std::string& part : wanted) parts.at(part)(cycles);
}
