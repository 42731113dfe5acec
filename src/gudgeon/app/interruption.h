// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Ctrl-C and SIGTERM: the first one asks the work to stop, the second one ends the program.
#pragma once

namespace gudgeon {

/// Listens while it lives; one at a time.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  /// The signal that came, or 0.
  [[nodiscard]] int signal() const;
};

}  // namespace gudgeon
