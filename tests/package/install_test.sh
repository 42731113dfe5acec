#!/usr/bin/env bash
# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# install_test.sh BUILD COMPILER: installs into an empty prefix, builds a program outside the tree against nothing but
# that, and compares what it finds with what the installed program says of the same model.
set -euo pipefail

build="$1"
compiler="$2"
here="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)"
scratch="$(mktemp -d)"
trap 'rm -rf "$scratch"' EXIT
prefix="$scratch/prefix"

fail() {
  echo "install_test.sh: $1" >&2
  exit 1
}

quietly() {
  "$@" >"$scratch/log" 2>&1 || { cat "$scratch/log" >&2; fail "failed: $*"; }
}

quietly cmake --install "$build" --prefix "$prefix"
mapfile -t headers < <(cd "$prefix/include" && find gudgeon -name '*.h' | LC_ALL=C sort)

# Public headers show the standard library and themselves, no other.
for header in "${headers[@]}"; do
  while read -r included; do
    case "$included" in
      '"gudgeon/'*) [[ -f "$prefix/include/${included//\"/}" ]] || fail "$header includes $included, not installed" ;;
      '<'*[./]*) fail "$header shows $included" ;;
    esac
  done < <(sed -n 's/^ *# *include *\([<"][^>"]*[>"]\).*/\1/p' "$prefix/include/$header")
done

# What is installed does not lead back to where it was built; lines for debuggers may.
source_root="$(cd -- "$here/../.." && pwd)"
mapfile -t archives < <(find "$prefix" -name libgudgeon.a)
((${#archives[@]} == 1)) || fail "the library is ${#archives[@]} archives"
strip --strip-debug "$prefix/bin/gudgeon" "${archives[@]}"
if grep -rl -e "$source_root" -e "$(cd -- "$build" && pwd)" "$prefix"; then
  fail "the files above name the tree they were built in"
fi

cp -r "$here/outside" "$scratch/outside"
sed -n '/^    #include <gudgeon/,/^    }$/s/^    //p' "$source_root/docs/guide/library.md" >"$scratch/outside/guide.cpp"
quietly cmake -S "$scratch/outside" -B "$scratch/outside/build" -DCMAKE_CXX_COMPILER="$compiler" \
  -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_CXX_FLAGS="-Wall -Wextra -Wpedantic -Werror"
quietly cmake --build "$scratch/outside/build"
cp "$here/../app/slider_crank.toml" "$scratch/model.toml"
cd "$scratch"
deepest="$(outside/build/outside model.toml)"

# The depths after the stage are those it ran on and those it added.
program="$prefix/bin/gudgeon"
quietly "$program" run model.toml --set joints.pin.radial_clearance="0.2 mm" -o run --quiet
quietly "$program" export run/base.h5 -o csv
expected="$(awk -F , '
  NR == 1 { for (k = 1; k <= NF; k++) column[$k] = k }
  NR > 1 && $column["joint"] == "pin" {
    depth = $column["bearing_depth [m]"] + $column["bearing_depth_added [m]"]
    if (depth > deepest) deepest = depth
  }
  END { printf "%.17g", deepest }' csv/wear_1_wear.csv)"
[[ "$expected" != 0 ]] || fail "the program wears nothing"
[[ "$deepest" == "$expected" ]] || fail "the library says $deepest m, the program $expected m"
echo "$deepest m, in ${#headers[@]} headers"
