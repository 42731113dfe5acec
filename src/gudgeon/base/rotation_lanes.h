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
  double few[kLanes] = {};
  if (n < kLanes) {
    for (std::size_t k = 0; k < n; ++k) few[k] = angles[k];
    angles = few;
  }
  const std::size_t n_stored = n < kLanes ? n : kLanes;
  for (std::size_t done = 0; done < n; done += kLanes) {
    // The last lanes overlap those before them: the same bits are written twice.
    const std::size_t first = done + kLanes <= n ? done : n - n_stored;
    const auto [sine, cosine] = xsimd::sincos(Lanes::load_unaligned(angles + first));
    cosine.store_unaligned(cosines);
    sine.store_unaligned(sines);
    for (std::size_t k = 0; k < n_stored; ++k) {
      pairs[2 * (first + k)] = cosines[k];
      pairs[2 * (first + k) + 1] = sines[k];
    }
  }
}

/// The same by AVX2, which the processor must have.
void write_rotations_avx2(const double* angles, std::size_t n, double* pairs) noexcept;

}  // namespace gudgeon
