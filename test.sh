#!/usr/bin/env bash
# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# Set-up, the whole suite on a Release build, then once more under ASan and UBSan. Tells of each part how long it took and
# what docs/verification.md allows it.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")"

tell_time() {
  local minutes
  minutes="$(sed -n "s/^| $1 | \([0-9]*\) |\$/\1/p" docs/verification.md)"
  printf '%s: %d min %02d s of %s min\n' "$1" $((SECONDS / 60)) $((SECONDS % 60)) "${minutes:-?}"
  SECONDS=0
}

bash setup.sh
tell_time set-up
echo "Building into build/"
bash scripts/build.sh build all -DCMAKE_BUILD_TYPE=Release -DGUDGEON_BUILD_BENCH=ON -DGUDGEON_WERROR=ON
tell_time "Release build"
echo "Testing"
ctest --test-dir build --output-on-failure --progress -j2
tell_time tests

echo "Building into build-asan/ with sanitizers"
# Clang takes half as long as GCC for this, and warns of other things.
CC=clang CXX=clang++ bash scripts/build.sh build-asan "all all_verify_interface_header_sets" \
  -DCMAKE_BUILD_TYPE=Debug '-DCMAKE_CXX_FLAGS_DEBUG=-O1 -g1' -DGUDGEON_SANITIZE=ON -DGUDGEON_WERROR=ON
tell_time "sanitizer build"
echo "Testing with sanitizers"
export ASAN_OPTIONS="${ASAN_OPTIONS:-allow_addr2line=1}"  # lines in stack traces without LLVM's own tool
ctest --test-dir build-asan --output-on-failure --progress -j2
tell_time "sanitizer tests"
