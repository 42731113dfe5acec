// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Signal handling.
#include "gudgeon/app/interruption.h"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <ctime>

#include "gudgeon/app/signal_rule.h"

namespace gudgeon {
namespace {

// All that a handler touches. It may run on any thread, and on two at a time.
std::atomic<int> received_signal = 0;
std::atomic<std::int64_t> received_at = 0;  // [ns] of the first signal; 0: none came
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<std::int64_t>::is_always_lock_free);

extern "C" void note_signal(int signal) {
  const int error = errno;
  timespec clock{};
  ::clock_gettime(CLOCK_MONOTONIC, &clock);
  const std::int64_t now = std::int64_t{1'000'000'000} * clock.tv_sec + clock.tv_nsec;
  std::int64_t first = 0;
  if (received_at.compare_exchange_strong(first, now)) {
    received_signal = signal;
  } else if (find_signal_effect(signal, std::chrono::nanoseconds(now - first)) == SignalEffect::end) {
    // It comes again when the handler returns, and does what it does to any program.
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
  errno = error;
}

}  // namespace

Interruption::Interruption() {
  received_signal = 0;
  received_at = 0;
  struct sigaction action {};
  action.sa_handler = note_signal;
  action.sa_flags = SA_RESTART;  // files being written are not disturbed
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
}

Interruption::~Interruption() {
  // What is still to be said after a stop is not cut off by the signal that comes twice.
  if (received_signal != 0) return;
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

int Interruption::signal() const { return received_signal; }

}  // namespace gudgeon
