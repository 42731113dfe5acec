// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Runs the study of a model, or of many side by side.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <stop_token>
#include <vector>

#include "gudgeon/library/model.h"
#include "gudgeon/library/result.h"

namespace gudgeon {

struct RunOptions {
  int threads = 1;            ///< models that run side by side, each on one thread; results do not depend on it
  bool require_sound = true;  ///< a run with Result::problems() throws them as a NumericalError
  std::stop_token stop{};     ///< stops at the next accepted step
  /// Called with the index of a model (0 of one alone) and the share of its stages that is done, 0 to 1, about a
  /// hundred times a stage, from the thread that runs it.
  std::function<void(std::size_t model, double share)> progress{};
};

/// Runs every stage of the model's study, as `gudgeon run` does, with the same bits; nothing is written. All samples of
/// all stages stay in memory: 8 bytes a channel and sample. ModelError when the mechanism cannot be assembled or
/// started, NumericalError as require_sound says.
Result run(const Model& model, const RunOptions& options = {});

/// Runs each model; one result a model, in their order. When some throw, the others are run all the same, and then the
/// first of the exceptions is thrown. NumericalError when no thread can be made.
std::vector<Result> run(std::span<const Model> models, const RunOptions& options = {});

}  // namespace gudgeon
