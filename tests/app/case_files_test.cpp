// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// tests/cases holds inputs whose right answer is known; a file that no test names asserts nothing.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/app/program.h"

namespace gudgeon::test {
namespace {

const std::filesystem::path kTests = GUDGEON_SOURCE_DIR "/tests";

std::string read_all_tests() {
  std::string text;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kTests)) {
    if (entry.path().extension() == ".cpp") text += read_text(entry.path());
  }
  return text;
}

TEST(CaseFiles, AreEachNamedByATest) {
  const std::string tests = read_all_tests();
  int n_files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kTests / "cases")) {
    if (!entry.is_regular_file()) continue;
    ++n_files;
    const std::string name = entry.path().stem().string();
    const bool is_named =
        tests.find("\"" + name + "\"") != std::string::npos || tests.find(name + ".toml") != std::string::npos;
    EXPECT_TRUE(is_named) << entry.path() << " is named by no test";
  }
  EXPECT_GT(n_files, 3);
}

TEST(CaseFiles, SayFirstWhatIsRight) {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kTests / "cases")) {
    if (!entry.is_regular_file()) continue;
    EXPECT_EQ(entry.path().extension(), ".toml") << entry.path();
    EXPECT_TRUE(read_text(entry.path()).starts_with("# ")) << entry.path() << " does not say what is right";
  }
}

}  // namespace
}  // namespace gudgeon::test
