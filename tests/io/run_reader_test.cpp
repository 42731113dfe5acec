// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Reading run files back: to the last bit, in parts, and when they are not what they should be.
#include "gudgeon/io/run_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <span>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/hdf5_dataset.h"
#include "gudgeon/io/hdf5_file.h"
#include "gudgeon/io/hdf5_node.h"
#include "tests/io/image_file.h"
#include "tests/io/scratch_directory.h"
#include "tests/io/written_run.h"
#include "tests/results/same_bits.h"
#include "tests/results/synthetic_run.h"

/// HDF5 1.10 loses memory over damaged files; a build with the leak checker shall not stop at that.
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5"; }

namespace gudgeon {
namespace {

using test::find_message;
using test::have_same_bits;
using test::make_run;
using test::ScratchDirectory;
using test::write_run;
using testing::HasSubstr;

std::array<double, 13> list_energy(const EnergyBalance& l) {
  return {l.initial_energy,  l.kinetic,  l.potential,    l.elastic,   l.driver_work, l.load_work, l.damper_loss,
          l.contact_damping, l.friction, l.surface_work, l.exchanged, l.load_reach,  l.residual()};
}

std::array<double, 10> list_solver(const SolverStatistics& s) {
  const auto real = [](std::int64_t n) { return static_cast<double>(n); };
  return {real(s.evaluations), real(s.accepted_steps), real(s.rejected_steps), real(s.onsets),     real(s.separations),
          real(s.projections), s.smallest_step,        s.largest_step,         s.closure_residual, s.wall_time};
}

void expect_same_wear(const JointWear& a, const JointWear& b) {
  EXPECT_EQ(a.joint, b.joint);
  const auto list = [](const JointWear& w) {
    return std::array{w.bearing_radius, w.journal_radius, w.clearance,        w.slot_length,  w.width,
                      w.archard_volume, w.removed_volume, w.sliding_distance, w.contact_time, w.impulse};
  };
  EXPECT_TRUE(have_same_bits(list(a), list(b)));
  EXPECT_TRUE(have_same_bits(a.bearing_depth, b.bearing_depth));
  EXPECT_TRUE(have_same_bits(a.journal_depth, b.journal_depth));
  EXPECT_TRUE(have_same_bits(a.bearing_depth_added, b.bearing_depth_added));
  EXPECT_TRUE(have_same_bits(a.journal_depth_added, b.journal_depth_added));
  EXPECT_TRUE(have_same_bits(a.total_depth_added, b.total_depth_added));
}

void expect_same_outline(const StageRecord& a, const StageRecord& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.message, b.message);
  EXPECT_EQ(a.cycles, b.cycles);
  EXPECT_TRUE(have_same_bits(std::array{a.start_time, a.end_time, a.cycle_time},
                             std::array{b.start_time, b.end_time, b.cycle_time}));
  ASSERT_EQ(a.channels.size(), b.channels.size());
  for (std::size_t k = 0; k < a.channels.size(); ++k) {
    EXPECT_EQ(a.channels[k].name, b.channels[k].name);
    EXPECT_EQ(a.channels[k].symbol, b.channels[k].symbol);
    EXPECT_EQ(a.channels[k].unit, b.channels[k].unit);
    EXPECT_EQ(a.channels[k].description, b.channels[k].description);
  }
  ASSERT_EQ(a.statistics.size(), b.statistics.size());
  for (std::size_t k = 0; k < a.statistics.size(); ++k) {
    const auto list = [](const ChannelStatistics& s) {
      return std::array{s.minimum, s.minimum_time, s.maximum, s.maximum_time, s.mean, s.rms};
    };
    EXPECT_EQ(a.statistics[k].channel, b.statistics[k].channel);
    EXPECT_TRUE(have_same_bits(list(a.statistics[k]), list(b.statistics[k])));
  }
  ASSERT_EQ(a.events.size(), b.events.size());
  for (std::size_t k = 0; k < a.events.size(); ++k) {
    const auto list = [](const ContactEvent& e) {
      return std::array{e.onset_time, e.duration, e.onset_speed, e.angle, e.peak_force, e.position};
    };
    EXPECT_EQ(a.events[k].joint, b.events[k].joint);
    EXPECT_EQ(a.events[k].contact, b.events[k].contact);
    EXPECT_TRUE(have_same_bits(list(a.events[k]), list(b.events[k])));
  }
  ASSERT_EQ(a.wear.size(), b.wear.size());
  for (std::size_t k = 0; k < a.wear.size(); ++k) expect_same_wear(a.wear[k], b.wear[k]);
  EXPECT_TRUE(have_same_bits(list_energy(a.energy), list_energy(b.energy)));
  EXPECT_TRUE(have_same_bits(list_solver(a.solver), list_solver(b.solver)));
}

void expect_same_header(const RunRecord& a, const RunRecord& b) {
  EXPECT_EQ(a.model_file, b.model_file);
  EXPECT_EQ(a.model_text, b.model_text);
  EXPECT_EQ(a.case_name, b.case_name);
  EXPECT_EQ(a.overrides, b.overrides);
  EXPECT_EQ(a.resolved_model, b.resolved_model);
  EXPECT_EQ(a.program_version, b.program_version);
}

/// A run with every oddity a stage may have.
RunRecord make_hard_run() {
  RunRecord run = make_run();
  StageRecord& stage = run.stages[2];
  stage.status = StageStatus::failed;
  stage.message = "step below 1e-12 s; joint 'A', 12.4 µm";
  const std::vector<double> hard = test::make_hard_values();
  std::copy(hard.begin(), hard.end(), stage.values[0].begin() + 10);
  stage.wear[0].total_depth_added.clear();
  stage.statistics[0].mean = hard[7];
  stage.events[0].angle = -0.0;
  stage.wear[0].bearing_depth[3] = hard[5];
  stage.wear[0].bearing_depth[4] = -0.0;
  run.overrides.emplace_back("name", "two\nlines \\n and µ");
  run.overrides.emplace_back("description", "");
  StageRecord& empty = run.stages.emplace_back();
  empty.name = "wear_2";
  empty.status = StageStatus::stopped;
  return run;
}

TEST(RunReader, ReadsEverythingBackToTheLastBit) {
  const ScratchDirectory scratch;
  const RunRecord run = make_hard_run();
  write_run(scratch / "x.h5", run);
  const RunRecord back = read_run(scratch / "x.h5");
  expect_same_header(run, back);
  ASSERT_EQ(back.stages.size(), run.stages.size());
  for (std::size_t k = 0; k < run.stages.size(); ++k) {
    expect_same_outline(run.stages[k], back.stages[k]);
    EXPECT_TRUE(have_same_bits(run.stages[k].time, back.stages[k].time));
    ASSERT_EQ(run.stages[k].values.size(), back.stages[k].values.size());
    for (std::size_t c = 0; c < run.stages[k].values.size(); ++c) {
      EXPECT_TRUE(have_same_bits(run.stages[k].values[c], back.stages[k].values[c]));
    }
  }
}

TEST(RunReader, OutlineLeavesValuesToBeReadLater) {
  const ScratchDirectory scratch;
  const RunRecord run = make_run();
  write_run(scratch / "x.h5", run);
  RunRecord outline = read_run_outline(scratch / "x.h5");
  expect_same_header(run, outline);
  StageRecord& stage = outline.stages[1];
  expect_same_outline(run.stages[1], stage);
  EXPECT_TRUE(stage.time.empty());
  EXPECT_EQ(stage.values, std::vector<std::vector<double>>(stage.channels.size()));

  const auto read = [&](std::vector<std::string> names) {
    read_channels(scratch / "x.h5", std::span(&stage, 1), [&](const StageRecord&) { return names; });
  };
  read({"A.normal_force", "slider.x"});
  EXPECT_TRUE(have_same_bits(stage.time, run.stages[1].time));
  EXPECT_TRUE(have_same_bits(stage.values[6], run.stages[1].values[6]));
  EXPECT_TRUE(have_same_bits(stage.values[0], run.stages[1].values[0]));
  EXPECT_TRUE(stage.values[1].empty());

  EXPECT_THAT(find_message<FileError>([&] { read({"slider.z"}); }),
              HasSubstr("stage 'no_wear': channel 'slider.z' was not recorded"));
}

/// How often this process has read so far.
double count_reads() {
  std::ifstream in("/proc/self/io");
  std::string key;
  double count = 0.0;
  while (in >> key >> count && key != "syscr:") continue;
  EXPECT_EQ(key, "syscr:");
  return count;
}

/// How often it reads for what 'gudgeon info' tells of a run of so many stages.
double measure_reading(std::size_t n_stages) {
  const ScratchDirectory scratch;
  RunRecord run = make_run();
  StageRecord stage = run.stages[1];
  run.stages.clear();
  for (std::size_t k = 0; k < n_stages; ++k) {
    stage.name = "wear_" + std::to_string(k);
    run.stages.push_back(stage);
  }
  write_run(scratch / "x.h5", run);
  const double before = count_reads();
  RunRecord outline = read_run_outline(scratch / "x.h5");
  read_channels(scratch / "x.h5", outline.stages, [](const StageRecord&) { return std::vector<std::string>{}; });
  EXPECT_EQ(outline.stages.back().time.size(), test::kSamples);
  return count_reads() - before;
}

// The list of stages lies in as many pieces as there were stages: read for each of them, it would take the square.
TEST(RunReader, ReadsInProportionToTheStages) {
  const double few = measure_reading(50);
  const double many = measure_reading(400);
  EXPECT_LT(many, 10.0 * few) << few << " and " << many;
}

TEST(RunReader, LongSeriesSpanManyChunks) {
  const ScratchDirectory scratch;
  RunRecord run = make_run();
  StageRecord& stage = run.stages[0];
  for (int i = 0; stage.time.size() < 100'003; ++i) stage.time.push_back(2.0 + 0.01 * i);
  for (auto& values : stage.values) values.resize(stage.time.size());
  for (std::size_t i = 0; i < stage.time.size(); ++i) stage.values[2][i] = std::sin(static_cast<double>(i));
  write_run(scratch / "x.h5", run);
  EXPECT_TRUE(have_same_bits(read_run(scratch / "x.h5").stages[0].values[2], stage.values[2]));
}

TEST(RunReader, RefusesWhatIsNoRunFile) {
  const ScratchDirectory scratch;
  EXPECT_THAT(find_message<FileError>([&] { read_run(scratch / "none.h5"); }), HasSubstr("No such file"));
  EXPECT_THAT(find_message<FileError>([&] { read_run(scratch.path()); }), HasSubstr("Is a directory"));
  test::write_text_file(scratch / "empty.h5", "");
  test::write_text_file(scratch / "garbage.h5", std::string(5000, '#'));
  for (const char* name : {"empty.h5", "garbage.h5"}) {
    const std::string message = find_message<FileError>([&] { read_run_outline(scratch / name); });
    EXPECT_THAT(message, HasSubstr(name));
    EXPECT_THAT(message, HasSubstr("not an HDF5 file; give a file that 'gudgeon run' wrote"));
  }
  test::write_image(scratch / "foreign.h5",
                    [](const Hdf5Handle& root) { write_text(root, "notes", "of another program"); });
  EXPECT_THAT(find_message<FileError>([&] { read_run(scratch / "foreign.h5"); }),
              HasSubstr("an HDF5 file of another program"));
}

TEST(RunReader, EveryTruncationIsAnErrorAndNoCrash) {
  const ScratchDirectory scratch;
  write_run(scratch / "x.h5", make_run());
  const std::string whole = test::read_text_file(scratch / "x.h5");
  for (std::size_t size = 0; size < whole.size(); size += whole.size() / 40) {
    test::write_text_file(scratch / "cut.h5", whole.substr(0, size));
    EXPECT_THROW(read_run(scratch / "cut.h5"), FileError) << size;
  }
}

// Reads a run file with one byte after the other spoiled; returns how often that is refused.
int read_damaged_files(const ScratchDirectory& scratch) {
  RunRecord small = make_run();
  small.stages.resize(2);
  write_run(scratch / "x.h5", small);
  const std::string whole = test::read_text_file(scratch / "x.h5");
  int n_errors = 0;
  for (std::size_t at = 0; at < whole.size(); at += 199) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x5A);
    test::write_text_file(scratch / "bad.h5", damaged);
    try {
      read_run(scratch / "bad.h5");
    } catch (const FileError&) {
      ++n_errors;
    }
  }
  return n_errors;
}

TEST(RunReader, DamageIsAnErrorOrHarmlessAndNoCrash) {
  const ScratchDirectory scratch;
  EXPECT_GT(read_damaged_files(scratch), 0);
}

TEST(RunReaderDeathTest, DamageLeavesNothingToCloseAtExit) {
  const ScratchDirectory scratch;
  EXPECT_EXIT(
      {
        read_damaged_files(scratch);
        std::exit(0);
      },
      testing::ExitedWithCode(0), testing::Not(HasSubstr("HDF5")));
}

TEST(RunReader, FailureIsAtTheRoot) {
  const ScratchDirectory scratch;
  write_run(scratch / "x.h5", make_hard_run());
  const Hdf5Session session;
  const Hdf5Source source(scratch / "x.h5");
  const Hdf5Handle failure = open_group(source.root(), "failure");
  EXPECT_EQ(read_text(failure, "message"), "step below 1e-12 s; joint 'A', 12.4 µm");
  EXPECT_EQ(read_text(failure, "stage_name"), "wear_1");
  EXPECT_EQ(read_real(failure, "time"), 2.0);
  // For other tools; it is not followed here.
  EXPECT_TRUE(has_link(failure, "stage"));
  EXPECT_TRUE(find_children(failure) == std::vector<std::string>({"stage_name", "message", "time"}));
}

}  // namespace
}  // namespace gudgeon
