// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Text to the terminal.
#include "gudgeon/app/text_output.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/base/shown_text.h"
#include "gudgeon/report/table.h"

namespace gudgeon {
namespace {

/// Of all control sequences only our own styles reach a terminal.
std::string show_controls_but_styles(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t at = std::min(text.find(kBold), text.find(kPlain));
    shown += show_controls(text.substr(0, at));
    if (at == std::string_view::npos) break;
    const std::string_view style = text.substr(at).starts_with(kBold) ? kBold : kPlain;
    shown += style;
    text.remove_prefix(at + style.size());
  }
  return shown;
}

// Whether standard output was closed when the program began.
bool is_output_closed = false;

bool is_closed(int descriptor) { return ::fcntl(descriptor, F_GETFD) == -1 && errno == EBADF; }

[[noreturn]] void fail() {
  throw FileError(fmt::format("standard output cannot be written: {}", std::strerror(errno)));
}

}  // namespace

void open_closed_streams() {
  is_output_closed = is_closed(STDOUT_FILENO);
  // In their order: each gets the lowest free number, its own.
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (!is_closed(descriptor)) continue;
    if (::open("/dev/null", descriptor == STDIN_FILENO ? O_RDONLY : O_WRONLY) == descriptor) continue;
    throw FileError(fmt::format("/dev/null cannot be opened in place of the closed descriptor {}: {}", descriptor,
                                std::strerror(errno)));
  }
}

void write_stdout(std::string_view text) {
  if (is_output_closed) {
    throw FileError("standard output is closed, and what was asked for is written there; open it, to a file or a pipe");
  }
  const std::string shown = show_controls_but_styles(text);
  if (std::fwrite(shown.data(), 1, shown.size(), stdout) != shown.size()) fail();
}

void write_receipt(std::string_view text) {
  if (!is_output_closed) write_stdout(text);
}

void flush_stdout() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) fail();
}

bool find_color_wanted() {
  const char* const no_color = std::getenv("NO_COLOR");
  return ::isatty(STDOUT_FILENO) && (no_color == nullptr || *no_color == '\0');
}

ExitCode print_listing(std::string_view text, std::string_view complaint, std::string_view next_step) {
  if (!text.empty()) {
    write_stdout(text);
    return ExitCode::done;
  }
  write_stderr(fmt::format("gudgeon: {}{}{}\n", complaint, next_step.empty() ? "" : " ", next_step));
  return ExitCode::usage;
}

void write_stderr(std::string_view text) { write_display(show_controls_but_styles(text)); }

void write_display(std::string_view text) {
  std::fflush(stdout);  // a failure stays in the stream's error flag, for flush_stdout
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

}  // namespace gudgeon
