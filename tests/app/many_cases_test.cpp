// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A model file with thousands of cases: the first run starts at once, and none but those that run are held.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "tests/app/program.h"

namespace gudgeon::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// The slider-crank with that many cases; one of them may be wrong.
std::string make_many_cases(int count, int wrong = -1) {
  std::string text = read_text(find_slider_crank());
  for (int k = 0; k < count; ++k) {
    text += fmt::format(
        "[cases.c{:05}]\ndescription = \"one of many\"\nset = {{ \"joints.pin.radial_clearance\" = \"{} mm\" }}\n", k,
        k == wrong ? -1.0 : 0.05 + 1e-5 * k);
  }
  return text;
}

/// Waits until the file is there; false when that takes longer than half a minute.
bool wait_for_file(const std::filesystem::path& file) {
  for (int k = 0; k < 3000 && !std::filesystem::exists(file); ++k) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return std::filesystem::exists(file);
}

// Sanitizers make each ten times as long.
#ifdef GUDGEON_SANITIZE
constexpr int kManyCases = 1000;
constexpr const char* kLaterCase = "out/c00002.h5";
#else
constexpr int kManyCases = 10000;
constexpr const char* kLaterCase = "out/c00009.h5";
#endif

TEST(ManyCases, StartAtOnceAndHoldOnlyWhatRuns) {
  const TemporaryFolder folder;
  folder.write("m.toml", make_many_cases(kManyCases));
  const auto begin = std::chrono::steady_clock::now();
  RunningProgram program(folder, {"run", "m.toml", "--all-cases", "--threads", "2", "-o", "out", "--set",
                                  "study.cycles=1", "--set", "study.compare_ideal=false"});
  EXPECT_TRUE(wait_for_file(folder.path() / "out/base.h5"));
  const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - begin;
  // A second or two; ten thousand models take minutes.
  EXPECT_LT(waited.count(), 20.0);
  EXPECT_TRUE(wait_for_file(folder.path() / kLaterCase));
#ifndef GUDGEON_SANITIZE
  EXPECT_GT(program.find_peak_memory(), 1e6);
  EXPECT_LT(program.find_peak_memory(), 300e6);
#endif
  program.send(SIGTERM);
  EXPECT_EQ(program.wait().exit_code, 143);
}

TEST(ManyCases, TellOfTheWrongOneAtOnceAndRunTheOthers) {
  const TemporaryFolder folder;
  folder.write("m.toml", make_many_cases(110, 105));
  const Outcome outcome = run_program(folder, {"run", "m.toml", "--all-cases", "-o", "out", "--set", "study.cycles=1",
                                               "--set", "study.compare_ideal=false", "--set", "study.wear_stages=0"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("case c00105 will not run:\nm.toml:"));
  EXPECT_LT(outcome.err.find("case c00105 will not run"), outcome.err.find("c00050: done"));
  EXPECT_THAT(outcome.err, HasSubstr("gudgeon: case c00105: m.toml:"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out/c00105.h5"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "out/c00109.h5"));
}

TEST(ManyCases, StartNoneWhereOneOfTheFirstIsWrong) {
  const TemporaryFolder folder;
  folder.write("m.toml", make_many_cases(110, 50));
  const Outcome outcome = run_program(folder, {"run", "m.toml", "--all-cases", "-o", "out"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("E-MODEL-012"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out"));
}

TEST(ManyCases, AreCheckedInAMoment) {
  const TemporaryFolder folder;
  folder.write("m.toml", make_many_cases(10000));
  for (const std::string name : {"c00000", "c09999"}) {
    EXPECT_EQ(run_program(folder, {"check", "m.toml", "--case", name}).exit_code, 0);
  }
  const Outcome outcome = run_program(folder, {"check", "m.toml", "--case", "c1"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_LT(outcome.err.size(), 5000U);
}

}  // namespace
}  // namespace gudgeon::test
