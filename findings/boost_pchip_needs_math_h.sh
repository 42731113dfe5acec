#!/usr/bin/env bash
# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# Boost.Math 1.74 (Debian 12, libboost1.74-dev 1.74.0+ds1-21): boost/math/interpolators/pchip.hpp calls isnan without
# naming or including it, so the class does not compile with GCC for double unless <math.h> (not <cmath>) was included
# before it. The slope that it takes at an end, unless given, is that of the outermost chord, not the three-point formula
# of MATLAB's and SciPy's pchip: for the points 0, 1, 4, 9 at 0, 1, 2, 3 it is 1 at the start, where theirs is 0.
# gudgeon includes <math.h> first, and tells of the end slopes in docs/theory/loads.md (Eq. L7).
# Needs: Debian 12, its package mirror, g++. Fails where the behaviour is another one.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -q libboost1.74-dev=1.74.0+ds1-21 >/dev/null
dpkg-deb -x libboost1.74-dev_*.deb root
cat >pchip.cpp <<'EOF'
#include <cmath>
#ifdef WITH_MATH_H
#include <math.h>
#endif
#include <boost/math/interpolators/pchip.hpp>
#include <cstdio>
#include <vector>

int main() {
  std::vector<double> x{0, 1, 2, 3};
  std::vector<double> y{0, 1, 4, 9};
  const boost::math::interpolators::pchip<std::vector<double>> curve(std::move(x), std::move(y));
  std::printf("slope at the start %g, at the end %g\n", curve.prime(0.0), curve.prime(3.0));
}
EOF
if g++ -std=c++17 -isystem root/usr/include pchip.cpp -o without 2>errors; then
  echo "compiles without <math.h>"
  exit 1
fi
grep -q "isnan" errors && echo "does not compile without <math.h>: isnan is not declared"
g++ -std=c++17 -DWITH_MATH_H -isystem root/usr/include pchip.cpp -o with
./with | tee seen
echo "slope at the start 1, at the end 5" | diff - seen
