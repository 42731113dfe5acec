// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Processor time of the calling thread: what others do on a shared machine does not count.
#pragma once

#include <ctime>

namespace gudgeon::bench {

/// [s] since some moment.
inline double read_cpu_clock() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace gudgeon::bench
