// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// How far the farthest two of many points are apart.
#pragma once

#include <span>

#include "gudgeon/base/vec2.h"

namespace gudgeon {

/// Zero for fewer than two points. Points that are not finite are passed over.
double find_longest_distance(std::span<const Vec2> points);

}  // namespace gudgeon
