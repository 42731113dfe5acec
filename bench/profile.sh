#!/usr/bin/env bash
# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# Where a run of the nine-bar spends its time, by function: perf where it is allowed to count, callgrind elsewhere.
# The benchmarks must have been built: bash bench/run.sh eval
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

work=(build-bench/bench_study --cycles 1 integrator)
scratch="$(mktemp -d)"
trap 'rm -rf "$scratch"' EXIT
if command -v perf >/dev/null && perf record --output "$scratch/perf.data" "${work[@]}" >/dev/null 2>&1; then
  perf report --input "$scratch/perf.data" --stdio --percent-limit 0.5 2>/dev/null | grep -v '^#' |
    sed -E 's/\(gudgeon::find_contact_forces.*/ (a law of normal force)/; s/std::__do_visit<.*/(a visit of a law)/' | sed '/^$/d'
elif command -v valgrind >/dev/null; then
  valgrind --tool=callgrind --callgrind-out-file="$scratch/callgrind.out" "${work[@]}" >/dev/null 2>&1
  callgrind_annotate --threshold=95 "$scratch/callgrind.out"
else
  echo "profile.sh: neither perf nor valgrind can be used here" >&2
  exit 1
fi
