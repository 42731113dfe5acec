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

namespace {

// The path is given back as it was.
void add_to_source(const DocumentNode& node, std::string& path, SourceMap& source) {
  if (!path.empty()) {
    if (node.span.line > 0) source.spans[path] = node.span;
    if (!node.origin.empty()) source.origins[path] = node.origin;
  }
  const std::size_t length = path.size();
  const auto add_child = [&](const DocumentNode& child, std::string_view key) {
    if (length > 0) path += '.';
    path += key;
    add_to_source(child, path, source);
    path.resize(length);
  };
  if (const auto* table = node.table()) {
    for (const DocumentEntry& entry : *table) add_child(entry.node, entry.key);
  } else if (const auto* array = std::get_if<DocumentNode::Array>(&node.value)) {
    for (std::size_t i = 0; i < array->size(); ++i) add_child((*array)[i], fmt::format_int(i).c_str());
  } else {
    source.written[path] = node.written;
  }
}

}  // namespace

void update_source(const DocumentNode& root, SourceMap& source) {
  std::string path;
  add_to_source(root, path, source);
}

}  // namespace gudgeon
