// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Finds what is wrong in any case of a run: of the first hundred before any of them starts, of the others while those
// run. Thousands of models are never held at once.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "gudgeon/app/case_runner.h"
#include "gudgeon/io/model_reader.h"

namespace gudgeon {

class CaseCheck {
 public:
  /// Of cases of these names; read must be callable from several threads.
  CaseCheck(ReadCase read, std::vector<std::string> names);

  /// Checks the first hundred cases. Throws RejectedModel with all that is wrong in any of them, each complaint once;
  /// returns their warnings, each once.
  std::string require_first();
  /// Checks the others on a thread of its own and tells of each complaint once, as soon as it is found: such a case
  /// will not run. Without that thread each is told when its turn comes.
  void begin_rest(std::function<void(const std::string& text)> tell);
  void end_rest();

  /// The model of a case, which a case alone has been read for already.
  ModelFile take(const std::string& name);

 private:
  ReadCase read_;
  std::vector<std::string> names_;
  std::optional<ModelFile> only_;  // of a case that runs alone
  std::jthread rest_;
};

}  // namespace gudgeon
