// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// In as many lanes as the processor has.
#include "gudgeon/base/rotations.h"

#include "gudgeon/base/rotation_lanes.h"

namespace gudgeon {

namespace {

static_assert(sizeof(Rotation) == 2 * sizeof(double), "rotations are written as pairs of numbers");

using RotationWriter = void (*)(const double*, std::size_t, double*) noexcept;

RotationWriter choose_rotation_writer() noexcept {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx2")) return write_rotations_avx2;
#endif
  return write_rotations<xsimd::default_arch>;
}

}  // namespace

void make_rotations(std::span<const double> angles, Rotation* rotations) noexcept {
  static const RotationWriter write = choose_rotation_writer();
  if (!angles.empty()) write(angles.data(), angles.size(), &rotations->c);
}

}  // namespace gudgeon
