// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Rows of bench_study.
#include "bench/study_parts.h"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include "bench/paired_rounds.h"
#include "gudgeon/io/model_reader.h"
#include "gudgeon/io/run_writer.h"
#include "gudgeon/model/cycle_time.h"
#include "gudgeon/sim/case_turns.h"
#include "gudgeon/sim/motion_integrator.h"
#include "gudgeon/sim/run_study.h"
#include "gudgeon/sim/stage_run.h"

namespace gudgeon::bench {

namespace {

constexpr std::array kCases{"", "clearance_0_3", "clearance_0_8", "speed_3_pi", "speed_4_pi"};
// A short run only shows that everything works.
int count_rounds(int cycles) { return cycles >= 10 ? 7 : 1; }

struct NineBarStudy {
  Mechanism mechanism;
  Study study;
};

NineBarStudy read_nine_bar(const char* case_name, int cycles) {
  ModelFile model = read_model(GUDGEON_SOURCE_DIR "/examples/nine_bar/nine_bar.toml", case_name);
  model.study.cycles = cycles;
  return {std::move(model.mechanism), std::move(model.study)};
}

void write_row(const char* what, const std::string& name, double value, const char* unit) {
  std::printf("%s,%s,%.6g,%s\n", what, name.c_str(), value, unit);
  std::fflush(stdout);
}

void write_rows(const char* what, const std::string& name, const Spread& spread, const char* unit) {
  write_row(what, name, spread.median, unit);
  write_row(what, name + ".q1", spread.lower, unit);
  write_row(what, name + ".q3", spread.upper, unit);
}

std::string name_case(const char* name) { return *name == '\0' ? "as_given" : name; }

// One stage without wear, as a study has it.
StageRecord run_stage(const NineBarStudy& at) {
  const Assembly assembly = assemble(at.mechanism);
  const System system = compile(at.mechanism, assembly);
  StageRun stage(system, at.study, find_cycle_time(at.mechanism, at.study), "no_wear");
  return stage.run(make_state(system, assembly), {}, {});
}

// A case as `gudgeon run` has it: samples go to a run file as they come.
void run_to_file(const NineBarStudy& at) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("bench_study_" + std::to_string(::getpid()) + ".h5");
  RunWriter writer(file, {}, true);
  RunHooks hooks;
  hooks.samples = [&](const SampleBlock& block) { writer.append(block); };
  hooks.stage_finished = [&](const StageRecord& stage) { writer.append(stage); };
  run_study(at.mechanism, at.study, hooks);
  std::filesystem::remove(file);
}

// The integrator of such a stage, told of every step.
template <class Look>
long run_motion(const NineBarStudy& at, Look&& look) {
  const Assembly assembly = assemble(at.mechanism);
  const System system = compile(at.mechanism, assembly);
  const double cycle_time = find_cycle_time(at.mechanism, at.study);
  MotionIntegrator motion(system, at.study, cycle_time);
  const double end = cycle_time * (at.study.warm_up_cycles + at.study.cycles);
  if (!motion.begin(make_state(system, assembly))) return 0;
  while (motion.time() < end && motion.advance(end)) look(motion);
  return static_cast<long>(motion.statistics().evaluations);
}

void run_programme(int cycles, int n_threads) {
  std::atomic<std::size_t> next = 0;
  const auto start = std::chrono::steady_clock::now();
  CaseTurns turns(static_cast<int>(kCases.size()), n_threads);
  const auto work = [&] {
    for (std::size_t i = next++; i < kCases.size(); i = next++) {
      turns.wait(static_cast<int>(i));
      const NineBarStudy at = read_nine_bar(kCases[i], cycles);
      const double begin = read_cpu_clock();
      RunHooks hooks;
      hooks.progress = [&](const Progress& progress) { turns.pass(static_cast<int>(i), progress.share()); };
      const auto stages = run_study(at.mechanism, at.study, hooks);
      turns.end(static_cast<int>(i));
      const std::string threads = " on " + std::to_string(n_threads);
      write_row("case_time", name_case(kCases[i]) + threads, read_cpu_clock() - begin, "s");
      if (n_threads > 1) continue;
      double evaluations = 0.0;
      for (const StageRecord& stage : stages) {
        evaluations += static_cast<double>(stage.solver.evaluations);
        if (stage.status != StageStatus::finished) std::fprintf(stderr, "%s: %s\n", kCases[i], stage.message.c_str());
      }
      write_row("case_evaluations", name_case(kCases[i]), evaluations, "1");
    }
  };
  {
    std::vector<std::jthread> threads;
    for (int k = 0; k < 2 * n_threads - 1; ++k) threads.emplace_back(work);
  }
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  write_row("programme_wall_time", std::to_string(n_threads) + "_threads", wall, "s");
}

double read_peak_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (double kilobytes = 0.0; word == "VmHWM:" && status >> kilobytes) return kilobytes / 1024.0;
  }
  return 0.0;
}

// Runs in a process of its own, so that its peak is its own.
void write_peak_of(const std::string& name, const std::function<void()>& work) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    work();
    write_row("peak_memory", name, read_peak_memory(), "MB");
    std::_Exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
}

// σ₀ = 1e5 as in the paper; its σ₁ = 400 s/m with σ₂ = 0 feeds energy, and more impacts follow.
Mechanism with_bristles(Mechanism mechanism, double bristle_damping) {
  for (Joint& joint : mechanism.joints) {
    auto* clearance = std::get_if<RevoluteClearance>(&joint.kind);
    if (clearance == nullptr) continue;
    const auto* steady = std::get_if<LugreSteady>(&clearance->contact.friction);
    if (steady == nullptr) continue;
    clearance->contact.friction = Lugre{steady->static_coefficient,
                                        steady->kinetic_coefficient,
                                        steady->stribeck_speed,
                                        steady->decay_exponent,
                                        1e5,
                                        bristle_damping,
                                        0.0};
  }
  return mechanism;
}

}  // namespace

void measure_programme(int cycles) {
  run_programme(cycles, 1);
  run_programme(cycles, 2);
}

void measure_integrator(int cycles) {
  const NineBarStudy at = read_nine_bar("", cycles);
  const double start = read_cpu_clock();
  const long evaluations = run_motion(at, [](const MotionIntegrator&) {});
  write_row("integrator_time", "as_given", read_cpu_clock() - start, "s");
  write_row("integrator_evaluations", "as_given", static_cast<double>(evaluations), "1");
}

void measure_recording(int cycles) {
  NineBarStudy at = read_nine_bar("", (cycles + 9) / 10);
  std::vector<Contestant> contestants{
      make_contestant("integrator", [at] { run_motion(at, [](const MotionIntegrator&) {}); })};
  for (const int rate : {1, 500, 5000}) {
    at.study.outputs_per_cycle = rate;
    contestants.push_back(make_contestant("outputs_" + std::to_string(rate), [at] { run_stage(at); }));
  }
  PairedRounds rounds(std::move(contestants), 0.0);
  for (int k = 0; k < count_rounds(cycles); ++k) rounds.run();
  write_rows("stage_time", "integrator", rounds.find_time(0), "s");
  for (const char* name : {"outputs_1", "outputs_500", "outputs_5000"}) {
    write_rows("stage_over_integrator", name, rounds.find_ratio(*rounds.find(name), 0), "1");
  }
  write_rows("recording", "500_over_1_output_a_cycle",
             rounds.find_ratio(*rounds.find("outputs_500"), *rounds.find("outputs_1")), "1");
}

void measure_share(int cycles) {
  const NineBarStudy at = read_nine_bar("", (cycles + 9) / 10);
  const Assembly assembly = assemble(at.mechanism);
  const System system = compile(at.mechanism, assembly);
  MotionEquations equations(system, {});
  struct Look {
    double time;
    std::vector<ContactMode> contact_modes;
    std::vector<double> y;
  };
  std::vector<Look> looks;
  const long evaluations = run_motion(at, [&](MotionIntegrator& motion) {
    looks.push_back({motion.time(), motion.equations().contact_modes, motion.y()});
  });
  std::vector<double> slope(equations.size());
  std::vector<Contestant> contestants{make_contestant("run", [&] { run_motion(at, [](const MotionIntegrator&) {}); }),
                                      {"evaluations", [&](int n) {
                                         const double start = read_cpu_clock();
                                         for (int i = 0; i < n; ++i) {
                                           for (const Look& look : looks) {
                                             equations.contact_modes = look.contact_modes;
                                             equations.eval(look.time, look.y.data(), slope.data());
                                           }
                                         }
                                         const double taken = read_cpu_clock() - start;
                                         return taken * static_cast<double>(evaluations) /
                                                static_cast<double>(looks.size());
                                       }}};
  PairedRounds rounds(std::move(contestants), 0.0);
  for (int k = 0; k < count_rounds(cycles); ++k) rounds.run();
  write_rows("evaluations_share", "as_given", rounds.find_ratio(1, 0), "1");
  write_row("evaluations_a_step", "as_given", static_cast<double>(evaluations) / static_cast<double>(looks.size()),
            "1");
}

void measure_bristles(int cycles) {
  struct Variant {
    const char* name;
    NineBarStudy at;
  };
  const NineBarStudy steady = read_nine_bar("", (cycles + 9) / 10);
  std::vector<Variant> variants{{"steady", steady}};
  for (const auto& [name, damping, integrator] : {std::tuple{"automatic", 0.0, Integrator::automatic},
                                                  {"explicit_pair", 0.0, Integrator::explicit_pair},
                                                  {"stiff", 0.0, Integrator::stiff},
                                                  {"automatic_damped", 400.0, Integrator::automatic}}) {
    Variant& variant = variants.emplace_back(Variant{name, steady});
    variant.at.mechanism = with_bristles(steady.mechanism, damping);
    variant.at.study.integrator = integrator;
  }
  std::vector<Contestant> contestants;
  for (const Variant& variant : variants) {
    contestants.push_back(make_contestant(variant.name, [&variant] { run_stage(variant.at); }));
  }
  PairedRounds rounds(std::move(contestants), 0.0);
  for (int k = 0; k < (count_rounds(cycles) + 1) / 2; ++k) rounds.run();
  for (std::size_t k = 0; k < variants.size(); ++k) {
    const char* name = variants[k].name;
    if (k > 0) write_rows("bristles_over_steady", name, rounds.find_ratio(k, 0), "1");
    const StageRecord stage = run_stage(variants[k].at);
    write_row("bristles_evaluations", name, static_cast<double>(stage.solver.evaluations), "1");
    write_row("bristles_onsets", name, static_cast<double>(stage.solver.onsets), "1");
    write_row("bristles_energy_residual", name, stage.energy.residual(), "J");
  }
}

void measure_memory(int cycles) {
  write_peak_of("nothing_run", [] {});
  for (const int rate : {1, 500, 5000}) {
    NineBarStudy at = read_nine_bar("", cycles);
    at.study.outputs_per_cycle = rate;
    at.study.compare_ideal = false;
    at.study.wear_stages = 0;
    write_peak_of("outputs_" + std::to_string(rate), [&] { run_to_file(at); });
  }
  write_peak_of("whole_case", [&] { run_to_file(read_nine_bar("", cycles)); });
}

}  // namespace gudgeon::bench
