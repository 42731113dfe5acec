// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// In the lanes of the processor, by xsimd.
#include "gudgeon/base/rotations.h"

#include <algorithm>
#include <array>
#include <xsimd/xsimd.hpp>

namespace gudgeon {

namespace {

using Lanes = xsimd::batch<double>;
constexpr std::size_t kLanes = Lanes::size;
static_assert(sizeof(Rotation) == 2 * sizeof(double), "rotations are written as pairs of numbers");

// c₀ s₀ c₁ s₁ …
void write_rotations(const double* angles, double* pairs) noexcept {
  const auto [sine, cosine] = xsimd::sincos(Lanes::load_unaligned(angles));
  xsimd::zip_lo(cosine, sine).store_unaligned(pairs);
  xsimd::zip_hi(cosine, sine).store_unaligned(pairs + kLanes);
}

}  // namespace

void make_rotations(std::span<const double> angles, Rotation* rotations) noexcept {
  std::size_t k = 0;
  for (; k + kLanes <= angles.size(); k += kLanes) write_rotations(angles.data() + k, &rotations[k].c);
  if (k == angles.size()) return;
  std::array<double, kLanes> rest{};
  std::array<Rotation, kLanes> turned;
  std::ranges::copy(angles.subspan(k), rest.begin());
  write_rotations(rest.data(), &turned[0].c);
  std::copy_n(turned.begin(), angles.size() - k, rotations + k);
}

}  // namespace gudgeon
