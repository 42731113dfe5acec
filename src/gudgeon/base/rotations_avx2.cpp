// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Four lanes; compiled for AVX2, called only where the processor has it.
#include "gudgeon/base/rotation_lanes.h"

namespace gudgeon {

void write_rotations_avx2(const double* angles, std::size_t n, double* pairs) noexcept {
#ifdef __AVX2__
  write_rotations<xsimd::avx2>(angles, n, pairs);
#else
  write_rotations<xsimd::default_arch>(angles, n, pairs);
#endif
}

}  // namespace gudgeon
