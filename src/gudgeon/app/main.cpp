// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The program: parse, do what is asked, tell how it ended.
#include <fmt/format.h>
#include <malloc.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>
#include <optional>

#include "gudgeon/app/command_line.h"
#include "gudgeon/app/exit_code.h"
#include "gudgeon/app/model_options.h"
#include "gudgeon/app/text_output.h"
#include "gudgeon/base/diagnostics.h"

namespace {

using gudgeon::ExitCode;

/// Where the address space is limited (ulimit -v, a cluster's h_vmem), all threads share one heap: one of each thread
/// takes 64 MiB of addresses, and a thread that gets none takes a page of memory for every small block.
void share_heap_under_limit() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) ::mallopt(M_ARENA_MAX, 1);
}

ExitCode run_program(int argc, const char* const* argv) {
  share_heap_under_limit();
  gudgeon::open_closed_streams();
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may grow no larger is a failed write, with its own message
  CLI::App program;
  gudgeon::Action action;
  gudgeon::add_commands(program, action);
  const std::optional<ExitCode> early = gudgeon::read_command_line(program, argc, argv);
  const ExitCode code = early ? *early : action();
  gudgeon::flush_stdout();
  return code;
}

ExitCode report(ExitCode code, const char* message) {
  gudgeon::write_stderr(fmt::format("gudgeon: {}\n", message));
  return code;
}

}  // namespace

#ifdef GUDGEON_SANITIZE
/// HDF5 1.10 loses memory over damaged files; the exit code shall be ours all the same.
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5"; }
#endif

int main(int argc, char** argv) {
  ExitCode code = ExitCode::done;
  try {
    code = run_program(argc, argv);
  } catch (const gudgeon::RejectedModel& error) {
    gudgeon::write_stderr(error.what());
    code = ExitCode::model;
  } catch (const gudgeon::UsageError& error) {
    code = report(ExitCode::usage, error.what());
  } catch (const gudgeon::NumericalError& error) {
    code = report(ExitCode::numerical, error.what());
  } catch (const gudgeon::FileError& error) {
    code = report(ExitCode::file, error.what());
  } catch (const std::bad_alloc&) {
    code = report(ExitCode::numerical, gudgeon::kOutOfMemory);
  } catch (const std::exception& error) {
    code = report(ExitCode::numerical, fmt::format("internal error: {}", error.what()).c_str());
  }
  return static_cast<int>(code);
}
