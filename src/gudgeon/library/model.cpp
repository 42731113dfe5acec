// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A model is read anew from its document with every change: what it then is, is what the program makes of --set.
#include "gudgeon/library/model.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "gudgeon/io/resolved_model.h"
#include "gudgeon/library/model_content.h"

namespace gudgeon {
namespace {

std::shared_ptr<const ModelContent> read_content(std::shared_ptr<const ModelDocument> document,
                                                 std::string_view case_name, std::span<const Override> changes) {
  ModelFile file = document->read(case_name, changes);
  if (file.diagnostics.has_errors()) throw PlacedModelError(file.diagnostics, file.source);
  return std::make_shared<const ModelContent>(ModelContent{std::move(document), std::move(file)});
}

bool overlap(const Override& a, const Override& b) { return a.path.starts_with(b.path) || b.path.starts_with(a.path); }

/// Puts the change last. An earlier one of the same path goes, so that a loop over a value does not collect them,
/// unless a later one may depend on it.
void update_changes(std::vector<Override>& changes, Override change) {
  const auto earlier = std::ranges::find(changes, change.path, &Override::path);
  if (earlier != changes.end() &&
      std::none_of(earlier + 1, changes.end(), [&](const Override& later) { return overlap(later, change); })) {
    changes.erase(earlier);
  }
  changes.push_back(std::move(change));
}

}  // namespace

Model::Model(std::shared_ptr<const ModelContent> content) : content_(std::move(content)) {}

void Model::set(std::string_view path, std::string_view value) {
  set(std::vector{Setting{std::string{path}, std::string{value}}});
}

void Model::set(std::string_view path, double value) { set(path, fmt::format("{}", value)); }

void Model::set(std::string_view path, double value, std::string_view unit) {
  set(path, fmt::format("{} {}", value, unit));
}

void Model::set(const std::vector<Setting>& settings) {
  std::vector<Override> changes = content_->file.overrides;
  for (const Setting& setting : settings) update_changes(changes, {setting.path, setting.value});
  content_ = read_content(content_->document, content_->file.case_name, changes);
}

const std::string& Model::name() const { return content_->file.mechanism.name; }

std::vector<std::string> Model::case_names() const {
  std::vector<std::string> names;
  for (const Case& one : content_->document->cases()) names.push_back(one.name);
  return names;
}

std::string Model::warnings() const { return render(content_->file.diagnostics, content_->file.source); }

std::string Model::resolved() const { return write_resolved_model(content_->file.mechanism, content_->file.study); }

Model read_model(const std::filesystem::path& file, std::string_view case_name) {
  return Model(read_content(std::make_shared<const ModelDocument>(read_model_document(file)), case_name, {}));
}

Model read_model_text(std::string file_name, std::string text, std::string_view case_name) {
  return Model(
      read_content(std::make_shared<const ModelDocument>(std::move(file_name), std::move(text)), case_name, {}));
}

}  // namespace gudgeon
