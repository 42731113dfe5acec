// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Walks dotted paths through a document and replaces what it finds there.
#include "gudgeon/io/overrides.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "gudgeon/io/nesting.h"
#include "gudgeon/io/old_keys.h"
#include "gudgeon/io/table_reader.h"

namespace gudgeon {

namespace {

/// The item of an array by its index in text; nullptr when there is none.
DocumentNode* find_item(DocumentNode::Array& array, std::string_view text) {
  std::size_t index = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), index);
  const bool whole = code == std::errc{} && end == text.data() + text.size();
  return whole && index < array.size() ? &array[index] : nullptr;
}

DocumentNode* find_child(DocumentNode& node, std::string_view key) {
  if (auto* table = node.table()) return find_node(*table, key);
  if (auto* array = std::get_if<DocumentNode::Array>(&node.value)) return find_item(*array, key);
  return nullptr;
}

// Tables that a model may leave out, and that an override may therefore begin.
bool is_optional_table(std::string_view path, std::string_view key) {
  return (path.empty() && key == "study") || key == "start";
}

/// The node that holds the last part of the path; nullptr when there is no such node.
DocumentNode* find_holder(DocumentNode& root, std::string_view path) {
  DocumentNode* node = &root;
  std::size_t begin = 0;
  for (auto dot = path.find('.'); dot != std::string_view::npos; dot = path.find('.', begin)) {
    const std::string_view key = path.substr(begin, dot - begin);
    DocumentNode* child = find_child(*node, key);
    if (child == nullptr && node->table() != nullptr && is_optional_table(path.substr(0, begin), key)) {
      node->table()->push_back({std::string{key}, {}, {DocumentNode::Table{}, {}, {}, {}}});
      child = &node->table()->back().node;
    }
    if (child == nullptr) return nullptr;
    node = child;
    begin = dot + 1;
  }
  return node;
}

void list_paths(const DocumentNode& node, const std::string& path, std::vector<std::string>& paths) {
  if (!path.empty()) paths.push_back(path);
  if (node.table() == nullptr) return;
  for (const DocumentEntry& entry : *node.table()) {
    list_paths(entry.node, path.empty() ? entry.key : path + "." + entry.key, paths);
  }
}

/// The path that complaints about the override itself have.
std::string register_override(const Override& change, const std::string& origin, const SourceSpan& span,
                              SourceMap& source) {
  const std::string where = fmt::format("(override {})", change.path);
  source.origins[where] = origin;
  if (span.line > 0) source.spans[where] = span;
  return where;
}

void report_no_path(const DocumentNode& root, const Override& change, const std::string& origin, const SourceSpan& span,
                    SourceMap& source, Diagnostics& diagnostics) {
  std::vector<std::string> paths;
  list_paths(root, "", paths);
  const std::string where = register_override(change, origin, span, source);
  std::vector<std::string> notes;
  const std::string suggestion = suggest(change.path, paths);
  if (!suggestion.empty()) notes.push_back(suggestion);
  diagnostics.error("E-FILE-010", where, fmt::format("the model has nothing at '{}'", change.path), notes);
}

/// An override of a case as it stands in the file.
struct WrittenOverride {
  std::string path;
  const DocumentEntry* entry;
};

/// Collects "a.b.c" = value; a key with a dot names its path itself, tables under other keys are entered.
void collect_overrides(const DocumentNode& node, const std::string& prefix, std::vector<WrittenOverride>& into) {
  for (const DocumentEntry& entry : *node.table()) {
    const std::string path = prefix + entry.key;
    const bool names_path = entry.key.find('.') != std::string::npos;
    if (entry.node.table() != nullptr && !names_path) {
      collect_overrides(entry.node, path + ".", into);
    } else {
      into.push_back({path, &entry});
    }
  }
}

/// Notes under which path the override stands in the file when that is an old one, and whether the present one is
/// there as well.
void note_old_path(const WrittenOverride& one, const std::string& present_path, std::string_view set_path,
                   const std::vector<WrittenOverride>& all, ReadLog& log) {
  const std::string where = fmt::format("{}.{}", set_path, one.path);
  log.source.spans[where] = one.entry->key_span;
  log.source.spans[fmt::format("{}.{}", set_path, present_path)] = one.entry->node.span;
  const auto both = std::ranges::find(all, present_path, &WrittenOverride::path);
  if (both == all.end()) return;
  report_both_keys(where, one.path, describe_place(both->entry->key_span), log.diagnostics);
}

/// The overrides of a case, under their present paths.
void read_overrides(const DocumentNode& set, std::string_view set_path, Case& into, ReadLog& log) {
  std::vector<WrittenOverride> all;
  collect_overrides(set, "", all);
  for (const WrittenOverride& one : all) {
    const std::string path = find_present_path(one.path);
    if (path != one.path) note_old_path(one, path, set_path, all, log);
    const auto* text = std::get_if<std::string>(&one.entry->node.value);
    into.overrides.emplace_back(path, text != nullptr ? *text : one.entry->node.written);
  }
}

}  // namespace

std::vector<Case> read_cases(const DocumentNode& root, SourceMap& source, Diagnostics& diagnostics) {
  std::vector<Case> cases;
  const DocumentNode* node = root.table() == nullptr ? nullptr : find_node(*root.table(), "cases");
  if (node == nullptr) return cases;
  ReadLog log{source, diagnostics};
  for (const DocumentEntry& entry : TableReader{*node, "cases", "cases", log}.entries()) {
    Case read{entry.key, {}, {}};
    TableReader table{entry.node, "cases." + entry.key, fmt::format("case '{}'", entry.key), log};
    read.description = table.find_text("description").value_or("");
    if (const DocumentNode* set = table.find_required("set")) {
      if (set->table() != nullptr)
        read_overrides(*set, table.path_of("set"), read, log);
      else
        table.report("E-FILE-003", "set", "set must be a table of paths and values");
    }
    table.check_unknown_keys();
    cases.push_back(std::move(read));
  }
  return cases;
}

void update_document(DocumentNode& root, const Override& change, const std::string& origin, const SourceSpan& span,
                     SourceMap& source, Diagnostics& diagnostics) {
  if (find_deep_nesting(change.value)) {
    const std::string where = register_override(change, origin, span, source);
    return report_deep_nesting(where, fmt::format("the value given to '{}'", change.path), diagnostics);
  }
  DocumentNode value = parse_value(change.value);
  value.span = span;
  value.origin = origin;
  check_controls(value, change.path, diagnostics);
  if (value.table() != nullptr) {
    update_old_keys(value, change.path, register_override(change, origin, span, source), source, diagnostics);
  }
  DocumentNode* holder = find_holder(root, change.path);
  const std::string key = change.path.substr(change.path.rfind('.') + 1);
  DocumentNode* old = holder == nullptr || key.empty() ? nullptr : find_child(*holder, key);
  if (old != nullptr) {
    *old = std::move(value);
  } else if (holder != nullptr && holder->table() != nullptr && !key.empty()) {
    holder->table()->push_back({key, span, std::move(value)});
  } else {
    report_no_path(root, change, origin, span, source, diagnostics);
  }
}

}  // namespace gudgeon
