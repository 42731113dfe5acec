// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What a signal means to a program at work.
#pragma once

#include <chrono>
#include <csignal>
#include <optional>

namespace gudgeon {

enum class SignalEffect {
  stop,  ///< the work is asked to stop
  pass,  ///< it was asked already
  end,   ///< the program ends at once
};

/// Job systems send SIGTERM twice in a row, to the program and to its group; whoever means it comes back later than
/// this.
inline constexpr std::chrono::seconds kSameRequest{2};

/// The first SIGINT or SIGTERM asks the work to stop. A SIGINT after that ends the program, as does a SIGTERM that
/// comes later than kSameRequest after the first signal.
constexpr SignalEffect find_signal_effect(int signal, std::optional<std::chrono::nanoseconds> since_first) noexcept {
  if (!since_first) return SignalEffect::stop;
  return signal == SIGTERM && *since_first <= kSameRequest ? SignalEffect::pass : SignalEffect::end;
}

}  // namespace gudgeon
