#!/usr/bin/env bash
# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# muParser 2.3.3 (Debian 12, libmuparser-dev 2.3.3-0.1): && and || of two numbers known when the formula is compiled cut
# both to whole numbers first, so "0.5 && 1" is 0; with a variable among the operands the same formula is 1. Constants
# made with DefineConst are numbers in this sense. EnableOptimizer(false) makes both 1.
# gudgeon defines a model's constants as variables and switches the optimizer off where a formula has && or ||.
# Needs: Debian 12, its package mirror, g++. Fails where the behaviour is another one.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -q libmuparser-dev=2.3.3-0.1 libmuparser2v5=2.3.3-0.1 >/dev/null
for package in *.deb; do dpkg-deb -x "$package" root; done
library=$(dirname "$(find root -name 'libmuparser.so.2')")
cat >logic.cpp <<'EOF'
#include <muParser.h>

#include <cstdio>

double eval(const char* formula, bool optimize) {
  double one = 1.0;
  mu::Parser parser;
  parser.EnableOptimizer(optimize);
  parser.DefineConst("half", 0.5);
  parser.DefineVar("one", &one);
  parser.SetExpr(formula);
  return parser.Eval();
}

int main() {
  for (const char* formula : {"0.5 && 1", "0.5 || 0", "half && 1", "half && one"}) {
    std::printf("%s: %g, without the optimizer %g\n", formula, eval(formula, true), eval(formula, false));
  }
}
EOF
g++ -std=c++17 -I root/usr/include logic.cpp -L "$library" -lmuparser -o logic
LD_LIBRARY_PATH=$library ./logic | tee seen
cat >expected <<'EOF'
0.5 && 1: 0, without the optimizer 1
0.5 || 0: 0, without the optimizer 1
half && 1: 0, without the optimizer 1
half && one: 1, without the optimizer 1
EOF
diff expected seen
