// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// rsvg-convert as a child process.
#include "gudgeon/app/picture_converter.h"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <vector>

#include "gudgeon/base/diagnostics.h"

namespace gudgeon {
namespace {

constexpr const char* kConverter = "rsvg-convert";

/// Runs a program to its end; its exit code, or -1 when it could not be started.
int run_child(std::vector<std::string> words) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = -1;
  if (::posix_spawnp(&child, arguments[0], nullptr, nullptr, arguments.data(), environ) != 0) return -1;
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

}  // namespace

void convert_picture(const std::filesystem::path& svg, const std::filesystem::path& output, const std::string& format) {
  std::vector<std::string> words{kConverter, "--format", format, "--output", output.string(), svg.string()};
  // Twice the size of the sheet: 192 pixels an inch, sharp in print and on fine screens.
  if (format == "png") words.insert(words.begin() + 1, {"--zoom", "2"});
  const int code = run_child(words);
  if (code == 0) return;
  std::error_code ignored;
  std::filesystem::remove(output, ignored);
  if (code < 0 || code == 127) {
    throw FileError(fmt::format("{} needs {}, which is not installed (Debian: librsvg2-bin); the SVG is written",
                                format, kConverter));
  }
  throw FileError(fmt::format("{}: {} ended with code {}; the SVG is kept", output.string(), kConverter, code));
}

}  // namespace gudgeon
