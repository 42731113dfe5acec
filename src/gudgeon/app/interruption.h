// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Ctrl-C and SIGTERM: the first one asks the work to stop, a later one ends the program (signal_rule.h).
#pragma once

namespace gudgeon {

/// Listens while it lives, and after a signal for as long as the program does; one at a time.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  /// The signal that came first, or 0.
  [[nodiscard]] int signal() const;
};

}  // namespace gudgeon
