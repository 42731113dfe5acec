// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Keys of model files that had another name. Old names are accepted for good: they are replaced before anything else
// reads the document, a path of an override or a run file, so that all other code knows the present names only.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/document.h"

namespace gudgeon {

struct OldKey {
  std::string_view table;  ///< path
  std::string_view old_key;
  std::string_view key;
};
/// All of them.
std::span<const OldKey> list_old_keys();

/// The path with its old key replaced, "study.cells" for "study.regions"; any other path as it is.
std::string find_present_path(std::string_view path);
/// The same path with each old key that its present one had.
std::vector<std::string> find_old_paths(std::string_view present_path);

/// Notes at `where` that the old path is read as the present one (R-FILE-002).
void report_old_key(const std::string& where, std::string_view old_path, Diagnostics& diagnostics);
/// Reports at `where` that both are given (E-FILE-017); `present_place` says where the present one is.
void report_both_keys(const std::string& where, std::string_view old_path, std::string_view present_place,
                      Diagnostics& diagnostics);
/// "line 12, column 1"
std::string describe_place(const SourceSpan& span);

/// Replaces the old keys in a value that stands at that present path of the model, "" for the model itself. What is
/// found is reported at `where`; an empty one stands for the old key's own path, whose place becomes that of the key.
void update_old_keys(DocumentNode& node, std::string_view path, const std::string& where, SourceMap& source,
                     Diagnostics& diagnostics);

}  // namespace gudgeon
