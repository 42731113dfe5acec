// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The one table of renamed keys.
#include "gudgeon/io/old_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace gudgeon {

namespace {

constexpr std::array<OldKey, 4> kOldKeys{{
    {"study", "regions", "cells"},
    {"study", "magnification", "wear_acceleration"},
    {"study", "deposition", "wear_distribution"},
    {"study", "published", "reference"},
}};

/// The path with `from`, a key of the table, replaced; empty when the path does not lead there.
std::string replace_key(std::string_view path, std::string_view table, std::string_view from, std::string_view to) {
  const std::string whole = fmt::format("{}.{}", table, from);
  const bool leads_there = path.starts_with(whole) && (path.size() == whole.size() || path[whole.size()] == '.');
  return leads_there ? fmt::format("{}.{}{}", table, to, path.substr(whole.size())) : std::string{};
}

/// The table of that path, in a node that stands at `path`; nullptr when it is not there.
DocumentNode::Table* find_table(DocumentNode& node, std::string_view path, std::string_view wanted) {
  if (path == wanted) return node.table();
  const std::string start = path.empty() ? std::string{} : fmt::format("{}.", path);
  if (node.table() == nullptr || !wanted.starts_with(start)) return nullptr;
  for (DocumentEntry& entry : *node.table()) {
    const std::string child = start + entry.key;
    if (wanted != child && !wanted.starts_with(child + ".")) continue;
    return find_table(entry.node, child, wanted);
  }
  return nullptr;
}

}  // namespace

std::span<const OldKey> list_old_keys() { return kOldKeys; }

std::string find_present_path(std::string_view path) {
  for (const OldKey& one : kOldKeys) {
    std::string present = replace_key(path, one.table, one.old_key, one.key);
    if (!present.empty()) return present;
  }
  return std::string{path};
}

std::vector<std::string> find_old_paths(std::string_view present_path) {
  std::vector<std::string> paths;
  for (const OldKey& one : kOldKeys) {
    std::string old = replace_key(present_path, one.table, one.key, one.old_key);
    if (!old.empty()) paths.push_back(std::move(old));
  }
  return paths;
}

std::string describe_place(const SourceSpan& span) { return fmt::format("line {}, column {}", span.line, span.column); }

void report_old_key(const std::string& where, std::string_view old_path, Diagnostics& diagnostics) {
  diagnostics.remark("R-FILE-002", where, fmt::format("'{}' is now called '{}'", old_path, find_present_path(old_path)),
                     {"the old name is still read; write the new one"});
}

void report_both_keys(const std::string& where, std::string_view old_path, std::string_view present_place,
                      Diagnostics& diagnostics) {
  const std::string present_path = find_present_path(old_path);
  diagnostics.error("E-FILE-017", where,
                    fmt::format("'{}' is the old name of '{}', and both are given", old_path, present_path),
                    {fmt::format("'{}' is given at {}; remove '{}'", present_path, present_place, old_path)});
}

void update_old_keys(DocumentNode& node, std::string_view path, const std::string& where, SourceMap& source,
                     Diagnostics& diagnostics) {
  for (const OldKey& one : kOldKeys) {
    DocumentNode::Table* table = find_table(node, path, one.table);
    if (table == nullptr) continue;
    const auto old = std::ranges::find(*table, one.old_key, &DocumentEntry::key);
    if (old == table->end()) continue;
    const std::string old_path = fmt::format("{}.{}", one.table, one.old_key);
    if (where.empty() && old->key_span.line > 0) source.spans[old_path] = old->key_span;
    const std::string& shown = where.empty() ? old_path : where;
    const auto present = std::ranges::find(*table, one.key, &DocumentEntry::key);
    if (present == table->end()) {
      report_old_key(shown, old_path, diagnostics);
      old->key = one.key;
    } else {
      const bool placed = present->key_span.line > 0;
      report_both_keys(shown, old_path, placed ? describe_place(present->key_span) : "the same place", diagnostics);
      table->erase(old);
    }
  }
}

}  // namespace gudgeon
