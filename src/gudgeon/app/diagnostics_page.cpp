// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One list, two ways to print it.
#include "gudgeon/app/diagnostics_page.h"

#include <fmt/format.h>

#include <array>

#include "gudgeon/base/diagnostic_list.h"

namespace gudgeon {

namespace {

/// A heading of the page, and which codes stand under it.
struct Group {
  std::string_view heading;
  std::string_view about;  // in codes, "MODEL"
  std::string_view introduction;
};

constexpr std::array<Group, 5> kGroups{{
    {"Reading", "TOML", ""},
    {"", "FILE", ""},
    {"Mechanism", "MODEL", ""},
    {"Study", "STUDY", ""},
    {"Runs", "NUM",
     "A run that cannot go on keeps what it has; the stage's record and the last line of the output say why."},
}};

bool is_about(const DiagnosticEntry& entry, std::string_view about) {
  return entry.code.substr(2).starts_with(about) && entry.code[2 + about.size()] == '-';
}

}  // namespace

std::string render_diagnostics_page() {
  std::string text =
      "# Diagnostics\n\nEvery message about a model or run has a stable code. E- stops, W- warns, R- remarks. `gudgeon "
      "diagnostics E-MODEL-013` prints\nwhat one means, `gudgeon diagnostics --markdown` this page. Long values are "
      "cut "
      "in the middle, and control characters are shown as\n`\\u001B`, so that nothing in a file commands the "
      "terminal.\n";
  for (const Group& group : kGroups) {
    if (!group.heading.empty()) {
      text += fmt::format("\n## {}\n\n", group.heading);
      if (!group.introduction.empty()) text += fmt::format("{}\n\n", group.introduction);
      text += "| code | meaning |\n|---|---|\n";
    }
    for (const DiagnosticEntry& entry : list_diagnostics()) {
      if (is_about(entry, group.about)) text += fmt::format("| {} | {} |\n", entry.code, entry.meaning);
    }
  }
  return text;
}

std::string render_diagnostics(std::string_view code) {
  std::string text;
  for (const DiagnosticEntry& entry : list_diagnostics()) {
    if (!entry.code.starts_with(code)) continue;
    text += fmt::format("{:<12} {:<8} {}\n", entry.code, severity_of(entry.code), entry.meaning);
  }
  return text;
}

}  // namespace gudgeon
