// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One model after the other.
#include "gudgeon/app/case_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stop_token>
#include <system_error>
#include <utility>

#include "gudgeon/app/model_options.h"
#include "gudgeon/base/diagnostics.h"
#include "gudgeon/system/assembly.h"
#include "gudgeon/system/start_check.h"

namespace gudgeon {
namespace {

// As many as are checked in a moment.
constexpr std::size_t kFirst = 100;

/// What is wrong with a model or the start of its mechanism; empty for nothing.
std::string find_errors(const ModelFile& model) {
  if (model.diagnostics.has_errors()) return render(model.diagnostics, model.source);
  try {
    require_start(model.mechanism, assemble(model.mechanism));
    require_ideal_start(model.mechanism, model.study);
    return {};
  } catch (const ModelError& error) {
    return render(error.diagnostics(), model.source);
  }
}

std::string find_warnings(const ModelFile& model) {
  Diagnostics warnings;
  for (const Diagnostic& item : model.diagnostics.items()) {
    if (item.severity != Severity::remark) warnings.add(item);
  }
  return render(warnings, model.source);
}

}  // namespace

CaseCheck::CaseCheck(ReadCase read, std::vector<std::string> names)
    : read_(std::move(read)), names_(std::move(names)) {}

std::string CaseCheck::require_first() {
  std::set<std::string> known;
  std::string errors;
  std::string warnings;
  for (std::size_t k = 0; k < std::min(kFirst, names_.size()); ++k) {
    ModelFile model = read_(names_[k]);
    const std::string wrong = find_errors(model);
    if (!wrong.empty() && known.insert(wrong).second) errors += (errors.empty() ? "" : "\n") + wrong;
    const std::string warned = find_warnings(model);
    if (known.insert(warned).second) warnings += warned;
    if (names_.size() == 1) only_ = std::move(model);
  }
  if (!errors.empty()) throw RejectedModel(errors);
  return warnings;
}

void CaseCheck::begin_rest(std::function<void(const std::string& text)> tell) {
  if (names_.size() <= kFirst) return;
  const auto check = [this, tell = std::move(tell)](const std::stop_token& stop) {
    std::set<std::string> known;
    try {
      for (std::size_t k = kFirst; k < names_.size() && !stop.stop_requested(); ++k) {
        const std::string wrong = find_errors(read_(names_[k]));
        if (wrong.empty() || !known.insert(wrong).second) continue;
        tell(fmt::format("case {} will not run:\n{}", names_[k], wrong));
      }
    } catch (const std::exception&) {
      // Nothing but memory can end here: whatever is wrong is told when the case's turn comes.
    }
  };
  try {
    rest_ = std::jthread(check);
  } catch (const std::system_error&) {
  }
}

void CaseCheck::end_rest() {
  if (!rest_.joinable()) return;
  rest_.request_stop();
  rest_.join();
}

ModelFile CaseCheck::take(const std::string& name) {
  if (!only_) return read_(name);
  ModelFile model = std::move(*only_);
  only_.reset();
  return model;
}

}  // namespace gudgeon
