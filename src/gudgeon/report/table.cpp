// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Column widths and padding.
#include "gudgeon/report/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "gudgeon/base/shown_text.h"

namespace gudgeon {

namespace {

constexpr std::string_view kIndent = "  ";
constexpr std::string_view kGap = "  ";

struct CodeRange {
  char32_t first;
  char32_t last;
};

// combining marks, zero-width blanks and joiners, variation selectors
constexpr std::array kNoWidth{CodeRange{0x0300, 0x036F}, CodeRange{0x1AB0, 0x1AFF}, CodeRange{0x1DC0, 0x1DFF},
                              CodeRange{0x200B, 0x200F}, CodeRange{0x20D0, 0x20FF}, CodeRange{0xFE00, 0xFE0F}};
// Hangul, CJK, full-width forms, pictographs
constexpr std::array kTwoWide{CodeRange{0x1100, 0x115F}, CodeRange{0x2E80, 0xA4CF},   CodeRange{0xAC00, 0xD7A3},
                              CodeRange{0xF900, 0xFAFF}, CodeRange{0xFE30, 0xFE6F},   CodeRange{0xFF00, 0xFF60},
                              CodeRange{0xFFE0, 0xFFE6}, CodeRange{0x1F300, 0x1FAFF}, CodeRange{0x20000, 0x3FFFD}};

template <class Ranges>
bool is_within(char32_t code, const Ranges& ranges) {
  return std::ranges::any_of(ranges, [code](CodeRange r) { return code >= r.first && code <= r.last; });
}

std::string pad(std::string_view cell, std::size_t width, Alignment alignment) {
  const std::string blanks(width - std::min(width, find_display_width(cell)), ' ');
  return alignment == Alignment::left ? std::string(cell) + blanks : blanks + std::string(cell);
}

void trim_end(std::string& line) { line.erase(line.find_last_not_of(' ') + 1); }

}  // namespace

std::size_t find_display_width(std::string_view text) {
  std::size_t width = 0;
  while (!text.empty()) {
    const char32_t code = take_code_point(text).value_or(U'?');
    if (is_within(code, kNoWidth)) continue;
    width += is_within(code, kTwoWide) ? 2 : 1;
  }
  return width;
}

Table::Table(std::vector<TableColumn> columns) : columns_(std::move(columns)) {
  for (TableColumn& column : columns_) column.heading = show_line(column.heading);
}

void Table::add_row(std::vector<std::string> cells) {
  if (cells.size() > columns_.size()) {
    throw std::out_of_range(fmt::format("a row of {} cells in a table of {} columns", cells.size(), columns_.size()));
  }
  cells.resize(columns_.size());
  for (std::string& cell : cells) cell = show_line(cell);
  rows_.push_back(std::move(cells));
}

std::string Table::render(bool color) const {
  std::vector<std::size_t> widths;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    std::size_t width = find_display_width(columns_[c].heading);
    for (const auto& row : rows_) width = std::max(width, find_display_width(row[c]));
    widths.push_back(width);
  }
  const auto render_line = [&](auto cell_of) {
    std::string line;
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      line += c == 0 ? kIndent : kGap;
      line += pad(cell_of(c), widths[c], columns_[c].alignment);
    }
    trim_end(line);
    return line;
  };

  const std::string heading = render_line([&](std::size_t c) { return std::string_view(columns_[c].heading); });
  std::string text = color ? fmt::format("{}{}{}\n", kBold, heading, kPlain) : heading + "\n";
  for (const auto& row : rows_) text += render_line([&](std::size_t c) { return std::string_view(row[c]); }) + "\n";
  return text;
}

std::string render_title(std::string_view title, bool color) {
  const std::string shown = show_line(title);
  return color ? fmt::format("\n{}{}{}\n", kBold, shown, kPlain) : fmt::format("\n{}\n", shown);
}

}  // namespace gudgeon
