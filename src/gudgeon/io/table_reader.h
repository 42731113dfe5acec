// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Reads one table of a document key by key. What is wrong becomes a diagnostic, never an exception; keys that nobody
// asked for are reported at the end.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/base/quantity.h"
#include "gudgeon/base/vec2.h"
#include "gudgeon/io/document.h"

namespace gudgeon {

/// Where a reader puts what it finds wrong.
struct ReadLog {
  SourceMap& source;
  Diagnostics& diagnostics;
};

/// Whether a value may be so small that its square is no number: an entry of a curve may, the tail of a peak.
enum class Smallness { bounded, any };

/// The quantity of a node: a bare number is in SI, a text has its unit; without a dimension every one is right. Reports
/// what is wrong under the path; the label names the value for the user, "joint 'A': width".
std::optional<double> read_quantity(const DocumentNode& node, std::optional<Dimension> dimension,
                                    const std::string& path, const std::string& label, ReadLog& log,
                                    Smallness smallness = Smallness::bounded);

/// Reports a name that is none of the possible ones, with the nearest of them.
void report_choice(std::string_view code, const std::string& path, const std::string& message, std::string_view name,
                   std::span<const std::string> possible, ReadLog& log);

class TableReader {
 public:
  /// The subject names the table in messages: "joint 'A'".
  TableReader(const DocumentNode& node, std::string path, std::string subject, ReadLog& log);

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] const std::string& subject() const { return subject_; }
  [[nodiscard]] std::string path_of(std::string_view key) const;
  [[nodiscard]] ReadLog& log() const { return *log_; }
  /// All entries, for tables whose keys are names; none when the node is no table.
  [[nodiscard]] const DocumentNode::Table& entries() const;

  [[nodiscard]] bool has(std::string_view key) const;
  /// The node of a key, which counts as known from now on; nullptr when absent.
  const DocumentNode* find(std::string_view key);
  /// The same, reported when absent.
  const DocumentNode* find_required(std::string_view key);

  std::optional<std::string> find_text(std::string_view key);
  std::string read_text(std::string_view key);  ///< required
  /// The same, and nothing where it is missing or no text, which has been reported.
  std::optional<std::string> read_name(std::string_view key);
  std::optional<double> find_quantity(std::string_view key, Dimension dimension);
  double read_quantity(std::string_view key, Dimension dimension);  ///< required; NaN when it cannot be read
  std::optional<Vec2> find_vector(std::string_view key, Dimension dimension);
  /// Two quantities in an array; nothing when they cannot be read.
  std::optional<Vec2> read_vector(const DocumentNode& node, const std::string& path, Dimension dimension);
  std::optional<int> find_count(std::string_view key);
  std::optional<bool> find_switch(std::string_view key);
  std::optional<TableReader> find_table(std::string_view key, std::string subject);

  /// A choice among named values; reported when it is none of them.
  template <class Value>
  void update_choice(std::string_view key, std::span<const std::pair<std::string_view, Value>> choices, Value& value) {
    const std::optional<std::string> name = find_text(key);
    if (!name) return;
    std::vector<std::string> names;
    for (const auto& [choice_name, choice] : choices) {
      if (choice_name == *name) return void(value = choice);
      names.emplace_back(choice_name);
    }
    report_unknown_choice(key, *name, names);
  }

  /// True when both keys are there and the first was set later: by a case over the file, by --set over a case.
  [[nodiscard]] bool is_newer(std::string_view key, std::string_view than) const;

  /// Reports that a text is none of the possible ones.
  void report_unknown_choice(std::string_view key, std::string_view name, std::span<const std::string> possible);
  /// Reports an error under a key of this table, the subject before the message.
  void report(std::string_view code, std::string_view key, std::string_view message,
              std::vector<std::string> notes = {});
  /// Reports every key that was not asked for.
  void check_unknown_keys();

 private:
  const DocumentNode* node_;
  std::string path_;
  std::string subject_;
  ReadLog* log_;
  std::vector<std::string> known_;
};

}  // namespace gudgeon
