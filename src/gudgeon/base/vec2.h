// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Plane vectors and rotations. Angles are counter-clockwise, in radians.
#pragma once

#include <cmath>

namespace gudgeon {

struct Vec2 {
  double x = 0.0;
  double y = 0.0;

  constexpr Vec2& operator+=(Vec2 b) {
    x += b.x, y += b.y;
    return *this;
  }
  constexpr Vec2& operator-=(Vec2 b) {
    x -= b.x, y -= b.y;
    return *this;
  }
  friend constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
  friend constexpr Vec2 operator*(double k, Vec2 a) { return {k * a.x, k * a.y}; }
  friend constexpr bool operator==(Vec2, Vec2) = default;
};

constexpr double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
constexpr double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
/// The vector turned by +90 degrees, so that cross(a, b) = dot(perp(a), b).
constexpr Vec2 perp(Vec2 a) { return {-a.y, a.x}; }
inline double norm(Vec2 a) { return std::sqrt(dot(a, a)); }

/// A turn by one angle, kept as its cosine and sine.
struct Rotation {
  double c = 1.0;
  double s = 0.0;

  friend constexpr Vec2 operator*(Rotation r, Vec2 a) { return {r.c * a.x - r.s * a.y, r.s * a.x + r.c * a.y}; }
};

inline Rotation make_rotation(double angle) { return {std::cos(angle), std::sin(angle)}; }

}  // namespace gudgeon
