#!/usr/bin/env bash
# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# Checks that take too long for every change: scripts/long_checks.sh [PROGRAM] [CHECK...]. Prints the date and what came
# out; the exit code is the number of checks that failed. Without names all checks run.
set -u
cd "$(dirname "$0")/.."
program=${1:-build/gudgeon}
[ $# -gt 0 ] && shift
runs=$(mktemp -d)
trap 'rm -rf "$runs"' EXIT
failed=0

# note NAME COMMAND...: runs a check and prints what it says, or what went wrong.
note() {
  local name=$1
  shift
  local start=$SECONDS
  if "$@" > "$runs/said" 2>&1; then
    printf '%s  passed  %-24s %5d s  %s\n' "$(date -u +%FT%TZ)" "$name" $((SECONDS - start)) "$(tail -1 "$runs/said")"
  else
    printf '%s  FAILED  %-24s %5d s\n' "$(date -u +%FT%TZ)" "$name" $((SECONDS - start))
    tail -20 "$runs/said"
    failed=$((failed + 1))
  fi
}

# A life of the nine-bar press: ten thousand cycles on new surfaces and ten thousand on worn ones. It must run through; a
# balance that does not close (exit code 6) is told with the rest.
nine_bar_life() {
  "$program" run examples/nine_bar/nine_bar.toml -o "$runs/life" --overwrite --threads 1 \
    --set study.relative_tolerance="$1" --set study.cycles=10000 --set study.magnification=8 \
    --set study.wear_stages=1 --set study.compare_ideal=false --set study.outputs_per_cycle=1 > "$runs/summary"
  local code=$?
  [ $code -eq 0 ] || [ $code -eq 6 ] || { cat "$runs/summary"; return 1; }
  [ "$(grep -cE '^ +(no_wear|wear_1) +finished +10 ?000 ' "$runs/summary")" -eq 2 ] || { cat "$runs/summary"; return 1; }
  grep -E '^ +(wear_1 +finished|residual|adds up) ' "$runs/summary" | tr -s ' ' | paste -sd ';'
}

nine_bar_life_1e-4() { nine_bar_life 1e-4; }
nine_bar_life_1e-6() { nine_bar_life 1e-6; }

# A thousand mechanisms of each random family; the tests stand beside the program.
random_mechanisms() { GUDGEON_RANDOM_SEEDS=1000 "$(dirname "$program")/random_tests" --gtest_brief=1; }

checks=("$@")
[ $# -gt 0 ] || checks=(nine_bar_life_1e-4 nine_bar_life_1e-6 random_mechanisms)
echo "long checks of $("$program" --version) on $(date -u +%F)"
for check in "${checks[@]}"; do note "$check" "$check"; done
exit "$failed"
