// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Cosines and sines in the lanes of one instruction set, by xsimd. Nothing else may be included where an instruction
// set beyond the project's is compiled for: an inline function could end up in code that any processor runs.
#pragma once

#include <cstddef>
#include <xsimd/xsimd.hpp>

namespace gudgeon {

/// Writes c₀ s₀ c₁ s₁ … of n angles [rad]. The same bits for any Instructions without fused multiply-add.
template <class Instructions>
inline void write_rotations(const double* angles, std::size_t n, double* pairs) noexcept {
  using Lanes = xsimd::batch<double, Instructions>;
  constexpr std::size_t kLanes = Lanes::size;
  double cosines[kLanes];
  double sines[kLanes];
  double rest[kLanes] = {};
  for (std::size_t first = 0; first < n; first += kLanes) {
    const std::size_t n_here = n - first < kLanes ? n - first : kLanes;
    const double* from = angles + first;
    if (n_here < kLanes) {
      for (std::size_t k = 0; k < n_here; ++k) rest[k] = from[k];
      from = rest;
    }
    const auto [sine, cosine] = xsimd::sincos(Lanes::load_unaligned(from));
    cosine.store_unaligned(cosines);
    sine.store_unaligned(sines);
    for (std::size_t k = 0; k < n_here; ++k) {
      pairs[2 * (first + k)] = cosines[k];
      pairs[2 * (first + k) + 1] = sines[k];
    }
  }
}

/// The same by AVX2, which the processor must have.
void write_rotations_avx2(const double* angles, std::size_t n, double* pairs) noexcept;

}  // namespace gudgeon
