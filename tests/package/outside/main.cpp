// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
#include <gudgeon/gudgeon.h>

#include <cstdio>

int main(int, char** argv) {
  auto model = gudgeon::read_model(argv[1]);
  model.set("joints.pin.radial_clearance", 0.2, "mm");
  const auto result = gudgeon::run(model);
  std::printf("%.17g\n", result.stage("wear_1").joint("pin").bearing_depth().max());
}
