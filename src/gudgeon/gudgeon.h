// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// All that a program needs to read, change and run models and to use their results. docs/guide/library.md shows how.
//
//   auto model = gudgeon::read_model("press.toml");
//   model.set("joints.A.radial_clearance", 0.4, "mm");
//   const auto result = gudgeon::run(model);
//   const double deepest = result.stage("wear_1").joint("A").bearing_depth().max();  // [m]
//
// Everything is in SI and radians.
#pragma once

#include "gudgeon/library/model.h"
#include "gudgeon/library/result.h"
#include "gudgeon/library/run.h"
