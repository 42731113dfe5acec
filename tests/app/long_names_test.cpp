// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Names of five hundred letters: every file can be written, each under a name of its own.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iterator>

#include "tests/app/program.h"

namespace gudgeon::test {
namespace {

TEST(LongNames, MakeFilesThatCanBeWritten) {
  const TemporaryFolder folder;
  const std::string word(500, 'w');
  std::string text = read_text(find_slider_crank());
  for (const char* ending : {"a", "b"}) {
    text += fmt::format("[cases.{}{}]\nset = {{ \"study.cycles\" = 1 }}\n", word, ending);
    text += fmt::format("[loads.{}{}]\ntype = \"torque\"\nbody = \"crank\"\ntorque = \"1e-9*t\"\n", word, ending);
  }
  folder.write("m.toml", text);
  const Outcome run = run_program(folder, {"run", "m.toml", "--quiet", "-o", "out", "--case", word + "a", "--case",
                                           word + "b", "--set", "study.compare_ideal=false", "--report"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const auto count_files = [&](const char* directory) {
    return std::distance(std::filesystem::directory_iterator(folder.path() / directory), {});
  };
  EXPECT_EQ(count_files("out"), 3);  // two run files and their report
  EXPECT_EQ(run_program(folder, {"check", "m.toml", "--plots", "pictures"}).exit_code, 0);
  EXPECT_EQ(count_files("pictures"), 2);
  EXPECT_EQ(run_program(folder, {"draw", "m.toml", "-o", "m.svg"}).exit_code, 0);
}

}  // namespace
}  // namespace gudgeon::test
