// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Escaping and tables.
#include "gudgeon/report/html/html_text.h"

#include <fmt/format.h>

#include "gudgeon/base/shown_text.h"
#include "gudgeon/report/figures/display_unit.h"

namespace gudgeon {

std::string escape_html(std::string_view text) {
  std::string escaped;
  for (const char c : show_controls(text)) {
    if (c == '&') {
      escaped += "&amp;";
    } else if (c == '<') {
      escaped += "&lt;";
    } else if (c == '>') {
      escaped += "&gt;";
    } else if (c == '"') {
      escaped += "&quot;";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

std::string make_paragraph(std::string_view text, std::string_view name) {
  if (name.empty()) return fmt::format("<p>{}</p>\n", escape_html(text));
  return fmt::format("<p class=\"{}\">{}</p>\n", name, escape_html(text));
}

namespace {

/// [bytes] a cell of more is a text that breaks into lines.
constexpr std::size_t kLongCell = 32;

/// A true minus sign and raised exponents: "−606.1 m/s²".
std::string print_number_cell(const std::string& cell) {
  std::string text;
  for (std::size_t k = 0; k < cell.size(); ++k) {
    text += cell[k] == '-' && (k == 0 || cell[k - 1] == ' ') && k + 1 < cell.size() && cell[k + 1] != ' '
                ? std::string("−")
                : std::string(1, cell[k]);
  }
  return print_unit(text);
}

}  // namespace

HtmlTable::HtmlTable(std::string caption, std::vector<std::string> columns, std::size_t n_text_columns)
    : caption_(std::move(caption)), columns_(std::move(columns)), n_text_columns_(n_text_columns) {}

std::string HtmlTable::render() const {
  if (rows_.empty()) return {};
  std::string html = fmt::format(
      "<div class=\"table\" role=\"region\" tabindex=\"0\" aria-label=\"{0}\"><table><caption>{0}</caption><thead><tr>",
      escape_html(caption_));
  const auto name_class = [&](std::size_t k) { return k < n_text_columns_ ? "" : " class=\"number\""; };
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    html += fmt::format("<th scope=\"col\"{}>{}</th>", name_class(k), escape_html(columns_[k]));
  }
  html += "</tr></thead><tbody>\n";
  for (const std::vector<std::string>& row : rows_) {
    html += "<tr>";
    for (std::size_t k = 0; k < row.size(); ++k) {
      html += k == 0 ? fmt::format("<th scope=\"row\">{}</th>", escape_html(row[k]))
                     : fmt::format("<td{}>{}</td>", row[k].size() > kLongCell ? " class=\"long\"" : name_class(k),
                                   escape_html(k < n_text_columns_ ? row[k] : print_number_cell(row[k])));
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace gudgeon
