// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Collects diagnostics and finds their places.
#include "gudgeon/base/diagnostics.h"

#include <algorithm>
#include <utility>

namespace gudgeon {

namespace {

/// The path without its last part; empty at the top.
std::string_view enclosing(std::string_view path) {
  const auto dot = path.rfind('.');
  return dot == std::string_view::npos ? std::string_view{} : path.substr(0, dot);
}

}  // namespace

void Diagnostics::error(std::string code, std::string path, std::string message, std::vector<std::string> notes) {
  add({Severity::error, std::move(code), std::move(path), std::move(message), std::move(notes)});
}

void Diagnostics::warning(std::string code, std::string path, std::string message, std::vector<std::string> notes) {
  add({Severity::warning, std::move(code), std::move(path), std::move(message), std::move(notes)});
}

void Diagnostics::remark(std::string code, std::string path, std::string message, std::vector<std::string> notes) {
  add({Severity::remark, std::move(code), std::move(path), std::move(message), std::move(notes)});
}

void Diagnostics::append(const Diagnostics& other) {
  const std::vector<Diagnostic> copies = other.items_;  // other may be *this
  items_.insert(items_.end(), copies.begin(), copies.end());
}

bool Diagnostics::has_errors() const {
  return std::ranges::any_of(items_, [](const Diagnostic& item) { return item.severity == Severity::error; });
}

const SourceSpan* SourceMap::find(std::string_view path) const {
  for (; !path.empty(); path = enclosing(path)) {
    const auto found = spans.find(std::string{path});
    if (found != spans.end()) return &found->second;
    if (origins.contains(std::string{path})) return nullptr;  // an override that stands in no file
  }
  return nullptr;
}

const std::string* SourceMap::find_origin(std::string_view path) const {
  for (; !path.empty(); path = enclosing(path)) {
    const auto found = origins.find(std::string{path});
    if (found != origins.end()) return &found->second;
    if (spans.contains(std::string{path})) return nullptr;
  }
  return nullptr;
}

ModelError::ModelError(Diagnostics diagnostics)
    : std::runtime_error(render(diagnostics, SourceMap{})), diagnostics_(std::move(diagnostics)) {}

}  // namespace gudgeon
