// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Tables for a terminal.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gudgeon {

/// What a terminal is told for bold type and back.
inline constexpr std::string_view kBold = "\033[1m";
inline constexpr std::string_view kPlain = "\033[0m";

enum class Alignment { left, right };

struct TableColumn {
  std::string heading;
  Alignment alignment = Alignment::left;
};

/// Rows of text under headings, each column as wide as its widest cell. Whatever a text holds, a row is one line.
///
///     stage     status    cycles
///     ideal     finished      10
class Table {
 public:
  explicit Table(std::vector<TableColumn> columns);

  /// Missing cells are empty; cells without a column are a mistake (std::out_of_range).
  void add_row(std::vector<std::string> cells);
  [[nodiscard]] bool empty() const { return rows_.empty(); }
  /// Every line indented by two blanks and ended by a newline; with color the headings are bold.
  [[nodiscard]] std::string render(bool color) const;

 private:
  std::vector<TableColumn> columns_;
  std::vector<std::vector<std::string>> rows_;
};

/// A title of one line, bold with color, with an empty line before it.
std::string render_title(std::string_view title, bool color);

/// Columns a UTF-8 text takes on a terminal: combining marks none, East Asian wide letters two.
std::size_t find_display_width(std::string_view text);

}  // namespace gudgeon
