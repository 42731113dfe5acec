#!/usr/bin/env bash
# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# toml++ 3.3.0 (Debian 12, libtomlplusplus-dev 3.3.0+ds-1) refuses a number that is too large for a double, 1e400, but
# reads one that is too small, 1e-400, as 0 without a word. A stiffness or a time of "1e-400" thus becomes none.
# gudgeon reads the number's text itself where a value came out as 0, and refuses it with the range (E-FILE-016).
# Needs: Debian 12, its package mirror, g++. Fails where the behaviour is another one.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -q libtomlplusplus-dev=3.3.0+ds-1 libtomlplusplus3=3.3.0+ds-1 >/dev/null
for package in *.deb; do dpkg-deb -x "$package" root; done
cat >numbers.cpp <<'EOF'
#define TOML_HEADER_ONLY 1
#include <toml++/toml.h>

#include <cstdio>

int main() {
  for (const char* text : {"x = 1e-300", "x = 1e-400", "x = 1e400"}) {
    try {
      std::printf("%s gives %g\n", text, toml::parse(text)["x"].value<double>().value());
    } catch (const toml::parse_error&) {
      std::printf("%s is refused\n", text);
    }
  }
}
EOF
g++ -std=c++17 -isystem root/usr/include numbers.cpp -o numbers
./numbers | tee seen
printf 'x = 1e-300 gives 1e-300\nx = 1e-400 gives 0\nx = 1e400 is refused\n' | diff - seen
