// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Line by line: the TOML library drops comments.
#include "gudgeon/io/model_remarks.h"

#include <algorithm>
#include <cctype>

#include "gudgeon/io/old_keys.h"

namespace gudgeon {

namespace {

std::string_view trim_blanks(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Calls visit(line) for each line.
template <class Visit>
void for_each_line(std::string_view text, Visit visit) {
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    visit(trim_blanks(text.substr(0, end)));
    if (end == std::string_view::npos) return;
    text.remove_prefix(end + 1);
  }
}

/// Where the comment of a line begins; npos for none. A '#' within quotes is none.
std::size_t find_comment(std::string_view line) {
  char quote = '\0';
  for (std::size_t k = 0; k < line.size(); ++k) {
    if (quote == '"' && line[k] == '\\') {
      ++k;
    } else if (quote != '\0') {
      if (line[k] == quote) quote = '\0';
    } else if (line[k] == '"' || line[k] == '\'') {
      quote = line[k];
    } else if (line[k] == '#') {
      return k;
    }
  }
  return std::string_view::npos;
}

std::string drop_quotes(std::string_view text) {
  std::string plain(trim_blanks(text));
  std::erase(plain, '"');
  return plain;
}

/// "[joints.A]" and "[[study.reference]]" as their paths.
std::string read_header_path(std::string_view header) {
  const std::size_t first = header.find_first_not_of('[');
  const std::size_t end = header.find(']');
  if (first == std::string_view::npos || end == std::string_view::npos || end < first) return {};
  return std::string(trim_blanks(header.substr(first, end - first)));
}

}  // namespace

std::vector<ModelRemark> find_remarks(std::string_view model_text) {
  std::vector<ModelRemark> remarks;
  std::string table;
  for_each_line(model_text, [&](std::string_view line) {
    const std::size_t comment = find_comment(line);
    const std::string_view code = trim_blanks(line.substr(0, comment));
    if (code.starts_with('[')) table = read_header_path(code);
    const bool has_remark = comment != std::string_view::npos && !code.empty();
    if (!has_remark || table == "cases" || table.starts_with("cases.")) return;
    const std::string remark(trim_blanks(line.substr(comment + 1)));
    if (code.starts_with('[')) {
      remarks.push_back({find_present_path(table), "", remark});
      return;
    }
    const std::size_t equals = code.find('=');
    if (equals == std::string_view::npos) return;  // within a value of several lines
    const std::string key = drop_quotes(code.substr(0, equals));
    remarks.push_back(
        {find_present_path(table.empty() ? key : table + "." + key), drop_quotes(code.substr(equals + 1)), remark});
  });
  return remarks;
}

std::vector<RemarkLetter> find_remark_letters(std::string_view model_text) {
  static constexpr std::string_view kBetween = "·";
  std::vector<RemarkLetter> letters;
  for_each_line(model_text, [&](std::string_view line) {
    if (!letters.empty() || !line.starts_with('#') || line.find(kBetween) == std::string_view::npos) return;
    std::string_view rest = line.substr(1);
    std::vector<RemarkLetter> found;
    while (!rest.empty()) {
      const std::size_t end = rest.find(kBetween);
      const std::string_view part = trim_blanks(rest.substr(0, end));
      const bool explains = part.size() > 2 && std::isupper(static_cast<unsigned char>(part[0])) != 0 && part[1] == ' ';
      if (!explains) return;
      found.push_back({std::string(part.substr(0, 1)), std::string(trim_blanks(part.substr(2)))});
      if (end == std::string_view::npos) break;
      rest.remove_prefix(end + kBetween.size());
    }
    letters = std::move(found);
  });
  return letters;
}

}  // namespace gudgeon
