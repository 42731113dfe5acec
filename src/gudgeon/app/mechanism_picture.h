// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// From a model and its assembled position to the picture's plain geometry.
#pragma once

#include "gudgeon/model/mechanism.h"
#include "gudgeon/report/mechanism_drawing.h"
#include "gudgeon/system/assembly.h"

namespace gudgeon {

/// The mechanism as assembled; title and subtitle are left to the caller.
MechanismDrawing make_drawing(const Mechanism& mechanism, const Assembly& assembly);

/// The path of a body's point from t = 0 over the given time, each position found from the one before.
/// Throws ModelError where the mechanism cannot be assembled.
DrawnTrace make_trace(const Mechanism& mechanism, const Anchor& anchor, double duration);

}  // namespace gudgeon
