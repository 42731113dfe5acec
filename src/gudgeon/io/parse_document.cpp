// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// From the TOML library's tree to ours: entries in the order of the file, columns in code points, texts as written.
#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <limits>
#include <utility>

#include "gudgeon/io/document.h"
#include "gudgeon/io/nesting.h"

namespace gudgeon {

namespace {

constexpr const char* kSyntax = "(syntax)";  // the path of what belongs to no value

/// Finds pieces of the text by line and column, which the library counts in code points.
class TextIndex {
 public:
  explicit TextIndex(std::string_view text) : text_(text) {
    lines_.push_back(0);
    for (std::size_t i = 0; i < text.size(); ++i) {
      const std::size_t code_point = i - followers_.size();
      if ((static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80U) followers_.push_back(code_point);
      if (text[i] == '\n') lines_.push_back(code_point + 1);
    }
  }

  [[nodiscard]] std::size_t offset(toml::source_position position) const {
    if (position.line == 0 || position.line > lines_.size()) return text_.size();
    const std::size_t at = lines_[position.line - 1] + std::max<std::size_t>(position.column, 1) - 1;
    const auto before = std::ranges::upper_bound(followers_, at) - followers_.begin();
    return std::min(at + static_cast<std::size_t>(before), text_.size());
  }

  [[nodiscard]] std::string slice(const toml::source_region& region) const {
    const std::size_t begin = offset(region.begin);
    const std::size_t end = std::max(begin, offset(region.end));
    std::string piece{text_.substr(begin, end - begin)};
    piece.erase(piece.find_last_not_of(" \t\r\n") + 1);
    return piece;
  }

 private:
  std::string_view text_;
  // Of every byte but the first one of its code point: how many code points are begun before it.
  std::vector<std::size_t> followers_;
  std::vector<std::size_t> lines_;  // the first code point of each
};

SourceSpan make_span(const toml::source_region& region) {
  const int line = static_cast<int>(region.begin.line);
  const int column = static_cast<int>(region.begin.column);
  const bool one_line = region.end.line == region.begin.line && region.end.column > region.begin.column;
  // A value over several lines is marked to the end of its first line; rendering cuts it there.
  return {line, column, one_line ? static_cast<int>(region.end.column) - column : 1 << 16};
}

/// A text over several lines has the line ends of its file, which mean nothing.
std::string drop_carriage_returns(std::string text) {
  for (auto at = text.find("\r\n"); at != std::string::npos; at = text.find("\r\n", at)) text.erase(at, 1);
  return text;
}

/// The library reads what is too small for a double as 0; the least number says that it was none.
double keep_from_zero(double number, std::string_view written) {
  const std::string_view digits = written.substr(0, written.find_first_of("eE"));
  const bool lost = number == 0.0 && digits.find_first_of("123456789") != std::string_view::npos;
  return lost ? std::numeric_limits<double>::denorm_min() : number;
}

DocumentNode make_node(const toml::node& from, const TextIndex& text);

DocumentNode::Table make_table(const toml::table& from, const TextIndex& text) {
  std::vector<std::pair<toml::source_position, DocumentEntry>> placed;
  for (const auto& [key, value] : from) {
    DocumentEntry entry{std::string{key.str()}, make_span(key.source()), make_node(value, text)};
    const bool under_header = value.is_array_of_tables() || (value.is_table() && !value.as_table()->is_inline());
    if (under_header) entry.node.span = entry.key_span;
    placed.emplace_back(key.source().begin, std::move(entry));
  }
  // The library sorts by name; a model file means its own order.
  std::ranges::stable_sort(placed, {}, [](const auto& item) { return std::pair{item.first.line, item.first.column}; });
  DocumentNode::Table table;
  for (auto& [position, entry] : placed) table.push_back(std::move(entry));
  return table;
}

DocumentNode make_node(const toml::node& from, const TextIndex& text) {
  DocumentNode node;
  node.span = make_span(from.source());
  node.written = text.slice(from.source());
  if (const auto* table = from.as_table()) {
    node.value = make_table(*table, text);
  } else if (const auto* array = from.as_array()) {
    DocumentNode::Array items;
    for (const toml::node& item : *array) items.push_back(make_node(item, text));
    node.value = std::move(items);
  } else if (const auto* boolean = from.as_boolean()) {
    node.value = boolean->get();
  } else if (const auto* integer = from.as_integer()) {
    node.value = static_cast<double>(integer->get());
  } else if (const auto* number = from.as_floating_point()) {
    node.value = keep_from_zero(number->get(), node.written);
  } else if (const auto* string = from.as_string()) {
    node.value = drop_carriage_returns(string->get());
  }
  return node;
}

std::string find_next_step(std::string_view error) {
  if (error.find("not representable in 64 bits") != std::string_view::npos) {
    return "whole numbers go from -9223372036854775808 to 9223372036854775807; others need a point or an exponent: "
           "1e20";
  }
  if (error.find("floating-point") != std::string_view::npos &&
      error.find("could not be interpreted") != std::string_view::npos) {
    return "numbers go up to 1.8e308 in size";
  }
  return "strings need quotes, quantities with a unit too: mass = \"148 g\"";
}

void clear_spans(DocumentNode& node) {
  node.span = {};
  if (auto* table = node.table()) {
    for (DocumentEntry& entry : *table) {
      entry.key_span = {};
      clear_spans(entry.node);
    }
  } else if (auto* array = std::get_if<DocumentNode::Array>(&node.value)) {
    for (DocumentNode& item : *array) clear_spans(item);
  }
}

}  // namespace

std::optional<DocumentNode> parse_document(SourceMap& source, Diagnostics& diagnostics) {
  if (const auto place = find_deep_nesting(source.text)) {
    source.spans[kSyntax] = {place->line, place->column, 1};
    report_deep_nesting(kSyntax, "the file", diagnostics);
    return std::nullopt;
  }
  try {
    const toml::table table = toml::parse(std::string_view{source.text}, std::string_view{source.file});
    DocumentNode root = make_node(table, TextIndex{source.text});
    check_controls(root, "", diagnostics);
    return root;
  } catch (const toml::parse_error& error) {
    const auto position = error.source().begin;
    source.spans[kSyntax] = {static_cast<int>(position.line), static_cast<int>(position.column), 1};
    diagnostics.error("E-TOML-001", kSyntax, fmt::format("this is not valid TOML: {}", error.description()),
                      {find_next_step(error.description())});
    return std::nullopt;
  }
}

DocumentNode parse_value(std::string_view text) {
  const std::string line = fmt::format("v = {}", text);
  try {
    const toml::table table = toml::parse(std::string_view{line});
    const toml::node* value = table.get("v");
    const bool one_value =
        table.size() == 1 && value != nullptr && !value->is_date() && !value->is_time() && !value->is_date_time();
    if (one_value) {
      DocumentNode node = make_node(*value, TextIndex{line});
      clear_spans(node);
      return node;
    }
  } catch (const toml::parse_error&) {
    // Not TOML, so an unquoted text: 0.3 mm.
  }
  return DocumentNode{std::string{text}, {}, fmt::format("\"{}\"", text), {}};
}

}  // namespace gudgeon
