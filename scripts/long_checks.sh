#!/usr/bin/env bash
# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# Checks that take too long for every change: scripts/long_checks.sh [PROGRAM] [CHECK...], the Release build's program
# by default. Prints the date and what came out; the exit code is the number of checks that failed. Without names all
# checks run, which takes a night. GUDGEON_FUZZ_MINUTES sets the minutes a target is fuzzed (60 by default).
set -u
cd "$(dirname "$0")/.." || exit 100
program=build/gudgeon
if [ $# -gt 0 ] && [ -x "$1" ] && [ -f "$1" ]; then
  program=$1
  shift
fi
runs=$(mktemp -d)
trap 'rm -rf "$runs"' EXIT
failed=0

# note NAME COMMAND...: runs a check and prints what it says, or what went wrong; 77 says that it could not run.
note() {
  local name=$1
  shift
  local start=$SECONDS
  "$@" > "$runs/said" 2>&1
  local code=$?
  if [ $code -eq 0 ] || [ $code -eq 77 ]; then
    local result=passed
    [ $code -eq 0 ] || result='not run'
    printf '%s  %-7s %-24s %5d s  %s\n' "$(date -u +%FT%TZ)" "$result" "$name" $((SECONDS - start)) \
      "$(tail -1 "$runs/said")"
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
    --set study.relative_tolerance="$1" --set study.cycles=10000 --set study.wear_acceleration=8 \
    --set study.wear_stages=1 --set study.compare_ideal=false --set study.outputs_per_cycle=1 > "$runs/summary"
  local code=$?
  [ $code -eq 0 ] || [ $code -eq 6 ] || { cat "$runs/summary"; return 1; }
  [ "$(grep -cE '^ +(no_wear|wear_1) +finished +10 ?000 ' "$runs/summary")" -eq 2 ] || { cat "$runs/summary"; return 1; }
  grep -E '^ +(wear_1 +finished|residual|balanced) ' "$runs/summary" | tr -s ' ' | paste -sd ';'
}

nine_bar_life_1e-4() { nine_bar_life 1e-4; }
nine_bar_life_1e-6() { nine_bar_life 1e-6; }

# A thousand mechanisms of each random family; the tests stand beside the program.
random_mechanisms() { GUDGEON_RANDOM_SEEDS=1000 "$(dirname "$program")/random_tests" --gtest_brief=1; }

# Hours of libFuzzer from the corpora of tests/fuzz.
fuzzing() {
  bash scripts/fuzz.sh $((60 * ${GUDGEON_FUZZ_MINUTES:-60})) > "$runs/fuzzed" 2>&1
  local code=$?
  [ $code -eq 0 ] || { cat "$runs/fuzzed"; return $code; }
  tr -s ' ' < "$runs/fuzzed" | paste -sd ';'
}

# Every tool of the guide's page on reading results reads a run file, as far as Debian has it.
outside_tools() {
  bash setup.sh --all || return 1
  bash tests/outside/tools.sh "$(realpath "$program")" "$PWD/examples/slider_crank_clearance.toml" > "$runs/read"
  local code=$?
  [ $code -eq 0 ] || { cat "$runs/read"; return $code; }
  paste -sd ';' "$runs/read"
}

# build_apart FOLDER TARGETS OPTION...: a build of its own, through the compiler cache where there is one.
build_apart() {
  local folder=$1 targets=$2
  shift 2
  command -v ccache > /dev/null && set -- "$@" -DCMAKE_CXX_COMPILER_LAUNCHER=ccache
  bash scripts/build.sh "$folder" "$targets" -DGUDGEON_WERROR=ON "$@"
}

# count_passed FOLDER CTEST_OPTION...: runs tests of a build and prints how many of them passed.
count_passed() {
  local folder=$1
  shift
  ctest --test-dir "$folder" --no-tests=error --output-on-failure -j2 "$@" > "$runs/tested" 2>&1 ||
    { grep -vE 'Passed|^ +Start ' "$runs/tested"; return 1; }
  grep -E 'tests passed' "$runs/tested"
}

# The tests that run several threads, in this process or in the program, under ThreadSanitizer. A program in which it
# finds something ends with 66; what it found is in build-tsan/races.*.
thread_sanitizer() {
  rm -f build-tsan/races.*
  CC=clang CXX=clang++ build_apart build-tsan "gudgeon sim_tests io_tests app_tests" -DCMAKE_BUILD_TYPE=Debug \
    '-DCMAKE_CXX_FLAGS_DEBUG=-O1 -g1' -DCMAKE_CXX_FLAGS=-fsanitize=thread \
    -DCMAKE_EXE_LINKER_FLAGS=-Wl,--allow-multiple-definition || return 1  # a test has an operator new of its own
  local -x TSAN_OPTIONS="exitcode=66 log_path=$PWD/build-tsan/races"
  if build-tsan/sim_tests --gtest_brief=1 --gtest_filter='CaseTurns*' &&
    build-tsan/io_tests --gtest_brief=1 --gtest_filter='RunWriter.SeveralThreads*' &&
    build-tsan/app_tests --gtest_brief=1 --gtest_filter='RunCommand*:ManyCases*:RunLock*:CheckpointRun*:Signals*'; then
    return
  fi
  cat build-tsan/races.* 2> /dev/null
  return 1
}

# Other levels of optimization than the released one, and the other compiler at that: the same answers. The verification
# tests hold the engine against closed forms and published numbers.
optimization_levels() {
  try_level g++ O1 && try_level g++ O2 && try_level clang++ O3 && paste -sd ';' "$runs/levels"
}
try_level() {
  local folder="build-$1-$2" core="base geometry model laws system oracle sim io verification"
  CXX=$1 build_apart "$folder" "gudgeon ${core// /_tests }_tests" -DCMAKE_BUILD_TYPE=Release \
    "-DCMAKE_CXX_FLAGS_RELEASE=-$2 -DNDEBUG" || return 1
  local passed
  passed=$(count_passed "$folder" -L "^(${core// /|})\$" -E '/book$') || { echo "$1 -$2: $passed"; return 1; }
  echo "$1 -$2: $passed" >> "$runs/levels"
}

# Lines of src/ that the test programs run, those of the program that they start among them.
coverage() {
  command -v llvm-profdata > /dev/null || { echo "there is no llvm-profdata (Debian: llvm)"; return 77; }
  local folder=build-coverage name objects=()
  CC=clang CXX=clang++ build_apart $folder all -DCMAKE_BUILD_TYPE=Debug '-DCMAKE_CXX_FLAGS_DEBUG=-O1' \
    '-DCMAKE_CXX_FLAGS=-fprofile-instr-generate -fcoverage-mapping' || return 1
  rm -rf $folder/profiles
  LLVM_PROFILE_FILE="$PWD/$folder/profiles/%4m.profraw" count_passed $folder -E '^(web|outside|architecture|package)/|/book$' ||
    return 1
  llvm-profdata merge -sparse $folder/profiles/*.profraw -o $folder/all.profdata || return 1
  for name in $folder/*_tests; do objects+=(-object "$name"); done
  llvm-cov report $folder/gudgeon "${objects[@]}" -instr-profile $folder/all.profdata src > $folder/coverage.txt ||
    return 1
  awk '/^TOTAL/ {printf "%s of %d lines of src/ run\n", $10, $8}' $folder/coverage.txt
}

checks=("$@")
[ $# -gt 0 ] || checks=(nine_bar_life_1e-4 nine_bar_life_1e-6 random_mechanisms outside_tools thread_sanitizer
  optimization_levels coverage fuzzing)
for check in "${checks[@]}"; do
  [ "$(type -t "$check")" = function ] || { echo "long_checks.sh: there is no check '$check'" >&2; exit 100; }
done
echo "long checks of $("$program" --version) on $(date -u +%F)"
for check in "${checks[@]}"; do note "$check" "$check"; done
exit "$failed"
