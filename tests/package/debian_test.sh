#!/usr/bin/env bash
# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# debian_test.sh BUILD: the Debian package has its name, depends on what the program loads, and what it unpacks runs.
# 77 where packages cannot be made.
set -euo pipefail

build="$(cd -- "$1" && pwd)"
here="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)"
scratch="$(mktemp -d)"
trap 'rm -rf "$scratch"' EXIT

fail() {
  echo "debian_test.sh: $1" >&2
  exit 1
}

for tool in dpkg-deb dpkg-shlibdeps file; do
  command -v "$tool" >/dev/null || { echo "there is no $tool"; exit 77; }
done
if ! cpack --config "$build/CPackConfig.cmake" -B "$scratch" >"$scratch/log" 2>&1; then
  cat "$scratch/log" >&2
  fail "cpack failed"
fi
version="$("$build/gudgeon" --version)"
package="$scratch/gudgeon_${version#gudgeon }_$(dpkg --print-architecture).deb"
[[ -f "$package" ]] || fail "cpack has not made $package"
depends="$(dpkg-deb --field "$package" Depends)"
for library in libc6 libstdc++6 libfmt libhdf5 libmuparser libsundials-cvode; do
  [[ "$depends" == *"$library"* ]] || fail "does not depend on $library: $depends"
done
[[ "$(dpkg-deb --field "$package" Section)" == science ]] || fail "is not in the section science"

dpkg-deb -x "$package" "$scratch/root"
for file in bin/gudgeon include/gudgeon/gudgeon.h share/man/man1/gudgeon.1 \
  share/bash-completion/completions/gudgeon share/zsh/vendor-completions/_gudgeon share/doc/gudgeon/copyright \
  share/gudgeon/model.schema.json; do
  [[ -s "$scratch/root/usr/$file" ]] || fail "lacks /usr/$file"
done
# /usr/lib, or of one architecture, as the build was told
for file in libgudgeon.a cmake/gudgeon/gudgeonConfig.cmake; do
  [[ -s "$scratch/root/usr/lib/$file" || -s "$(echo "$scratch"/root/usr/lib/*/"$file")" ]] || fail "lacks $file"
done
cd "$scratch"
root/usr/bin/gudgeon run "$here/../app/slider_crank.toml" --set study.cycles=1 -o run --quiet --report >"$scratch/log"
[[ -s run/base.h5 && -s run/report.html ]] || fail "its program writes no run or report"
