// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Reads a model file: mechanism, study and cases, checked, with everything that is wrong in it.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gudgeon/base/diagnostics.h"
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
  std::vector<Override> overrides;  ///< those that were asked for beside the case
};

/// Reads and checks everything. What is wrong with the model, bad syntax included, is in the diagnostics; throws
/// FileError only when the file cannot be read. Overrides come after those of the named case.
ModelFile read_model(const std::filesystem::path& file, std::string_view case_name = {},
                     std::span<const Override> overrides = {});

/// The same from text in memory; the file name appears in messages only.
ModelFile read_model_text(std::string file_name, std::string text, std::string_view case_name = {},
                          std::span<const Override> overrides = {});

}  // namespace gudgeon
