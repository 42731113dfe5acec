// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Reads a model file: mechanism, study and cases, checked, with everything that is wrong in it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/document.h"
#include "gudgeon/io/overrides.h"
#include "gudgeon/model/mechanism.h"
#include "gudgeon/model/study.h"

namespace gudgeon {

struct ModelFile {
  Mechanism mechanism;
  Study study;
  std::vector<Case> cases;
  SourceMap source;
  Diagnostics diagnostics;
  std::string case_name;            ///< the case that was asked for; empty for none
  std::vector<Override> overrides;  ///< those that were asked for beside the case, under present paths
};

/// A model file taken apart once, for the models of all its cases: making one takes no longer, and no more memory,
/// where there are thousands of them. Its functions may be called from several threads.
class ModelDocument {
 public:
  /// The file name appears in messages only.
  ModelDocument(std::string file_name, std::string text);

  [[nodiscard]] const std::vector<Case>& cases() const { return cases_; }
  /// The model in that case, or without any; of all cases it lists that one. What is wrong, with the file as a whole
  /// too, is in its diagnostics.
  [[nodiscard]] ModelFile read(std::string_view case_name, std::span<const Override> overrides) const;
  /// What the mechanism is called then; empty when that is no text.
  [[nodiscard]] std::string find_name(std::string_view case_name, std::span<const Override> overrides) const;

 private:
  void update_with_case(DocumentNode& root, ModelFile& model) const;
  [[nodiscard]] const Case* find_case(std::string_view name) const;

  SourceMap source_;
  Diagnostics diagnostics_;                           // of syntax and cases
  std::optional<DocumentNode> root_;                  // without the cases
  std::map<std::string, SourceSpan> reported_spans_;  // of what was reported and is not in root_
  std::vector<Case> cases_;
  std::map<std::string, std::size_t, std::less<>> case_indices_;
};

/// FileError when the file cannot be read.
ModelDocument read_model_document(const std::filesystem::path& file);

/// Reads and checks everything. What is wrong with the model, bad syntax included, is in the diagnostics; throws
/// FileError only when the file cannot be read. Overrides come after those of the named case.
ModelFile read_model(const std::filesystem::path& file, std::string_view case_name = {},
                     std::span<const Override> overrides = {});

/// The same from text in memory; the file name appears in messages only.
ModelFile read_model_text(std::string file_name, std::string text, std::string_view case_name = {},
                          std::span<const Override> overrides = {});

}  // namespace gudgeon
