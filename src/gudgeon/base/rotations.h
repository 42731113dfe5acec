// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Cosines and sines of many angles at once.
#pragma once

#include <cstddef>
#include <span>

#include "gudgeon/base/vec2.h"

namespace gudgeon {

/// As many angles as are turned at once: where fewer are left at the end, they take longer than if there were as many.
inline constexpr std::size_t kRotationLanes = 4;

/// The rotation of every angle [rad], to 1.7e-16; NaN where an angle is not finite. rotations has as many entries.
void make_rotations(std::span<const double> angles, Rotation* rotations) noexcept;

}  // namespace gudgeon
