// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Look-ups in a document, and its entries for the source map.
#include "gudgeon/io/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace gudgeon {

const DocumentNode* find_node(const DocumentNode::Table& table, std::string_view key) {
  const auto found = std::ranges::find(table, key, &DocumentEntry::key);
  return found == table.end() ? nullptr : &found->node;
}

DocumentNode* find_node(DocumentNode::Table& table, std::string_view key) {
  const auto found = std::ranges::find(table, key, &DocumentEntry::key);
  return found == table.end() ? nullptr : &found->node;
}

std::string_view kind_name(const DocumentNode& node) {
  static constexpr std::array<std::string_view, 6> kNames{"a date or time", "true or false", "a number",
                                                          "a text",         "an array",      "a table"};
  return kNames[node.value.index()];
}

void update_source(const DocumentNode& node, const std::string& path, SourceMap& source) {
  if (!path.empty()) {
    if (node.span.line > 0) source.spans[path] = node.span;
    if (!node.origin.empty()) source.origins[path] = node.origin;
  }
  const std::string prefix = path.empty() ? "" : path + ".";
  if (const auto* table = node.table()) {
    for (const DocumentEntry& entry : *table) update_source(entry.node, prefix + entry.key, source);
  } else if (const auto* array = std::get_if<DocumentNode::Array>(&node.value)) {
    for (std::size_t i = 0; i < array->size(); ++i) update_source((*array)[i], fmt::format("{}{}", prefix, i), source);
  } else {
    source.written[path] = node.written;
  }
}

}  // namespace gudgeon
