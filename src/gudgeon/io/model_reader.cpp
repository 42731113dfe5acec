// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The way from text to a checked model: parse, override, read section by section, check.
#include "gudgeon/io/model_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <utility>

#include "gudgeon/io/field_reader.h"
#include "gudgeon/io/old_keys.h"
#include "gudgeon/io/read_sections.h"
#include "gudgeon/io/table_reader.h"
#include "gudgeon/model/check.h"

namespace gudgeon {

namespace {

/// The overrides that were asked for, under their present paths.
void update_with_overrides(DocumentNode& root, std::span<const Override> given, ModelFile& model) {
  for (const Override& one : given) {
    const std::string origin = fmt::format("--set {}={}", one.path, one.value);
    const Override& change = model.overrides.emplace_back(Override{find_present_path(one.path), one.value});
    if (change.path != one.path) {
      const std::string where = fmt::format("(override {})", one.path);
      model.source.origins[where] = origin;
      const auto both = std::ranges::find(given, change.path, &Override::path);
      if (both == given.end()) {
        report_old_key(where, one.path, model.diagnostics);
      } else {
        report_both_keys(where, one.path, fmt::format("--set {}={}", both->path, both->value), model.diagnostics);
      }
    }
    update_document(root, change, origin, {}, model.source, model.diagnostics);
  }
}

void report_unused(const Mechanism& mechanism, std::span<const ContactProperties> contacts, Diagnostics& diagnostics) {
  for (const ContactProperties& contact : contacts) {
    const bool used = std::ranges::any_of(mechanism.joints, [&](const Joint& joint) {
      const ContactProperties* properties = find_contact(joint.kind);
      return properties != nullptr && properties->name == contact.name;
    });
    if (used) continue;
    diagnostics.remark("R-FILE-001", "contacts." + contact.name,
                       fmt::format("contact '{}' is used by no joint", contact.name));
  }
}

void read_sections(const DocumentNode& root, ModelFile& model) {
  ReadLog log{model.source, model.diagnostics};
  TableReader table{root, "", "the model", log};
  Mechanism& mechanism = model.mechanism;
  FieldReader(table).read(mechanism);
  mechanism.bodies = read_bodies(table);
  const std::vector<Material> materials = read_materials(table);
  const std::vector<ContactProperties> contacts = read_contacts(table, materials);
  mechanism.joints = read_joints(table, contacts);
  mechanism.drivers = read_drivers(table, mechanism);
  mechanism.loads = read_loads(table);
  model.study = read_study(table);
  table.find("cases");
  table.check_unknown_keys();
  if (!model.diagnostics.has_errors()) report_unused(mechanism, contacts, model.diagnostics);
}

/// The study says in full what a cycle is, whatever the file leaves open.
void update_cycle(const Mechanism& mechanism, Study& study) {
  const Driver* driver = find_cycle_driver(mechanism, study);
  if (driver != nullptr) study.cycle_driver = driver->name;
  // Motions need a cycle_time; the check says so.
  const bool uniform = std::ranges::all_of(mechanism.drivers, &Driver::is_uniform);
  if (driver != nullptr || uniform) study.cycle_time = find_cycle_time(mechanism, study);
}

/// Adds what the check finds, but not again what reading has reported: a value that could not be read is no value.
void append_check(const Diagnostics& found, Diagnostics& into) {
  std::vector<std::string> reported;
  for (const Diagnostic& item : into.items()) {
    if (item.severity == Severity::error) reported.push_back(item.path);
  }
  for (const Diagnostic& item : found.items()) {
    const bool known = std::ranges::any_of(reported, [&](const std::string& path) {
      return !path.empty() && (item.path == path || item.path.starts_with(path + "."));
    });
    if (known || (!reported.empty() && item.severity != Severity::error)) continue;
    into.add(item);
  }
}

}  // namespace

ModelDocument::ModelDocument(std::string file_name, std::string text) {
  source_.file = std::move(file_name);
  source_.text = std::move(text);
  root_ = parse_document(source_, diagnostics_);
  if (!root_) return;
  update_old_keys(*root_, "", "", source_, diagnostics_);
  update_source(*root_, source_);
  cases_ = read_cases(*root_, source_, diagnostics_);
  for (std::size_t k = 0; k < cases_.size(); ++k) case_indices_.emplace(cases_[k].name, k);
  if (root_->table() != nullptr) std::erase_if(*root_->table(), [](const auto& entry) { return entry.key == "cases"; });
  // Of what is no longer in the document, cases and old keys, only what was reported must keep its place.
  for (const Diagnostic& item : diagnostics_.items()) {
    const bool is_gone = item.path.starts_with("cases") || find_present_path(item.path) != item.path;
    const SourceSpan* span = is_gone ? source_.find(item.path) : nullptr;
    if (span != nullptr) reported_spans_.emplace(item.path, *span);
  }
}

const Case* ModelDocument::find_case(std::string_view name) const {
  const auto found = case_indices_.find(name);
  return found == case_indices_.end() ? nullptr : &cases_[found->second];
}

void ModelDocument::update_with_case(DocumentNode& root, ModelFile& model) const {
  const Case* one = find_case(model.case_name);
  if (one == nullptr) {
    std::vector<std::string> names;
    for (const Case& known : cases_) names.push_back(known.name);
    ReadLog log{model.source, model.diagnostics};
    report_choice("E-FILE-009", "cases", fmt::format("unknown case '{}'", model.case_name), model.case_name, names,
                  log);
    return;
  }
  model.cases.push_back(*one);
  for (const auto& [path, value] : one->overrides) {
    const SourceSpan* span = source_.find(fmt::format("cases.{}.set.{}", one->name, path));
    for (const std::string& old_path : find_old_paths(path)) {
      const auto old = source_.spans.find(fmt::format("cases.{}.set.{}", one->name, old_path));
      if (old == source_.spans.end()) continue;
      model.source.spans.insert(*old);
      report_old_key(old->first, old_path, model.diagnostics);
    }
    update_document(root, {path, value}, fmt::format("case '{}'", one->name), span == nullptr ? SourceSpan{} : *span,
                    model.source, model.diagnostics);
  }
}

ModelFile ModelDocument::read(std::string_view case_name, std::span<const Override> overrides) const {
  ModelFile model;
  model.source.file = source_.file;
  model.source.text = source_.text;
  model.source.spans = root_ ? reported_spans_ : source_.spans;
  model.case_name = case_name;
  model.diagnostics = diagnostics_;
  if (!root_) return model;
  DocumentNode root = *root_;
  if (!model.case_name.empty()) update_with_case(root, model);
  update_with_overrides(root, overrides, model);
  update_source(root, model.source);
  read_sections(root, model);
  update_cycle(model.mechanism, model.study);
  append_check(check(model.mechanism, model.study, &model.source, model.diagnostics.has_errors()), model.diagnostics);
  return model;
}

std::string ModelDocument::find_name(std::string_view case_name, std::span<const Override> overrides) const {
  const DocumentNode* node = root_ && root_->table() != nullptr ? find_node(*root_->table(), "name") : nullptr;
  const auto* text = node == nullptr ? nullptr : std::get_if<std::string>(&node->value);
  std::string name = text == nullptr ? std::string{} : *text;
  const auto update = [&name](const std::string& path, const std::string& value) {
    if (path != "name") return;
    const DocumentNode replaced = parse_value(value);
    const auto* other = std::get_if<std::string>(&replaced.value);
    name = other == nullptr ? std::string{} : *other;
  };
  if (const Case* one = find_case(case_name)) {
    for (const auto& [path, value] : one->overrides) update(path, value);
  }
  for (const Override& change : overrides) update(change.path, change.value);
  return name;
}

ModelDocument read_model_document(const std::filesystem::path& file) {
  std::ifstream stream{file, std::ios::binary};
  std::ostringstream text;
  // A directory opens, but cannot be read; an empty file is a model, though a bad one.
  const bool good = stream.is_open() && !std::filesystem::is_directory(file) &&
                    (stream.peek() == std::char_traits<char>::eof() || text << stream.rdbuf());
  if (!good || stream.bad()) throw FileError(fmt::format("model file '{}' cannot be read", file.string()));
  return {file.string(), std::move(text).str()};
}

namespace {

ModelFile read_with_all_cases(const ModelDocument& document, std::string_view case_name,
                              std::span<const Override> overrides) {
  ModelFile model = document.read(case_name, overrides);
  model.cases = document.cases();
  return model;
}

}  // namespace

ModelFile read_model_text(std::string file_name, std::string text, std::string_view case_name,
                          std::span<const Override> overrides) {
  return read_with_all_cases(ModelDocument(std::move(file_name), std::move(text)), case_name, overrides);
}

ModelFile read_model(const std::filesystem::path& file, std::string_view case_name,
                     std::span<const Override> overrides) {
  return read_with_all_cases(read_model_document(file), case_name, overrides);
}

}  // namespace gudgeon
