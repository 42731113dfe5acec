// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A model for programs that use the library: read from a file, changed by its paths, always sound.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "gudgeon/base/diagnostics.h"

namespace gudgeon {

/// One value to change, "joints.A.radial_clearance" to "0.4 mm".
struct Setting {
  std::string path;   ///< tables and key of the model file, with dots between
  std::string value;  ///< as in the model file; of a text the quotes may be left out
};

struct ModelContent;

/// A mechanism and its study without errors. Copies are cheap, and each is changed for itself; one may be read by
/// several threads.
class Model {
 public:
  explicit Model(std::shared_ptr<const ModelContent> content);

  /// Changes a value, as `--set PATH=VALUE` does. The model is checked anew: ModelError, with everything that is wrong,
  /// leaves it as it was.
  void set(std::string_view path, std::string_view value);
  /// A number without unit, "study.cycles"; ModelError also where a value needs a unit.
  void set(std::string_view path, double value);
  /// A number in that unit, a unit of the model file: 0.4, "mm".
  void set(std::string_view path, double value, std::string_view unit);
  /// Several at once, in that order, where one alone would make the model unsound.
  void set(const std::vector<Setting>& settings);

  [[nodiscard]] const std::string& name() const;
  /// The names of the cases in its file, for read_model().
  [[nodiscard]] std::vector<std::string> case_names() const;
  /// What is unwise in it, with file, line and column; empty when nothing is.
  [[nodiscard]] std::string warnings() const;
  /// The model as a file in SI with every default, as `gudgeon check --resolved` shows it.
  [[nodiscard]] std::string resolved() const;

  /// For run().
  [[nodiscard]] const ModelContent& content() const { return *content_; }

 private:
  std::shared_ptr<const ModelContent> content_;
};

/// Reads a model file (docs/guide/model_file.md), in one of its cases or without any. FileError when it cannot be read;
/// ModelError with everything that is wrong in it, what() with file, line and column.
Model read_model(const std::filesystem::path& file, std::string_view case_name = {});

/// The same from a text; the file name is the one that messages show.
Model read_model_text(std::string file_name, std::string text, std::string_view case_name = {});

}  // namespace gudgeon
