// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Look-ups in a document, and its entries for the source map.
#include "gudgeon/io/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "gudgeon/base/shown_text.h"
#include "gudgeon/io/nesting.h"

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
                                                          "a string",       "an array",      "a table"};
  return kNames[node.value.index()];
}

void report_deep_nesting(const std::string& path, std::string_view what, Diagnostics& diagnostics) {
  diagnostics.error(
      "E-TOML-002", path,
      fmt::format("{} nests deeper than {} levels here: tables and arrays within one another", what, kDeepestNesting),
      {"a key is as deep as it has parts, a.b.c three levels; no value of a model is deeper than seven"});
}

namespace {

void check_control(std::string_view text, std::string_view what, const std::string& path, const std::string& control,
                   Diagnostics& diagnostics) {
  if (control.empty()) return;
  diagnostics.error("E-FILE-015", path, fmt::format("{} \"{}\" contains the control character {}", what, text, control),
                    {"names and texts are made of visible characters, blanks, tabs and newlines; leave it out"});
}

/// Keys are names, on one line.
std::string find_control_of_key(std::string_view key) {
  const std::size_t at = key.find_first_of("\t\n");
  if (at == std::string_view::npos) return find_control(key);
  return key[at] == '\t' ? "U+0009" : "U+000A";
}

// The path is given back as it was.
void check_controls_below(const DocumentNode& node, std::string& path, Diagnostics& diagnostics) {
  if (const auto* text = std::get_if<std::string>(&node.value)) {
    check_control(*text, "the string", path, find_control(*text), diagnostics);
  }
  const std::size_t length = path.size();
  const auto enter = [&](const DocumentNode& child, std::string_view key) {
    if (length > 0) path += '.';
    path += key;
    check_controls_below(child, path, diagnostics);
  };
  if (const auto* table = node.table()) {
    for (const DocumentEntry& entry : *table) {
      enter(entry.node, entry.key);
      check_control(entry.key, "the key", path, find_control_of_key(entry.key), diagnostics);
      path.resize(length);
    }
  } else if (const auto* array = std::get_if<DocumentNode::Array>(&node.value)) {
    for (std::size_t i = 0; i < array->size(); ++i) {
      enter((*array)[i], fmt::format_int(i).c_str());
      path.resize(length);
    }
  }
}

}  // namespace

void check_controls(const DocumentNode& node, const std::string& path, Diagnostics& diagnostics) {
  std::string below = path;
  check_controls_below(node, below, diagnostics);
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
