// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Runs of models on threads.
#include "gudgeon/library/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <optional>
#include <system_error>
#include <thread>

#include "gudgeon/library/model_content.h"
#include "gudgeon/sim/run_study.h"

namespace gudgeon {
namespace {

Result run_model(const Model& model, std::size_t index, const RunOptions& options) {
  const ModelFile& file = model.content().file;
  RunHooks hooks;
  hooks.stop = options.stop;
  if (options.progress) {
    hooks.progress = [&](const Progress& progress) { options.progress(index, progress.share()); };
  }
  try {
    Result result(run_study(file.mechanism, file.study, hooks));
    const std::vector<std::string> problems = result.problems();
    if (options.require_sound && !problems.empty()) {
      throw NumericalError(fmt::format("{}: {}", model.name(), fmt::join(problems, "\n  ")));
    }
    return result;
  } catch (const ModelError& error) {
    throw PlacedModelError(error.diagnostics(), file.source);
  }
}

/// Calls work on up to that many threads; on fewer where there may be no more. NumericalError when there may be none.
void run_threads(std::size_t count, const std::function<void()>& work) {
  std::vector<std::jthread> threads;
  try {
    while (threads.size() < count) threads.emplace_back(work);
  } catch (const std::system_error& error) {
    if (threads.empty()) throw NumericalError(fmt::format("no thread can be made: {}", error.code().message()));
  }
}

}  // namespace

Result run(const Model& model, const RunOptions& options) { return run_model(model, 0, options); }

std::vector<Result> run(std::span<const Model> models, const RunOptions& options) {
  std::vector<std::optional<Result>> results(models.size());
  std::vector<std::exception_ptr> failures(models.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < models.size(); i = next++) {
      try {
        results[i] = run_model(models[i], i, options);
      } catch (...) {
        failures[i] = std::current_exception();
      }
    }
  };
  run_threads(std::min(static_cast<std::size_t>(std::max(options.threads, 1)), models.size()), work);
  const auto failure = std::ranges::find_if(failures, [](const std::exception_ptr& one) { return one != nullptr; });
  if (failure != failures.end()) std::rethrow_exception(*failure);
  std::vector<Result> all;
  for (std::optional<Result>& one : results) all.push_back(std::move(*one));
  return all;
}

}  // namespace gudgeon
