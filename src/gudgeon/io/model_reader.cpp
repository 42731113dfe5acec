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

#include "gudgeon/io/read_sections.h"
#include "gudgeon/io/table_reader.h"
#include "gudgeon/model/check.h"

namespace gudgeon {

namespace {

void update_with_case(DocumentNode& root, ModelFile& model) {
  const auto found = std::ranges::find(model.cases, model.case_name, &Case::name);
  if (found == model.cases.end()) {
    std::vector<std::string> names;
    for (const Case& one : model.cases) names.push_back(one.name);
    ReadLog log{model.source, model.diagnostics};
    report_choice("E-FILE-009", "cases", fmt::format("there is no case '{}'", model.case_name), model.case_name, names,
                  log);
    return;
  }
  for (const auto& [path, value] : found->overrides) {
    const SourceSpan* span = model.source.find(fmt::format("cases.{}.set.{}", found->name, path));
    update_document(root, {path, value}, fmt::format("case '{}'", found->name), span == nullptr ? SourceSpan{} : *span,
                    model.source, model.diagnostics);
  }
}

void update_with_overrides(DocumentNode& root, ModelFile& model) {
  for (const Override& change : model.overrides) {
    const std::string origin = fmt::format("--set {}={}", change.path, change.value);
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
  mechanism.name = table.read_text("name");
  mechanism.description = table.find_text("description").value_or("");
  mechanism.gravity = table.find_vector("gravity", dimension::kAcceleration).value_or(Vec2{});
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

ModelFile read_model_text(std::string file_name, std::string text, std::string_view case_name,
                          std::span<const Override> overrides) {
  ModelFile model;
  model.source.file = std::move(file_name);
  model.source.text = std::move(text);
  model.case_name = case_name;
  model.overrides.assign(overrides.begin(), overrides.end());
  std::optional<DocumentNode> root = parse_document(model.source, model.diagnostics);
  if (!root) return model;
  model.cases = read_cases(*root, model.source, model.diagnostics);
  update_source(*root, model.source);
  if (!model.case_name.empty() || !model.overrides.empty()) {
    if (!model.case_name.empty()) update_with_case(*root, model);
    update_with_overrides(*root, model);
    // Replaced values take their places and texts with them; overrides that found no value keep theirs, "(override …)".
    std::erase_if(model.source.spans, [](const auto& item) { return !item.first.starts_with('('); });
    model.source.written.clear();
    update_source(*root, model.source);
  }
  read_sections(*root, model);
  update_cycle(model.mechanism, model.study);
  append_check(check(model.mechanism, model.study, &model.source, model.diagnostics.has_errors()), model.diagnostics);
  return model;
}

ModelFile read_model(const std::filesystem::path& file, std::string_view case_name,
                     std::span<const Override> overrides) {
  std::ifstream stream{file, std::ios::binary};
  std::ostringstream text;
  // A directory opens, but cannot be read; an empty file is a model, though a bad one.
  const bool good = stream.is_open() && !std::filesystem::is_directory(file) &&
                    (stream.peek() == std::char_traits<char>::eof() || text << stream.rdbuf());
  if (!good || stream.bad()) throw FileError(fmt::format("model file '{}' cannot be read", file.string()));
  return read_model_text(file.string(), text.str(), case_name, overrides);
}

}  // namespace gudgeon
