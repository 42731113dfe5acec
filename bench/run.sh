#!/usr/bin/env bash
# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# Builds the benchmarks and writes bench/baselines/NAME.csv, with processor, compiler, flags and commit ahead of each:
#   bash bench/run.sh [eval] [run] [precision] [study]     all of them unless some are named
# Then python3 bench/report/render.py brings the tables and figures of docs/performance.md up to date.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

names=("$@")
((${#names[@]})) || names=(eval run precision study)

bash setup.sh >&2
bash scripts/build.sh build-bench all -DCMAKE_BUILD_TYPE=Release -DGUDGEON_BUILD_TESTS=OFF -DGUDGEON_BUILD_BENCH=ON >&2

processor="$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1)"
flags="$(sed -n 's/^CMAKE_CXX_FLAGS_RELEASE:[^=]*=//p' build-bench/CMakeCache.txt)"
commit="$(git describe --always --dirty 2>/dev/null || echo unknown)"
for name in "${names[@]}"; do
  case "$name" in
    eval) command=(build-bench/bench_eval --benchmark_format=csv --benchmark_min_time=0.5) ;;
    run) command=(build-bench/bench_run --benchmark_format=csv) ;;
    precision | study) command=("build-bench/bench_$name") ;;
    *)
      echo "run.sh: no benchmark is called '$name': eval, run, precision, study" >&2
      exit 2
      ;;
  esac
  echo "Measuring $name" >&2
  {
    echo "# ${processor:-unknown processor}; $(c++ --version | head -n 1); $flags; commit $commit"
    "${command[@]}" 2>/dev/null
  } >"bench/baselines/$name.csv"
done
