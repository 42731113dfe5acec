// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Finding and reading run files.
#include "gudgeon/app/report_runs.h"

#include <fmt/format.h>

#include <algorithm>

#include "gudgeon/app/model_options.h"
#include "gudgeon/app/report_scene.h"
#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/run_reader.h"
#include "gudgeon/report/figures/case_figures.h"
#include "gudgeon/report/html/figure_data.h"
#include "gudgeon/sim/function_samples.h"

namespace gudgeon {
namespace {

std::vector<std::filesystem::path> find_run_files(const std::filesystem::path& path) {
  std::error_code failure;
  if (!std::filesystem::is_directory(path, failure)) return {path};
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(path, failure)) {
    if (entry.path().extension() == ".h5") files.push_back(entry.path());
  }
  if (failure) throw FileError(fmt::format("directory '{}' cannot be read: {}", path.string(), failure.message()));
  if (files.empty()) {
    throw FileError(
        fmt::format("directory '{}' has no run file (*.h5); give one that 'gudgeon run' wrote to", path.string()));
  }
  std::ranges::sort(files);
  return files;
}

/// The model of a run, from its own text; nothing when this version of the program does not understand it.
std::optional<ModelFile> read_stored_model(const RunRecord& run) {
  std::vector<Override> overrides;
  for (const auto& [path, value] : run.overrides) overrides.push_back({path, value});
  const std::string_view case_name = run.case_name == kBaseCase ? std::string_view{} : std::string_view(run.case_name);
  ModelFile model = read_model_text(run.model_file, run.model_text, case_name, overrides);
  if (model.diagnostics.has_errors()) return std::nullopt;
  return model;
}

/// Place among the cases of the model; the base case comes before them.
std::size_t find_rank(const ReadRun& one) {
  if (one.outline.case_name == kBaseCase || !one.model) return 0;
  const auto found = std::ranges::find(one.model->cases, one.outline.case_name, &Case::name);
  return 1 + static_cast<std::size_t>(found - one.model->cases.begin());
}

/// A page shows each case once.
void require_new_case(const std::vector<ReadRun>& runs, const ReadRun& one) {
  const auto known = std::ranges::find(runs, one.outline.case_name,
                                       [](const ReadRun& run) -> const std::string& { return run.outline.case_name; });
  if (known == runs.end()) return;
  throw FileError(fmt::format("{}: holds case '{}' as {} does; report it by itself", one.file.string(),
                              one.outline.case_name, known->file.string()));
}

void read_into(const std::filesystem::path& file, RunRecord& run, const std::optional<Scene>& scene) {
  read_channels(file, run.stages, [&](const StageRecord& stage) {
    std::vector<std::string> channels = find_figure_channels(run, stage);
    if (scene) std::ranges::copy(find_pose_channels(*scene, stage), std::back_inserter(channels));
    return channels;
  });
}

}  // namespace

ReadRuns read_runs(const std::filesystem::path& path) {
  ReadRuns read;
  for (const std::filesystem::path& file : find_run_files(path)) {
    try {
      ReadRun one{file, read_run_outline(file), {}};
      require_new_case(read.runs, one);
      one.model = read_stored_model(one.outline);
      read.runs.push_back(std::move(one));
    } catch (const FileError& error) {
      read.errors.emplace_back(error.what());
    }
  }
  if (read.runs.empty()) throw FileError(fmt::format("{}", fmt::join(read.errors, "\n  ")));
  std::ranges::stable_sort(read.runs, {}, find_rank);
  return read;
}

std::vector<FunctionSamples> read_functions(const ReadRun& one) {
  if (!one.model) return {};
  const ModelFile& model = *one.model;
  try {
    return sample_functions(model.mechanism, model.study, assemble(model.mechanism));
  } catch (const ModelError&) {
    return {};  // another version of the program ran it
  }
}

RunRecord read_figure_channels(const ReadRun& one) {
  RunRecord run = one.outline;
  read_into(one.file, run, {});
  return run;
}

ReportCase read_report_case(const ReadRun& one, bool with_samples) {
  ReportCase report;
  report.run = one.outline;
  if (one.model) {
    const ModelFile& model = *one.model;
    report.mechanism = model.mechanism.name;
    report.description = model.mechanism.description;
    report.study = describe_study(model.mechanism, model.study);
    report.scene = make_scene(model.mechanism);
    report.functions = read_functions(one);
    for (const ReferenceValue& value : model.study.reference) {
      report.reference.push_back({value.quantity, value.channel, value.measure, value.values, {}});
    }
    const auto found = std::ranges::find(model.cases, model.case_name, &Case::name);
    if (found != model.cases.end()) {
      report.case_description = found->description;
      for (const auto& [path, value] : found->overrides) {
        if (path != "study.reference") report.case_settings.emplace_back(path, value);
      }
    }
  } else {
    report.model_error =
        "This version of gudgeon cannot read the model that the run file holds: the mechanism is not animated and its "
        "values are not listed.";
  }
  read_stated_values(report.run.model_text, report);
  if (with_samples) read_into(one.file, report.run, report.scene);
  return report;
}

}  // namespace gudgeon
