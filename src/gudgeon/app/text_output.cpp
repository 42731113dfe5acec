// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Text to the terminal.
#include "gudgeon/app/text_output.h"

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

[[noreturn]] void fail() {
  throw FileError(fmt::format("standard output cannot be written: {}", std::strerror(errno)));
}

}  // namespace

void write_stdout(std::string_view text) {
  const std::string shown = show_controls_but_styles(text);
  if (std::fwrite(shown.data(), 1, shown.size(), stdout) != shown.size()) fail();
}

void flush_stdout() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) fail();
}

bool find_color_wanted() {
  const char* const no_color = std::getenv("NO_COLOR");
  return ::isatty(STDOUT_FILENO) && (no_color == nullptr || *no_color == '\0');
}

void write_stderr(std::string_view text) { write_display(show_controls_but_styles(text)); }

void write_display(std::string_view text) {
  std::fflush(stdout);  // a failure stays in the stream's error flag, for flush_stdout
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

}  // namespace gudgeon
