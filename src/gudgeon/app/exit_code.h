// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What the program tells its caller when it ends.
#pragma once

#include <functional>

namespace gudgeon {

enum class ExitCode {
  done = 0,
  usage = 2,          ///< the command line cannot be understood
  model = 3,          ///< the model or study is wrong
  numerical = 4,      ///< a computation could not go on; what was finished is kept
  file = 5,           ///< a file could not be read or written
  unbalanced = 6,     ///< finished, but the energy balance of a stage does not close
  interrupted = 130,  ///< SIGINT, as shells count it: 128 + 2
  terminated = 143,   ///< SIGTERM: 128 + 15
};

/// What a std::bad_alloc means, wherever it comes from.
inline constexpr const char* kOutOfMemory =
    "out of memory; run fewer cases side by side (--threads), record less (outputs_per_cycle) or raise the limit";

/// What a parsed command line asks for.
using Action = std::function<ExitCode()>;

}  // namespace gudgeon
