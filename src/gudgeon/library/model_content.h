// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What a Model holds, out of the sight of those who use the library.
#pragma once

#include <memory>
#include <string>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/model_reader.h"

namespace gudgeon {

struct ModelContent {
  std::shared_ptr<const ModelDocument> document;
  ModelFile file;  ///< without errors
};

/// A ModelError in terms of the model's file: what() shows places and lines.
class PlacedModelError : public ModelError {
 public:
  PlacedModelError(const Diagnostics& diagnostics, const SourceMap& source)
      : ModelError(diagnostics), text_(std::make_shared<const std::string>(render(diagnostics, source))) {}
  [[nodiscard]] const char* what() const noexcept override { return text_->c_str(); }

 private:
  std::shared_ptr<const std::string> text_;  // shared: copying an exception must not throw
};

}  // namespace gudgeon
