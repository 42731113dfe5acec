// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Summaries, paths and errors of cases.
#include "gudgeon/app/case_results.h"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <unordered_set>

#include "gudgeon/analysis/reference_values.h"
#include "gudgeon/app/text_output.h"
#include "gudgeon/io/run_reader.h"
#include "gudgeon/report/comparison_section.h"
#include "gudgeon/report/run_summary.h"

namespace gudgeon {
namespace {

std::vector<ReferenceRow> make_reference(const std::vector<ReferenceValue>& reference) {
  std::vector<ReferenceRow> rows;
  for (const ReferenceValue& value : reference) {
    rows.push_back({value.quantity, value.channel, value.measure, value.values, {}});
  }
  return rows;
}

/// Whether the file that the case was to write is there: a run that a limit stopped may have left none.
bool is_kept(const CaseRun& one) {
  std::error_code unknown;
  return one.is_written && std::filesystem::exists(one.file, unknown);
}

void print_summaries(const std::vector<CaseRun>& cases, bool quiet) {
  for (const CaseRun& one : cases) {
    if (quiet || !is_kept(one)) continue;
    // What went wrong may have left some stages in the file.
    write_receipt(one.summary.empty() ? summarize_case(one, read_run_outline(one.file)) : one.summary);
    write_receipt("\n");
  }
  for (const CaseRun& one : cases) {
    if (is_kept(one)) write_receipt(fmt::format("{}\n", one.file.string()));
  }
  flush_stdout();
}

void print_errors(const std::vector<CaseRun>& cases) {
  for (const CaseRun& one : cases) {
    if (one.message.empty()) continue;
    write_stderr(fmt::format("gudgeon: case {}: {}\n", one.name, one.message));
    if (one.code == ExitCode::unbalanced || !is_kept(one)) continue;  // it finished, or it left nothing
    write_stderr(fmt::format("  what was finished is kept in {}\n", one.file.string()));
  }
}

}  // namespace

std::string summarize_case(const CaseRun& one, RunRecord run) {
  const std::vector<std::string> ideal = find_ideal_channels(run);
  const std::unordered_set<std::string_view> wanted(ideal.begin(), ideal.end());
  read_channels(one.file, run.stages, [&](const StageRecord& stage) {
    std::vector<std::string> channels;
    for (const Channel& channel : stage.channels) {
      if (wanted.contains(channel.name)) channels.push_back(channel.name);
    }
    return channels;
  });
  return render_summary(run, make_reference(one.reference), find_color_wanted());
}

void print_results(const std::vector<CaseRun>& cases, bool quiet) {
  try {
    print_summaries(cases, quiet);
  } catch (const FileError&) {
    print_errors(cases);  // they are why there is nothing to read, or more than a full disk behind standard output
    throw;
  }
  print_errors(cases);
}

}  // namespace gudgeon
