// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Run files with bits turned over, cut off, or with what a run file may not have: refused, or read with the same
// numbers.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/wait.h>
#include <unistd.h>

#include <random>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/hdf5_dataset.h"
#include "gudgeon/io/hdf5_node.h"
#include "gudgeon/io/run_reader.h"
#include "gudgeon/io/run_verifier.h"
#include "tests/io/image_file.h"
#include "tests/io/scratch_directory.h"
#include "tests/io/written_run.h"
#include "tests/results/same_run.h"
#include "tests/results/synthetic_run.h"
#include "tests/verification/book/record_fault.h"

namespace gudgeon {
namespace {

using test::find_message;
using test::RunBytes;
using test::ScratchDirectory;
using test::write_run;
using testing::HasSubstr;

/// Two stages with statistics of every channel, as runs have them.
RunRecord make_small_run() {
  RunRecord run = test::make_run();
  run.stages.erase(run.stages.begin());
  for (StageRecord& stage : run.stages) {
    for (const Channel& channel : stage.channels) {
      if (find_statistics(stage, channel.name) == nullptr) stage.statistics.push_back({channel.name});
    }
  }
  return run;
}

enum class Verdict : char { refused = 'r', same = 's', other = 'o', died = 'd' };

/// The file with one bit turned over, which the number draws.
std::string flip_bit(std::string whole, unsigned number) {
  std::mt19937_64 random(number);
  const std::uint64_t bit = random() % (whole.size() * 8);
  whole[bit / 8] = static_cast<char>(whole[bit / 8] ^ (1 << (bit % 8)));
  return whole;
}

Verdict read_flipped(const std::filesystem::path& file, const std::string& whole, const std::string& right,
                     unsigned number) {
  test::write_text_file(file, flip_bit(whole, number));
  try {
    return RunBytes(read_run(file)).bytes() == right ? Verdict::same : Verdict::other;
  } catch (const FileError&) {
    return Verdict::refused;
  }
}

/// Verdicts over flips from first on, in a process of its own, up to the one that it dies over.
std::string judge_flips(const ScratchDirectory& scratch, const std::string& whole, const std::string& right,
                        unsigned first, unsigned n) {
  int pipe_ends[2];
  if (::pipe(pipe_ends) != 0) return "";
  const pid_t child = ::fork();
  if (child == 0) {
    for (unsigned k = first; k < n; ++k) {
      const auto verdict = static_cast<char>(read_flipped(scratch / "flipped.h5", whole, right, k));
      if (::write(pipe_ends[1], &verdict, 1) != 1) ::_exit(1);
    }
    ::_exit(0);
  }
  ::close(pipe_ends[1]);
  std::string verdicts;
  for (char verdict = 0; ::read(pipe_ends[0], &verdict, 1) == 1;) verdicts += verdict;
  ::close(pipe_ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  if (first + verdicts.size() < n) verdicts += static_cast<char>(Verdict::died);
  return verdicts;
}

TEST(Damage, NoBitOfAThousandChangesANumberUnseen) {
#ifdef GUDGEON_SANITIZE
  constexpr unsigned kFlips = 100;
#else
  constexpr unsigned kFlips = 1000;
#endif
  const ScratchDirectory scratch;
  const RunRecord run = make_small_run();
  write_run(scratch / "x.h5", run);
  const std::string whole = test::read_text_file(scratch / "x.h5");
  const std::string right = RunBytes(read_run(scratch / "x.h5")).bytes();
  ASSERT_EQ(right, RunBytes(run).bytes());
  std::string verdicts;
  while (verdicts.size() < kFlips) {
    const std::string more = judge_flips(scratch, whole, right, static_cast<unsigned>(verdicts.size()), kFlips);
    ASSERT_FALSE(more.empty());
    verdicts += more;
  }
  const auto count = [&](Verdict verdict) { return std::ranges::count(verdicts, static_cast<char>(verdict)); };
  EXPECT_EQ(count(Verdict::other), 0) << verdicts.find('o');
  EXPECT_EQ(count(Verdict::died), 0) << verdicts.find('d');
  // Most of the file is numbers and what leads to them.
  EXPECT_GT(count(Verdict::refused), kFlips / 2);
  book::record_fault({"one bit of a run file turned over", kFlips,
                      static_cast<int>(count(Verdict::other) + count(Verdict::died)),
                      "numbers changed unseen or readers ended"});
}

TEST(Damage, VerificationNamesWhatIsDamaged) {
  const ScratchDirectory scratch;
  RunRecord run = make_small_run();
  for (std::size_t i = 0; i < run.stages[0].time.size(); ++i) run.stages[0].values[2][i] = std::sin(1.7 * double(i));
  run.stages[0].time.resize(0);
  for (auto& values : run.stages[0].values) values.resize(0);
  // Long enough for a chunk with a checksum of its own.
  for (int i = 0; i < 2000; ++i) {
    run.stages[0].time.push_back(1e-3 * i);
    for (auto& values : run.stages[0].values) values.push_back(std::sin(1.7 * i));
  }
  write_run(scratch / "x.h5", run);
  const RunVerification sound = verify_run(scratch / "x.h5");
  EXPECT_TRUE(sound.errors.empty());
  EXPECT_TRUE(sound.has_checksums);
  EXPECT_EQ(sound.n_stages, 2u);
  EXPECT_GT(sound.n_datasets, 100u);
  std::uint64_t address = 0;
  {
    const Hdf5Session session;
    const Hdf5Source source(scratch / "x.h5");
    const Hdf5Handle dataset = open_dataset(
        open_group(open_group(open_group(open_group(source.root(), "stages"), "no_wear"), "channels"), "slider"),
        "x_acceleration");
    hsize_t offset = 0;
    unsigned mask = 0;
    haddr_t place = 0;
    hsize_t size = 0;
    const Hdf5Handle space = check_id(H5Dget_space(dataset.id()), "cannot measure", "dataset");
    ASSERT_GE(H5Dget_chunk_info(dataset.id(), space.id(), 0, &offset, &mask, &place, &size), 0);
    address = place + size / 2;
  }
  std::string damaged = test::read_text_file(scratch / "x.h5");
  damaged[address] = static_cast<char>(damaged[address] ^ 4);
  test::write_text_file(scratch / "x.h5", damaged);
  const RunVerification found = verify_run(scratch / "x.h5");
  ASSERT_EQ(found.errors.size(), 1u);
  EXPECT_THAT(found.errors[0], HasSubstr("/stages/no_wear/channels/slider/x_acceleration: cannot read dataset"));
  EXPECT_THAT(find_message<FileError>([&] { require_sound(scratch / "x.h5"); }), HasSubstr("x.h5: is damaged"));
  EXPECT_THAT(find_message<FileError>([&] { read_run(scratch / "x.h5"); }),
              HasSubstr("stage 'no_wear': cannot read dataset 'x_acceleration'"));
}

TEST(Damage, FormatOneHasNoChecksums) {
  const RunVerification found = verify_run(GUDGEON_SOURCE_DIR "/tests/io/files/format_1.h5");
  EXPECT_THAT(found.errors, testing::IsEmpty());
  EXPECT_EQ(found.format_version, 1);
  EXPECT_FALSE(found.has_checksums);
  EXPECT_EQ(found.n_stages, 3u);
}

/// What reading says of a run file whose stages a foreign hand changed.
std::string read_changed(const std::function<void(const Hdf5Handle& root)>& change) {
  const ScratchDirectory scratch;
  write_run(scratch / "x.h5", make_small_run());
  write_run(scratch / "other.h5", make_small_run());
  {
    const Hdf5Session session;
    const Hdf5Handle file =
        check_id(H5Fopen((scratch / "x.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT), "cannot open", "x.h5");
    change(open_root(file));
  }
  return find_message<FileError>([&] { read_run(scratch / "x.h5"); });
}

/// The group of the slider's channels.
Hdf5Handle open_slider(const Hdf5Handle& root) {
  return open_group(open_group(open_group(open_group(root, "stages"), "wear_1"), "channels"), "slider");
}

TEST(Damage, LinksToOtherFilesAreNotFollowed) {
  EXPECT_THAT(read_changed([](const Hdf5Handle& root) {
                const Hdf5Handle stages = open_group(root, "stages");
                remove_link(stages, "wear_1");
                check_status(
                    H5Lcreate_external("other.h5", "/stages/wear_1", stages.id(), "wear_1", H5P_DEFAULT, H5P_DEFAULT),
                    "cannot link", "");
              }),
              HasSubstr("member 'wear_1' is a link to elsewhere"));
  EXPECT_THAT(read_changed([](const Hdf5Handle& root) {
                const Hdf5Handle channels = open_slider(root);
                remove_link(channels, "x");
                check_status(H5Lcreate_external("other.h5", "/stages/wear_1/channels/slider/x", channels.id(), "x",
                                                H5P_DEFAULT, H5P_DEFAULT),
                             "cannot link", "");
              }),
              HasSubstr("member 'x' is a link to elsewhere"));
  EXPECT_THAT(read_changed([](const Hdf5Handle& root) {
                remove_link(root, "model_text");
                make_soft_link(root, "model_text", "/resolved_model");
              }),
              HasSubstr("dataset 'model_text' is a link to elsewhere"));
}

TEST(Damage, ValuesInOtherFilesAreNotRead) {
  EXPECT_THAT(read_changed([](const Hdf5Handle& root) {
                const Hdf5Handle channels = open_slider(root);
                remove_link(channels, "x");
                const hsize_t size = test::kSamples;
                const Hdf5Handle space = check_id(H5Screate_simple(1, &size, nullptr), "cannot make", "space");
                const Hdf5Handle storage = check_id(H5Pcreate(H5P_DATASET_CREATE), "cannot make", "storage");
                H5Pset_external(storage.id(), "other.h5", 0, size * sizeof(double));
                const Hdf5Handle dataset = check_id(
                    H5Dcreate2(channels.id(), "x", H5T_IEEE_F64LE, space.id(), H5P_DEFAULT, storage.id(), H5P_DEFAULT),
                    "cannot make", "dataset");
                write_text_attribute(dataset, "symbol", "x");
                write_text_attribute(dataset, "description", "of another file");
              }),
              HasSubstr("dataset 'x' keeps its values in another file"));
}

TEST(Damage, GroupsThatLeadBackAreNamedOnce) {
  const ScratchDirectory scratch;
  write_run(scratch / "x.h5", make_small_run());
  {
    const Hdf5Session session;
    const Hdf5Handle file =
        check_id(H5Fopen((scratch / "x.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT), "cannot open", "x.h5");
    const Hdf5Handle root = open_root(file);
    const Hdf5Handle stage = open_group(open_group(root, "stages"), "wear_1");
    check_status(H5Lcreate_hard(root.id(), "stages", stage.id(), "back", H5P_DEFAULT, H5P_DEFAULT), "cannot link", "");
  }
  const RunVerification found = verify_run(scratch / "x.h5");
  ASSERT_EQ(found.errors.size(), 1u);
  EXPECT_EQ(found.errors[0], "/stages/wear_1/back: it is /stages under another name, too");
}

/// What reading says of a run that was changed before it was written.
std::string read_impossible(const std::function<void(StageRecord& stage)>& change) {
  const ScratchDirectory scratch;
  RunRecord run = make_small_run();
  change(run.stages[1]);
  write_run(scratch / "x.h5", run);
  return find_message<FileError>([&] { read_run(scratch / "x.h5"); });
}

TEST(Damage, ImpossibleValuesAreRefusedByName) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(read_impossible([&](StageRecord& stage) { stage.cycles = -1; }), HasSubstr("'cycles' is -1"));
  EXPECT_THAT(read_impossible([&](StageRecord& stage) { stage.end_time = nan; }), HasSubstr("'end_time' is nan"));
  EXPECT_THAT(read_impossible([&](StageRecord& stage) { stage.time[7] = nan; }),
              HasSubstr("'time' of sample 7 is nan"));
  EXPECT_THAT(read_impossible([&](StageRecord& stage) { stage.time[7] = -3.0; }),
              HasSubstr("'time' of sample 7 is -3, which cannot follow 0.06"));
  EXPECT_THAT(read_impossible([&](StageRecord& stage) { stage.energy.friction = nan; }),
              HasSubstr("'friction' is nan"));
  EXPECT_THAT(read_impossible([&](StageRecord& stage) { stage.solver.onsets = -2; }), HasSubstr("'onsets' is -2"));
  EXPECT_THAT(read_impossible([&](StageRecord& stage) { stage.wear[0].bearing_radius = 0.0; }),
              HasSubstr("'bearing_radius' is 0"));
  EXPECT_THAT(read_impossible([&](StageRecord& stage) { stage.wear[0].journal_depth[3] = nan; }),
              HasSubstr("'journal_depth' is nan"));
  EXPECT_THAT(read_impossible([&](StageRecord& stage) { stage.wear[0].bearing_depth_added.pop_back(); }),
              HasSubstr("the depths of joint 'A' are not as many as its cells"));
  EXPECT_THAT(read_impossible([&](StageRecord& stage) { stage.events[1].joint = 4; }),
              HasSubstr("an event names joint 4 of 1"));
  EXPECT_THAT(read_impossible([&](StageRecord& stage) { stage.events[1].duration = -1.0; }),
              HasSubstr("'duration' is -1"));
  EXPECT_THAT(
      read_impossible([&](StageRecord& stage) { std::swap(stage.statistics[0].minimum, stage.statistics[0].maximum); }),
      HasSubstr("the minimum of channel 'slider.x_acceleration'"));
  EXPECT_THAT(read_changed([](const Hdf5Handle& root) {
                const Hdf5Handle stage = open_group(open_group(root, "stages"), "wear_1");
                remove_link(stage, "cycles");
                write_count(stage, "cycles", std::int64_t{1} << 62);
              }),
              HasSubstr("'cycles' is 4611686018427387904, which no run has"));
  EXPECT_THAT(read_changed([](const Hdf5Handle& root) {
                const Hdf5Handle channels = open_slider(root);
                remove_link(channels, "x");
                const Hdf5Handle series = write_series(channels, "x", std::vector<double>(7));
                write_text_attribute(series, "symbol", "x");
                write_text_attribute(series, "description", "of another length");
              }),
              HasSubstr("channel 'slider.x' has 7 samples where time has 201"));
}

// A dataset may claim any size without a byte behind it.
TEST(Damage, ClaimsOfMoreThanTheFileHoldsAreRefused) {
  EXPECT_THAT(read_changed([](const Hdf5Handle& root) {
                const Hdf5Handle channels = open_slider(root);
                remove_link(channels, "x");
                const Hdf5Handle series = SeriesMaker::growing(1000).make(channels, "x", {});
                const hsize_t size = hsize_t{1} << 33;
                check_status(H5Dset_extent(series.id(), &size), "cannot extend", "x");
                write_text_attribute(series, "symbol", "x");
                write_text_attribute(series, "description", "64 GiB of nothing");
              }),
              HasSubstr("dataset 'x' claims more values than the file holds"));
}

}  // namespace
}  // namespace gudgeon
