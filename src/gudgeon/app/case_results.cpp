// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Summaries, paths and errors of cases.
#include "gudgeon/app/case_results.h"

#include <fmt/format.h>

#include "gudgeon/app/case_summary.h"
#include "gudgeon/app/text_output.h"
#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/run_reader.h"

namespace gudgeon {
namespace {

/// Whether the file that the case was to write is there: a run that a limit stopped may have left none.
bool is_kept(const CaseRun& one) {
  std::error_code unknown;
  return one.is_written && std::filesystem::exists(one.file, unknown);
}

void print_summaries(const std::vector<CaseRun>& cases, bool quiet) {
  for (const CaseRun& one : cases) {
    if (quiet || !is_kept(one)) continue;
    // What went wrong may have left some stages in the file.
    write_receipt(one.summary.empty() ? summarize_case(one.file, read_run_outline(one.file), one.reference)
                                      : one.summary);
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
