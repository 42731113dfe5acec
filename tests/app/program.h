// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Runs the built program as a user would.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gudgeon::test {

struct Outcome {
  int exit_code = -1;  ///< 128 + signal when a signal ended it
  std::string out;
  std::string err;
};

/// A folder of its own for one test, gone with it.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Writes a file into it.
  std::filesystem::path write(std::string_view name, std::string_view text) const;

 private:
  std::filesystem::path path_;
};

/// The program at work; standard output and error go to files in the folder, or to one file where both are given it.
class RunningProgram {
 public:
  RunningProgram(const TemporaryFolder& folder, const std::vector<std::string>& arguments,
                 const std::filesystem::path& out = {}, const std::filesystem::path& err = {});
  void send(int signal) const;
  /// [bytes] of memory that it has held at most.
  [[nodiscard]] double find_peak_memory() const;
  [[nodiscard]] bool has_ended() const;
  /// Waits for its end.
  Outcome wait();

 private:
  std::filesystem::path out_;
  std::filesystem::path err_;
  pid_t process_ = -1;
};

/// Runs it to its end with the folder as its working directory.
Outcome run_program(const TemporaryFolder& folder, const std::vector<std::string>& arguments);

/// The same through a shell, for what only a shell can set: "ulimit -f 100; exec $GUDGEON check m.toml >&-".
Outcome run_in_shell(const TemporaryFolder& folder, const std::string& script);

std::string read_text(const std::filesystem::path& file);

/// The file of that name in tests/cases, as an argument.
std::string find_case(std::string_view name);

/// The slider-crank's model file, as an argument.
std::string find_slider_crank();

}  // namespace gudgeon::test
