// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// H q̈ + Jᵀ λ = r, J q̈ = γ with leaves 2, 3 and 8 eliminated on paper.
#include "bench/hand_written/nine_bar.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/hand_written/journal.h"

namespace gudgeon::hand_written {

namespace {

// Lengths [m], distances of centres of mass [m], masses [kg], inertias [kg m^2] of nine_bar.md.
constexpr double kL1 = 0.045, kL4 = 0.095, kL6 = 0.230, kL2 = 0.326, kL3 = 0.497, kL8 = 0.335, kSide = 0.2546;
constexpr double kS6 = 0.115, kS2 = kL2 - 0.163, kS3 = kL3 - 0.249, kS8 = 0.168;  // 2 and 3 from their tops, at D
constexpr double kM6 = 0.581, kM7 = 4.334, kM2 = 0.805, kM3 = 0.603, kM8 = 0.827, kM9 = 0.801;
constexpr double kI6 = 3.802e-3, kI7 = 12.12e-3, kI2 = 8.001e-3, kI3 = 13.37e-3, kI8 = 8.663e-3;
constexpr double kO4 = 0.430, kP6x = -0.220, kP6y = 0.460, kGravity = 9.81;
constexpr double kSpeed1 = -2.0 * std::numbers::pi, kSpeed4 = 2.0 * std::numbers::pi;
constexpr double kStart1 = 60.28 * std::numbers::pi / 180.0, kStart4 = -52.86 * std::numbers::pi / 180.0;

// Panel points in its axes: D = (side, 0), F = side (1/2, √3/2), centre of mass (D + F)/3.
constexpr double kFx = 0.5 * kSide, kFy = 0.5 * std::numbers::sqrt3 * kSide;
constexpr double kCx = (kSide + kFx) / 3.0, kCy = kFy / 3.0;

// Constants of the mass matrix and of gravity.
constexpr double kCarried = kM7 + kM2 + kM3 + kM8 + kM9;
constexpr double kFirst8 = kM8 * kS8 + kM9 * kL8;
constexpr double kFirst7x = kM7 * kCx + (kM2 + kM3) * kSide + (kM8 + kM9) * kFx;
constexpr double kFirst7y = kM7 * kCy + (kM8 + kM9) * kFy;
constexpr double kH66 = kI6 + kM6 * kS6 * kS6 + kCarried * kL6 * kL6;
constexpr double kH77 = kI7 + kM7 * (kCx * kCx + kCy * kCy) + (kM2 + kM3 + kM8 + kM9) * kSide * kSide;
constexpr double kInverse22 = 1.0 / (kI2 + kM2 * kS2 * kS2);
constexpr double kInverse33 = 1.0 / (kI3 + kM3 * kS3 * kS3);
constexpr double kInverse88 = 1.0 / (kI8 + kM8 * kS8 * kS8 + kM9 * kL8 * kL8);

// Contact: K = 4/3 E* √(R_i R_j/c) of steel on steel.
constexpr double kBearingRadius = 15e-3, kClearance = 0.5e-3, kJournalRadius = kBearingRadius - kClearance;
constexpr double kModulus = 200e9 / (2.0 * (1.0 - 0.3 * 0.3));
const double kStiffness = 4.0 / 3.0 * kModulus * std::sqrt(kBearingRadius * kJournalRadius / kClearance);
constexpr double kDamping = 0.75 * (1.0 - 0.9 * 0.9);

double find_friction(double slip) noexcept {
  const double ratio = slip / 1e-3;
  return (0.10 + 0.05 * std::exp(-ratio * ratio)) * std::tanh(slip / 1e-4);
}

}  // namespace

void NineBar::eval(double t, const double* y, double* slope) const noexcept {
  const double w6 = y[5], w7 = y[6], w2 = y[7], w3 = y[8], w8 = y[9];
  const Vec2 u6{std::cos(y[0]), std::sin(y[0])}, u7{std::cos(y[1]), std::sin(y[1])};
  const Vec2 u2{std::cos(y[2]), std::sin(y[2])}, u3{std::cos(y[3]), std::sin(y[3])};
  const Vec2 u8{std::cos(y[4]), std::sin(y[4])};
  const Vec2 f{kFx * u7.x - kFy * u7.y, kFx * u7.y + kFy * u7.x};  // E to F
  const Vec2 first7{kFirst7x * u7.x - kFirst7y * u7.y, kFirst7x * u7.y + kFirst7y * u7.x};
  const double s6 = w6 * w6, s7 = w7 * w7, s2 = w2 * w2, s3 = w3 * w3, s8 = w8 * w8;

  // Couplings: H_ij of cosines, and of sines what squared rates of j do to i.
  const double h67 = kL6 * dot(u6, first7), c67 = kL6 * cross(u6, first7);
  const double h62 = -kM2 * kS2 * kL6 * dot(u6, u2), c62 = -kM2 * kS2 * kL6 * cross(u6, u2);
  const double h72 = -kM2 * kS2 * kSide * dot(u7, u2), c72 = -kM2 * kS2 * kSide * cross(u7, u2);
  const double h63 = -kM3 * kS3 * kL6 * dot(u6, u3), c63 = -kM3 * kS3 * kL6 * cross(u6, u3);
  const double h73 = -kM3 * kS3 * kSide * dot(u7, u3), c73 = -kM3 * kS3 * kSide * cross(u7, u3);
  const double h68 = kFirst8 * kL6 * dot(u6, u8), c68 = kFirst8 * kL6 * cross(u6, u8);
  const double h78 = kFirst8 * dot(f, u8), c78 = kFirst8 * cross(f, u8);

  // Gravity along +x and velocity terms.
  double r6 = -kGravity * (kM6 * kS6 + kCarried * kL6) * u6.y + c67 * s7 + c62 * s2 + c63 * s3 + c68 * s8;
  double r7 = -kGravity * first7.y - c67 * s6 + c72 * s2 + c73 * s3 + c78 * s8;
  double r2 = kGravity * kM2 * kS2 * u2.y - c62 * s6 - c72 * s7;
  double r3 = kGravity * kM3 * kS3 * u3.y - c63 * s6 - c73 * s7;
  const double r8 = -kGravity * kFirst8 * u8.y - c68 * s6 - c78 * s7;

  // Contacts: journals at the lower ends of rods 2 and 3, bearings on the cranks.
  const Vec2 d{kP6x + kL6 * u6.x + kSide * u7.x, kP6y + kL6 * u6.y + kSide * u7.y};
  const Vec2 d_rate = kL6 * w6 * perp(u6) + kSide * w7 * perp(u7);
  const double angle1 = kStart1 + kSpeed1 * t, angle4 = kStart4 + kSpeed4 * t;
  const Vec2 u1{std::cos(angle1), std::sin(angle1)}, u4{std::cos(angle4), std::sin(angle4)};
  const JournalForce at_a = find_journal_force(
      {d - kL2 * u2 - kL1 * u1, d_rate - kL2 * w2 * perp(u2) - kL1 * kSpeed1 * perp(u1), kSpeed1, w2}, a,
      {kJournalRadius, kClearance, kStiffness, kDamping}, find_friction);
  const JournalForce at_b = find_journal_force(
      {d - kL3 * u3 - kL4 * u4 - Vec2{kO4, 0.0}, d_rate - kL3 * w3 * perp(u3) - kL4 * kSpeed4 * perp(u4), kSpeed4, w3},
      b, {kJournalRadius, kClearance, kStiffness, kDamping}, find_friction);
  const Vec2 both = at_a.force + at_b.force;
  r6 += kL6 * cross(u6, both);
  r7 += kSide * cross(u7, both);
  r2 += at_a.journal_torque - kL2 * cross(u2, at_a.force);
  r3 += at_b.journal_torque - kL3 * cross(u3, at_b.force);

  // The slider stays on its line: J q̈ = γ.
  const double j8 = kL8 * u8.x;
  const double gamma = kL6 * u6.y * s6 + f.y * s7 + kL8 * u8.y * s8;

  // Leaves 2, 3, 8 into 6, 7 and λ.
  const double h62i = h62 * kInverse22, h72i = h72 * kInverse22, h63i = h63 * kInverse33, h73i = h73 * kInverse33;
  const double h68i = h68 * kInverse88, h78i = h78 * kInverse88, j8i = j8 * kInverse88;
  const double h66 = kH66 - h62i * h62 - h63i * h63 - h68i * h68;
  const double h76 = h67 - h62i * h72 - h63i * h73 - h68i * h78;
  const double h77 = kH77 - h72i * h72 - h73i * h73 - h78i * h78;
  const double b6 = r6 - h62i * r2 - h63i * r3 - h68i * r8;
  const double b7 = r7 - h72i * r2 - h73i * r3 - h78i * r8;
  const double j6 = kL6 * u6.x - h68i * j8, j7 = f.x - h78i * j8;
  const double g = gamma - j8i * r8;

  // Two by two, then λ.
  const double inverse = 1.0 / (h66 * h77 - h76 * h76);
  const double p6 = inverse * (h77 * j6 - h76 * j7), p7 = inverse * (h66 * j7 - h76 * j6);
  const double lambda = (p6 * b6 + p7 * b7 - g) / (p6 * j6 + p7 * j7 + j8i * j8);
  const double e6 = b6 - j6 * lambda, e7 = b7 - j7 * lambda;
  const double a6 = inverse * (h77 * e6 - h76 * e7), a7 = inverse * (h66 * e7 - h76 * e6);

  slope[0] = w6, slope[1] = w7, slope[2] = w2, slope[3] = w3, slope[4] = w8;
  slope[5] = a6;
  slope[6] = a7;
  slope[7] = kInverse22 * r2 - h62i * a6 - h72i * a7;
  slope[8] = kInverse33 * r3 - h63i * a6 - h73i * a7;
  slope[9] = kInverse88 * r8 - h68i * a6 - h78i * a7 - j8i * lambda;
}

}  // namespace gudgeon::hand_written
