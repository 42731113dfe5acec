// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Four lanes; compiled for AVX2, called only where the processor has it.

// Functions of xsimd that are inline but do not name their instruction set: a copy compiled here must not be taken for
// the one that any processor may run.
#define __kernel_rem_pio2 kernel_rem_pio2_avx2
#define __ieee754_rem_pio2 ieee754_rem_pio2_avx2
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
