// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A TOML document as a plain tree in the order of the file, every value with its place. Only parse_document.cpp
// knows the TOML library.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "gudgeon/base/diagnostics.h"

namespace gudgeon {

struct DocumentEntry;

/// One value of the document.
struct DocumentNode {
  using Array = std::vector<DocumentNode>;
  using Table = std::vector<DocumentEntry>;

  /// monostate is a kind that no model file uses: a date or a time.
  std::variant<std::monostate, bool, double, std::string, Array, Table> value;
  SourceSpan span;      ///< of the value; of its name for a table under a [header]; line 0 when not from the file
  std::string written;  ///< as it stands in the file, without comments
  std::string origin;   ///< who overrode it; empty when it stands in the file as it is

  [[nodiscard]] const Table* table() const { return std::get_if<Table>(&value); }
  [[nodiscard]] Table* table() { return std::get_if<Table>(&value); }
};

struct DocumentEntry {
  std::string key;
  SourceSpan key_span;
  DocumentNode node;
};

/// The value of a key; nullptr when the table has no such key.
const DocumentNode* find_node(const DocumentNode::Table& table, std::string_view key);
DocumentNode* find_node(DocumentNode::Table& table, std::string_view key);

/// What a value is, in words: "a string", "a table" …
std::string_view kind_name(const DocumentNode& node);

/// A TOML document as a table. Bad syntax adds an error E-TOML-001, tables that nest too deep E-TOML-002, registered in
/// source.spans at its line and column, and return nothing.
std::optional<DocumentNode> parse_document(SourceMap& source, Diagnostics& diagnostics);

/// A single TOML value: number, bool, quoted text, array or inline table. Anything else is taken as an unquoted text.
DocumentNode parse_value(std::string_view text);

/// Reports E-TOML-002 of what nests too deep, "the file".
void report_deep_nesting(const std::string& path, std::string_view what, Diagnostics& diagnostics);

/// Reports every key and text under the path that holds a control character other than newline and tab: on a terminal
/// it would act instead of being shown.
void check_controls(const DocumentNode& node, const std::string& path, Diagnostics& diagnostics);

/// Registers the places and texts of all values of a document in the source map, under their dotted paths.
void update_source(const DocumentNode& root, SourceMap& source);

}  // namespace gudgeon
