// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Cases on threads.
#include "gudgeon/app/case_runner.h"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <functional>
#include <new>
#include <system_error>
#include <thread>
#include <utility>

#include "gudgeon/analysis/energy_audit.h"
#include "gudgeon/app/case_checkpoints.h"
#include "gudgeon/app/case_summary.h"
#include "gudgeon/app/checkpoint_clock.h"
#include "gudgeon/app/interruption.h"
#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/resolved_model.h"
#include "gudgeon/io/run_reader.h"
#include "gudgeon/io/run_verifier.h"
#include "gudgeon/io/run_writer.h"
#include "gudgeon/sim/case_turns.h"
#include "gudgeon/sim/run_study.h"

namespace gudgeon {
namespace {

constexpr std::chrono::milliseconds kRefreshInterval{100};  // often enough for an eye and for Ctrl-C

RunRecord make_header(const std::string& case_name, const ModelFile& model) {
  RunRecord header;
  header.model_file = model.source.file;
  header.model_text = model.source.text;
  header.case_name = case_name;
  for (const Override& change : model.overrides) header.overrides.emplace_back(change.path, change.value);
  header.resolved_model = write_resolved_model(model.mechanism, model.study);
  header.program_version = GUDGEON_VERSION;
  return header;
}

void add_message(CaseRun& one, const StageRecord& stage, const std::string& message) {
  one.message += fmt::format("{}stage {}: {}", one.message.empty() ? "" : "\n  ", stage.name, message);
}

/// What a stage that did not finish, or whose energy balance does not close, means for its case. It is the last one
/// that did not finish.
void update_outcome(CaseRun& one, const StageRecord& stage) {
  if (is_unbalanced(stage)) {
    one.code = ExitCode::unbalanced;
    add_message(one, stage, explain_imbalance(stage));
  }
  if (stage.status == StageStatus::finished) return;
  one.code = stage.status == StageStatus::failed ? ExitCode::numerical : ExitCode::interrupted;
  add_message(one, stage, stage.message);
}

/// What the case's file holds, without samples; what is not used of what lies beside it is told. FileError when it is
/// not of this model and program.
RunRecord read_earlier_run(const CaseRun& one, const RunRecord& header, ProgressDisplay& display, int index) {
  if (!std::filesystem::exists(one.file)) return {};
  RunRecord earlier = read_run_outline(one.file);
  if (earlier.resolved_model != header.resolved_model || earlier.program_version != header.program_version) {
    throw FileError(
        fmt::format("{} cannot be resumed: it was made from another model or by another version; "
                    "--overwrite runs the case anew",
                    one.file.string()));
  }
  for (const std::string& remark : require_sound(one.file).remarks) display.tell(index, remark, true);
  return earlier;
}

/// What a case shares with all others that run.
struct Surroundings {
  std::stop_token stop;
  ProgressDisplay& display;
  CaseTurns& turns;
};

void run_stages(CaseRun& one, const ModelFile& model, int index, Existing existing, CheckpointClock& clock,
                const Surroundings& around) {
  const RunRecord header = make_header(one.name, model);
  CaseCheckpoints checkpoints(
      one.file, header, [&](std::string_view line, bool is_error) { around.display.tell(index, line, is_error); });
  std::vector<StageRecord> finished;
  if (existing == Existing::resume) {
    RunRecord earlier = read_earlier_run(one, header, around.display, index);
    checkpoints.read(earlier);
    finished = std::move(earlier.stages);
    std::erase_if(finished, [](const StageRecord& stage) { return stage.status != StageStatus::finished; });
  }
  std::vector<std::string> kept;
  for (const StageRecord& stage : finished) {
    kept.push_back(stage.name);
    update_outcome(one, stage);
  }
  const std::optional<StageUnderWay> under_way = checkpoints.find_stage_under_way();
  RunWriter writer(one.file, header, existing != Existing::refuse, kept, under_way ? &*under_way : nullptr);
  one.is_written = true;
  checkpoints.begin(writer);
  RunHooks hooks;
  hooks.stop = around.stop;
  hooks.progress = [&](const Progress& progress) {
    around.display.update(index, progress);
    // A stage that is done is written before another case goes on.
    if (progress.fraction < 1.0) around.turns.pass(index, progress.share());
  };
  hooks.samples = [&](const SampleBlock& block) { writer.append(block); };
  hooks.stage_finished = [&](const StageRecord& stage) {
    writer.append(stage);
    checkpoints.note_stage(stage);
    update_outcome(one, stage);
  };
  hooks.checkpoint = [&](Checkpoint checkpoint) {
    const double began = CheckpointClock::read();
    checkpoints.write(std::move(checkpoint), writer);
    clock.note_written(began, CheckpointClock::read());
  };
  hooks.checkpoint_wanted = &clock.wanted();
  clock.note_written(CheckpointClock::read(), CheckpointClock::read());  // what was read is as good as written
  RunRecord run = header;
  run.stages = run_study(model.mechanism, model.study, hooks, std::move(finished), checkpoints.take());
  if (one.wants_summary) one.summary = summarize_case(one.file, std::move(run), one.reference);
}

/// How a case ended, in a word or two for the progress display.
std::string_view name_outcome(ExitCode code) {
  if (code == ExitCode::done) return "done";
  if (code == ExitCode::unbalanced) return "done, but its energy balance does not close,";
  return code == ExitCode::interrupted ? "stopped" : "failed";
}

/// Every failure of a case ends here: an exception may not leave its thread.
void run_case(CaseRun& one, const ReadCase& read_case, int index, Existing existing, CheckpointClock& clock,
              const Surroundings& around) {
  around.display.begin(index);
  SourceMap source;
  try {
    const ModelFile model = read_case(one.name);
    source = model.source;
    if (model.diagnostics.has_errors()) throw ModelError(model.diagnostics);
    one.reference = model.study.reference;
    run_stages(one, model, index, existing, clock, around);
  } catch (const ModelError& error) {
    one.code = ExitCode::model;
    one.message = render(error.diagnostics(), source);
  } catch (const FileError& error) {
    one.code = ExitCode::file;
    one.message = error.what();
  } catch (const std::bad_alloc&) {
    one.code = ExitCode::numerical;
    one.message = kOutOfMemory;
  } catch (const std::exception& error) {
    one.code = ExitCode::numerical;
    one.message = error.what();
  }
  around.display.finish(index, name_outcome(one.code));
}

/// Starts that many threads, or as many as there may be: then it says so. NumericalError when there may be none.
std::string add_threads(std::vector<std::jthread>& threads, int count, const std::function<void()>& work) {
  try {
    while (static_cast<int>(threads.size()) < count) threads.emplace_back(work);
    return {};
  } catch (const std::system_error& error) {
    const std::string why = error.code().message();
    if (threads.empty()) {
      throw NumericalError(
          fmt::format("no thread can be made to run the cases: {}; raise the limits of processes (ulimit -u) and of "
                      "memory (ulimit -v), or lower that of the stack (ulimit -s)",
                      why));
    }
    return fmt::format("only {} of {} threads can be made: {}; cases run with those", threads.size(), count, why);
  }
}

}  // namespace

int run_cases(std::vector<CaseRun>& cases, const ReadCase& read_case, int n_threads, Existing existing,
              double checkpoint_interval, ProgressDisplay& display) {
  const Interruption interruption;
  std::stop_source stop;
  std::atomic<int> next = 0;
  std::atomic<int> n_done = 0;
  const int n_cases = static_cast<int>(cases.size());
  CaseTurns turns(n_cases, n_threads);
  const Surroundings around{stop.get_token(), display, turns};
  std::vector<CheckpointClock> clocks(cases.size());
  const auto work = [&] {
    for (int i = next++; i < n_cases; i = next++) {
      turns.wait(i);
      if (stop.stop_requested()) {
        cases[i].code = ExitCode::interrupted;
        cases[i].message = "not started";
      } else {
        clocks[i].begin(CheckpointClock::read(), checkpoint_interval);
        run_case(cases[i], read_case, i, existing, clocks[i], around);
      }
      turns.end(i);
      n_done.fetch_add(1);
      n_done.notify_one();
    }
  };
  std::vector<std::jthread> threads;
  const std::string error = add_threads(threads, std::min(2 * n_threads - 1, n_cases), work);
  if (!error.empty()) display.write_note(error);
  try {
    while (n_done.load() < n_cases) {
      for (CheckpointClock& clock : clocks) clock.tick(CheckpointClock::read());
      if (interruption.signal() != 0 && stop.request_stop()) {
        display.write_note(interruption.signal() == SIGINT
                               ? "stopping at the next step; once more ends at once"
                               : "stopping at the next step; SIGTERM once more after 2 s, or Ctrl-C, ends at once");
      }
      display.refresh();
      std::this_thread::sleep_for(kRefreshInterval);
    }
  } catch (const std::bad_alloc&) {
    stop.request_stop();  // or the threads, which are waited for, would run all cases first
    throw;
  }
  threads.clear();
  display.refresh();
  return interruption.signal();
}

}  // namespace gudgeon
