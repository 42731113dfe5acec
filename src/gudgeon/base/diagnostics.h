// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What is wrong with an input, collected so that all of it is reported at once.
//
// A check names the thing it complains about by its path in the model ("joints.A.radial_clearance"); a SourceMap,
// made by whoever read the file, turns the path into file, line and column when the diagnostics are rendered.
#pragma once

#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace gudgeon {

enum class Severity { remark, warning, error };

struct Diagnostic {
  Severity severity = Severity::error;
  std::string code;                ///< stable, "E-MODEL-012"
  std::string path;                ///< dotted path in the model; empty for the whole
  std::string message;             ///< who, the value as read and in SI, the rule
  std::vector<std::string> notes;  ///< next step, nearest valid names
  int part = -1;                   ///< [bytes] of a text the part that is meant begins here; -1 for the whole
  int part_length = 1;             ///< [bytes]
};

class Diagnostics {
 public:
  void add(Diagnostic diagnostic) { items_.push_back(std::move(diagnostic)); }
  void error(std::string code, std::string path, std::string message, std::vector<std::string> notes = {});
  void warning(std::string code, std::string path, std::string message, std::vector<std::string> notes = {});
  void remark(std::string code, std::string path, std::string message, std::vector<std::string> notes = {});
  void append(const Diagnostics& other);

  [[nodiscard]] bool has_errors() const;
  [[nodiscard]] std::span<const Diagnostic> items() const { return items_; }

 private:
  std::vector<Diagnostic> items_;
};

/// A place in a text file; line and column count from 1.
struct SourceSpan {
  int line = 0;
  int column = 0;
  int length = 1;
};

/// A model file's text and where each of its values stands.
struct SourceMap {
  std::string file;                            ///< as the user named it
  std::string text;                            ///< verbatim
  std::map<std::string, SourceSpan> spans;     ///< dotted path -> place of the value
  std::map<std::string, std::string> written;  ///< dotted path -> a single value as it was written, quotes included
  std::map<std::string, std::string> origins;  ///< dotted path -> who overrode it, "--set study.cycles=3"

  /// The place of a path or of its nearest enclosing table; nullptr when neither is known, and for a value that was
  /// overridden from outside the file.
  [[nodiscard]] const SourceSpan* find(std::string_view path) const;
  /// Who overrode a path or its nearest known enclosing table; nullptr when it stands in the file as it is.
  [[nodiscard]] const std::string* find_origin(std::string_view path) const;
};

/// All diagnostics as text, errors first and in the order of the file, each with its source line and a caret; a line
/// that counts them ends it.
std::string render(const Diagnostics& diagnostics, const SourceMap& source);

/// "frame, crank_1, rod_2"
std::string join_names(std::span<const std::string> names);

/// The candidate nearest in spelling, when it is near enough to be meant; nullptr otherwise.
const std::string* find_nearest(std::string_view name, std::span<const std::string> candidates);

/// "Did you mean 'crank_4'?", or empty when no candidate is near.
std::string suggest(std::string_view name, std::span<const std::string> candidates);

// The three kinds of failure a caller can meet. None is thrown inside the time loop.

/// The model or study is wrong; carries every diagnostic found.
class ModelError : public std::runtime_error {
 public:
  explicit ModelError(Diagnostics diagnostics);
  [[nodiscard]] const Diagnostics& diagnostics() const { return diagnostics_; }

 private:
  Diagnostics diagnostics_;
};

/// A computation could not go on.
class NumericalError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file could not be read or written.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace gudgeon
