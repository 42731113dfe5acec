#!/usr/bin/env bash
# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# Builds the benchmarks and prints one CSV with compiler, flags and commit ahead of it:
#   bash bench/run.sh > bench/baselines/NAME.csv
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

bash setup.sh >&2
bash scripts/build.sh build-bench all -DCMAKE_BUILD_TYPE=Release -DGUDGEON_BUILD_TESTS=OFF -DGUDGEON_BUILD_BENCH=ON >&2
echo "# $(c++ --version | head -n 1); Release; commit $(git rev-parse --short HEAD 2>/dev/null || echo unknown)"
for program in bench_eval bench_run; do
  build-bench/$program --benchmark_format=csv --benchmark_min_time=0.5 2>/dev/null
done
