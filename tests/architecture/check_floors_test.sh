#!/usr/bin/env bash
# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# check_floors.sh passes a good tree and finds each kind of fault in a bad one.
set -euo pipefail

script="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)/check_floors.sh"
tree="$(mktemp -d)"
trap 'rm -rf "$tree"' EXIT
n_failures=0

fail() {
  echo "check_floors_test.sh: $1" >&2
  n_failures=$((n_failures + 1))
}

# write_source FLOOR/FILE LINE...: a source with its licence lines.
write_source() {
  local file="$tree/src/gudgeon/$1"
  shift
  mkdir -p "$(dirname "$file")"
  printf '%s\n' '// SPDX-FileCopyrightText: gudgeon contributors' '// SPDX-License-Identifier: Apache-2.0' "$@" >"$file"
}

start_tree() {
  rm -rf "$tree/src"
  write_source base/vec2.h '#pragma once' '#include <cmath>'
  write_source sim/loop.cpp '#include "gudgeon/base/vec2.h"' '#include "gudgeon/sim/loop.h"'
  write_source io/file.cpp '#include <hdf5.h>' '#include "gudgeon/model/body.h"'
}

# expect_complaint TEXT: the tree is refused with this complaint.
expect_complaint() {
  local output
  if output="$(bash "$script" "$tree" 2>&1)"; then
    fail "passes, but should say: $1"
  elif [[ "$output" != *"$1"* ]]; then
    fail "should say: $1"$'\n'"but says: $output"
  fi
}

start_tree
bash "$script" "$tree" >/dev/null || fail "refuses a good tree"

start_tree
write_source base/up.h '#include "gudgeon/sim/loop.h"'
expect_complaint 'base/up.h:3: floor base may not include gudgeon/sim/loop.h'

start_tree
write_source report/page.cpp '#  include   <hdf5.h>'
expect_complaint 'report/page.cpp:3: hdf5.h may not be included on floor report'

start_tree
write_source io/parse.cpp '#include <CLI/CLI.hpp>'
expect_complaint 'CLI/CLI.hpp may not be included on floor io'

start_tree
write_source io/near.cpp '#include "near.h"'
expect_complaint 'includes near.h without its floor'

start_tree
write_source cellar/wine.h '#pragma once'
expect_complaint 'cellar/wine.h:1: lies on no known floor'

start_tree
write_source gudgeon.h '#include "gudgeon/library/model.h"'
bash "$script" "$tree" >/dev/null || fail "refuses the header of the library"
write_source gudgeon.h '#include "gudgeon/sim/loop.h"'
expect_complaint 'gudgeon.h:3: floor gudgeon.h may not include gudgeon/sim/loop.h'

start_tree
write_source stray.h '#pragma once'
expect_complaint 'stray.h:1: lies on no known floor'

start_tree
echo '#pragma once' >"$tree/src/gudgeon/base/bare.h"
expect_complaint 'base/bare.h:1: does not begin with its SPDX copyright line'

start_tree
write_source base/long.cpp
for ((i = 0; i < 500; i++)); do echo "int value_$i;" >>"$tree/src/gudgeon/base/long.cpp"; done
expect_complaint 'base/long.cpp:502: has 502 lines, more than 500'

rm -rf "$tree/src"
expect_complaint 'there is no'

((n_failures == 0))
