// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Which signal stops, which ends, which is let pass.
#include "gudgeon/app/signal_rule.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

#include "tests/app/program.h"

namespace gudgeon::test {
namespace {

using ::testing::HasSubstr;
using namespace std::chrono_literals;

TEST(SignalRule, FirstSignalAsksForAStop) {
  EXPECT_EQ(find_signal_effect(SIGINT, std::nullopt), SignalEffect::stop);
  EXPECT_EQ(find_signal_effect(SIGTERM, std::nullopt), SignalEffect::stop);
}

TEST(SignalRule, SigtermWithinTwoSecondsIsLetPass) {
  for (const auto since : {0ns, std::chrono::nanoseconds(10ms), std::chrono::nanoseconds(2s)}) {
    EXPECT_EQ(find_signal_effect(SIGTERM, since), SignalEffect::pass);
  }
  EXPECT_EQ(find_signal_effect(SIGTERM, 2s + 1ns), SignalEffect::end);
  EXPECT_EQ(find_signal_effect(SIGTERM, 1h), SignalEffect::end);
}

TEST(SignalRule, SecondCtrlCEndsAtOnce) {
  EXPECT_EQ(find_signal_effect(SIGINT, 0ns), SignalEffect::end);
  EXPECT_EQ(find_signal_effect(SIGINT, 1min), SignalEffect::end);
}

/// A run that would take long, sent these signals 10 ms apart.
Outcome run_and_send(std::initializer_list<int> signals) {
  const TemporaryFolder folder;
  RunningProgram program(folder, {"run", find_slider_crank(), "--set", "study.cycles=100000"});
  const std::filesystem::path file = folder.path() / "runs" / "slider_crank" / "base.h5";
  for (int i = 0; i < 3000 && !std::filesystem::exists(file); ++i) std::this_thread::sleep_for(10ms);
  std::this_thread::sleep_for(300ms);
  for (const int signal : signals) {
    program.send(signal);
    std::this_thread::sleep_for(10ms);
  }
  return program.wait();
}

TEST(Signals, SigtermThreeTimesInARowIsOneStop) {
  const Outcome outcome = run_and_send({SIGTERM, SIGTERM, SIGTERM});
  EXPECT_EQ(outcome.exit_code, 143);
  EXPECT_THAT(outcome.err, HasSubstr("what was finished is kept in"));
}

/// Whether the program was ended by the second signal. A stop takes some tens of milliseconds, and may be faster.
bool is_ended_by(int first, int second) {
  for (int attempt = 0; attempt < 5; ++attempt) {
    const Outcome outcome = run_and_send({first, second});
    const bool stopped = outcome.err.find("what was finished is kept in") != std::string::npos;
    if (outcome.exit_code == 128 + second && !stopped) return true;
  }
  return false;
}

TEST(Signals, SecondCtrlCEndsTheProgramAtOnce) { EXPECT_TRUE(is_ended_by(SIGINT, SIGINT)); }

TEST(Signals, CtrlCAfterSigtermEndsTheProgramAtOnce) { EXPECT_TRUE(is_ended_by(SIGTERM, SIGINT)); }

}  // namespace
}  // namespace gudgeon::test
