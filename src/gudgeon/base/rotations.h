// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Cosines and sines of many angles at once.
#pragma once

#include <span>

#include "gudgeon/base/vec2.h"

namespace gudgeon {

/// The rotation of every angle [rad], to 1.7e-16; NaN where an angle is not finite. rotations has as many entries.
void make_rotations(std::span<const double> angles, Rotation* rotations) noexcept;

}  // namespace gudgeon
