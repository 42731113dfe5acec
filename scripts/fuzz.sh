#!/usr/bin/env bash
# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# fuzz.sh [SECONDS] [TARGET...]: builds the fuzzers with Clang in build-fuzz and runs each target for that time (60 s by
# default) from its corpus in tests/fuzz/corpus. Prints a line a target; inputs that broke one lie in
# build-fuzz/found/TARGET. Fails when any did.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
seconds="${1:-60}"
shift $(($# > 0 ? 1 : 0))
targets=("$@")
((${#targets[@]})) || targets=(quantity formula model override run_file)

if ! command -v clang++ >/dev/null; then
  echo "fuzz.sh: not run: there is no clang++ (./setup.sh installs it)" >&2
  exit 77
fi
launcher=()
command -v ccache >/dev/null && launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
cmake -S . -B build-fuzz -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_C_COMPILER=clang -DCMAKE_BUILD_TYPE=Release \
  -DGUDGEON_FUZZ=ON "${launcher[@]}" >/dev/null
cmake --build build-fuzz --target "${targets[@]/#/fuzz_}" >build-fuzz/build.log || { tail -40 build-fuzz/build.log; exit 1; }

# What the targets start from beside their corpus.
declare -A seeds=([model]="tests/cases examples" [run_file]="build-fuzz/seed")
if [[ " ${targets[*]} " == *" run_file "* ]]; then
  program="${GUDGEON_PROGRAM:-build/gudgeon}"
  [[ -x "$program" ]] || { echo "fuzz.sh: $program is not built; it makes the run file to start from" >&2; exit 1; }
  "$program" run tests/app/slider_crank.toml --quiet --overwrite -o build-fuzz/seed --set study.cycles=1 \
    --set study.outputs_per_cycle=5 --set study.compare_ideal=false --set study.cells=10 >/dev/null
fi

export ASAN_OPTIONS="${ASAN_OPTIONS:-detect_leaks=0:allocator_may_return_null=1}"
broken=0
for target in "${targets[@]}"; do
  corpus="build-fuzz/corpus/$target"
  found="build-fuzz/found/$target"
  log="build-fuzz/$target.log"
  mkdir -p "$corpus" "$found"
  from=()
  [[ -d "tests/fuzz/corpus/$target" ]] && from+=("tests/fuzz/corpus/$target")
  # shellcheck disable=SC2206
  from+=(${seeds[$target]:-})
  length=20000
  [[ "$target" == run_file ]] && length=400000
  if build-fuzz/"fuzz_$target" -max_total_time="$seconds" -max_len="$length" -timeout=20 -rss_limit_mb=4096 \
    -artifact_prefix="$found/" -print_final_stats=1 "$corpus" "${from[@]}" >"$log" 2>&1; then
    result="nothing found"
  else
    result="BROKEN, see $log and $found"
    broken=1
  fi
  n_inputs="$(sed -n 's/^stat::number_of_executed_units: *//p' "$log" | tail -1)"
  printf '%-10s %10s inputs in %s s: %s\n' "$target" "${n_inputs:-?}" "$seconds" "$result"
done
exit "$broken"
