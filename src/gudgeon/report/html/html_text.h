// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// HTML, piece by piece.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gudgeon {

std::string escape_html(std::string_view text);

/// <p class="NAME">text</p>, escaped.
std::string make_paragraph(std::string_view text, std::string_view name = {});

/// A table whose first columns are text and the others numbers; it scrolls by itself where the page is narrow.
class HtmlTable {
 public:
  HtmlTable(std::string caption, std::vector<std::string> columns, std::size_t n_text_columns = 1);

  void add_row(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  [[nodiscard]] bool empty() const { return rows_.empty(); }
  /// Nothing for a table without rows.
  [[nodiscard]] std::string render() const;

 private:
  std::string caption_;
  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> rows_;
  std::size_t n_text_columns_;
};

}  // namespace gudgeon
