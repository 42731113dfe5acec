// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Files that grow in place: what a kill leaves at any moment, and how much is written.
#include "gudgeon/io/growing_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/hdf5_dataset.h"
#include "gudgeon/io/hdf5_file.h"
#include "gudgeon/io/hdf5_node.h"
#include "gudgeon/io/page_journal.h"
#include "gudgeon/io/run_reader.h"
#include "gudgeon/io/run_writer.h"
#include "gudgeon/io/stage_reader.h"
#include "tests/io/image_file.h"
#include "tests/io/scratch_directory.h"
#include "tests/results/synthetic_run.h"
#include "tests/verification/book/record_fault.h"

namespace gudgeon {
namespace {

using test::find_message;
using test::ScratchDirectory;
using testing::HasSubstr;

void make_empty(const std::filesystem::path& file) {
  test::write_image(file, [](const Hdf5Handle& root) { make_group(root, "stages"); });
}

void add_series(const Hdf5Handle& root, const std::string& name, double value) {
  write_series(open_group(root, "stages"), name, std::vector<double>(1000, value));
}

std::vector<std::string> list_stages(const std::filesystem::path& file) {
  return find_members(open_group(Hdf5Source(file).root(), "stages"));
}

double read_first(const std::filesystem::path& file, const std::string& name) {
  return read_series(open_group(Hdf5Source(file).root(), "stages"), name).at(0);
}

TEST(GrowingFile, ChangesAreSeenOnceTheyAreCommitted) {
  const ScratchDirectory scratch;
  make_empty(scratch / "x.h5");
  const Hdf5Session session;
  GrowingFile file(scratch / "x.h5");
  file.change([](const Hdf5Handle& root) { add_series(root, "a", 1.0); });
  EXPECT_THAT(list_stages(scratch / "x.h5"), testing::IsEmpty());
  file.change([](const Hdf5Handle& root) { add_series(root, "b", 2.0); });
  EXPECT_TRUE(file.is_changed());
  file.commit();
  EXPECT_FALSE(file.is_changed());
  EXPECT_THAT(list_stages(scratch / "x.h5"), testing::ElementsAre("a", "b"));
  EXPECT_EQ(read_first(scratch / "x.h5", "b"), 2.0);
  EXPECT_FALSE(std::filesystem::exists(scratch / "x.h5.journal"));
}

TEST(GrowingFile, WhatIsNotCommittedLeavesNoByte) {
  const ScratchDirectory scratch;
  make_empty(scratch / "x.h5");
  const std::string before = test::read_text_file(scratch / "x.h5");
  const Hdf5Session session;
  {
    GrowingFile file(scratch / "x.h5");
    file.change([](const Hdf5Handle& root) { add_series(root, "a", 1.0); });
  }
  EXPECT_EQ(test::read_text_file(scratch / "x.h5"), before);
  GrowingFile file(scratch / "x.h5");
  EXPECT_THROW(file.change([](const Hdf5Handle& root) {
    add_series(root, "a", 1.0);
    throw FileError("no more");
  }),
               FileError);
  EXPECT_EQ(test::read_text_file(scratch / "x.h5"), before);
  file.change([](const Hdf5Handle& root) { add_series(root, "c", 3.0); });
  file.commit();
  EXPECT_THAT(list_stages(scratch / "x.h5"), testing::ElementsAre("c"));
}

/// The file before a commit, with what was added behind its end; the file after it; and the journal of the change.
struct Commit {
  std::string before;
  std::string after;
  std::string journal;
};

Commit record_commit(const ScratchDirectory& scratch) {
  const std::filesystem::path path = scratch / "x.h5";
  make_empty(path);
  const Hdf5Session session;
  Commit commit;
  PageJournal journal;
  {
    GrowingFile file(path);
    file.change([](const Hdf5Handle& root) { add_series(root, "a", 1.0); });
    commit.before = test::read_text_file(path);
    file.commit();
  }
  commit.after = test::read_text_file(path);
  journal.end = commit.after.size();
  const std::string first = commit.before.substr(0, Hdf5Target::kPageSize);
  std::ranges::copy(std::as_bytes(std::span(first)), journal.first_before.begin());
  for (std::size_t at = 0; at < commit.after.size(); at += Hdf5Target::kPageSize) {
    const std::string page = commit.after.substr(at, Hdf5Target::kPageSize);
    if (page == commit.before.substr(std::min(at, commit.before.size()), Hdf5Target::kPageSize)) continue;
    std::ranges::copy(std::as_bytes(std::span(page)), journal.pages[at / Hdf5Target::kPageSize].begin());
  }
  commit.journal = pack(journal);
  return commit;
}

TEST(GrowingFile, AKilledCommitIsSeenAndEnded) {
  const ScratchDirectory scratch;
  const Commit commit = record_commit(scratch);
  const Hdf5Session session;
  const std::filesystem::path path = scratch / "x.h5";
  ASSERT_NE(commit.before, commit.after);
  // Killed before the first page was changed, and half way through it.
  std::string half = commit.before;
  std::ranges::copy(commit.after.substr(0, 600), half.begin());
  for (const std::string& left : {commit.before, half}) {
    test::write_text_file(path, left);
    test::write_text_file(path.string() + ".journal", commit.journal);
    EXPECT_THAT(list_stages(path), testing::ElementsAre("a"));
    EXPECT_EQ(read_first(path, "a"), 1.0);
    EXPECT_EQ(test::read_text_file(path), left) << "reading changes nothing";
    GrowingFile file(path);
    EXPECT_FALSE(std::filesystem::exists(path.string() + ".journal"));
    EXPECT_EQ(test::read_text_file(path), commit.after);
  }
}

TEST(GrowingFile, AJournalThatIsNotWholeChangesNothing) {
  const ScratchDirectory scratch;
  const Commit commit = record_commit(scratch);
  const Hdf5Session session;
  const std::filesystem::path path = scratch / "x.h5";
  std::string spoiled = commit.journal;
  spoiled[spoiled.size() / 2] = static_cast<char>(spoiled[spoiled.size() / 2] ^ 1);
  for (const std::string& journal : {std::string(), std::string("gudgeon journal 1"),
                                     commit.journal.substr(0, commit.journal.size() - 1), spoiled}) {
    test::write_text_file(path, commit.before);
    test::write_text_file(path.string() + ".journal", journal);
    EXPECT_THAT(list_stages(path), testing::IsEmpty());
    GrowingFile file(path);
    file.change([](const Hdf5Handle& root) { add_series(root, "b", 2.0); });
    file.commit();
    EXPECT_THAT(list_stages(path), testing::ElementsAre("b"));
  }
}

TEST(GrowingFile, AJournalOfAnotherFileIsLeftAlone) {
  const ScratchDirectory scratch;
  const Commit commit = record_commit(scratch);
  const std::filesystem::path other = scratch / "other.h5";
  test::write_image(other, [](const Hdf5Handle& root) {
    make_group(root, "stages");
    write_text(root, "model_text", "another one");
  });
  test::write_text_file(other.string() + ".journal", commit.journal);
  const std::string before = test::read_text_file(other);
  const Hdf5Session session;
  EXPECT_EQ(read_text(Hdf5Source(other).root(), "model_text"), "another one");
  GrowingFile file(other);
  EXPECT_EQ(test::read_text_file(other), before);
}

TEST(GrowingFile, SavedChangesAreTakenUpAgain) {
  const ScratchDirectory scratch;
  const std::filesystem::path path = scratch / "x.h5";
  make_empty(path);
  const Hdf5Session session;
  std::string saved;
  std::string left;
  {
    GrowingFile file(path);
    file.change([](const Hdf5Handle& root) {
      static_cast<void>(SeriesMaker::growing(100).make(open_group(root, "stages"), "s", {}));
      extend_series(open_group(root, "stages"), "s", std::vector<double>(250, 1.0));
    });
    saved = file.save_changes();
    // What comes later is lost with the kill.
    file.change([](const Hdf5Handle& root) {
      extend_series(open_group(root, "stages"), "s", std::vector<double>(5000, 2.0));
      add_series(root, "lost", 3.0);
    });
    left = test::read_text_file(path);
  }
  test::write_text_file(path, left);
  GrowingFile file(path);
  EXPECT_FALSE(file.restore_changes(saved.substr(1)));
  ASSERT_TRUE(file.restore_changes(saved));
  file.change(
      [](const Hdf5Handle& root) { extend_series(open_group(root, "stages"), "s", std::vector<double>(50, 4.0)); });
  EXPECT_THAT(list_stages(path), testing::IsEmpty());
  file.commit();
  EXPECT_THAT(list_stages(path), testing::ElementsAre("s"));
  std::vector<double> wanted(250, 1.0);
  wanted.resize(300, 4.0);
  EXPECT_EQ(read_series(open_group(Hdf5Source(path).root(), "stages"), "s"), wanted);
  // It is of a state of the file that is past.
  EXPECT_FALSE(GrowingFile(path).restore_changes(saved));
}

RunRecord make_many_stages(int n) {
  RunRecord run = test::make_run();
  const StageRecord model = run.stages[2];
  run.stages.clear();
  for (int k = 0; k < n; ++k) {
    run.stages.push_back(model);
    run.stages.back().name = "wear_" + std::to_string(k);
    run.stages.back().values[0][17] = k;
  }
  return run;
}

/// Whether HDF5 by itself reads everything in the file.
bool is_readable_by_others(const std::filesystem::path& file) {
  const Hdf5Session session;
  const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (id < 0) return false;
  const Hdf5Handle handle(id);
  const auto read_each = [](hid_t object, const char* name, const H5O_info_t* info, void*) -> herr_t {
    if (info->type != H5O_TYPE_DATASET) return 0;
    try {
      const Hdf5Handle dataset = check_id(H5Dopen2(object, name, H5P_DEFAULT), "cannot open", name);
      check_values(dataset, name);
    } catch (const FileError&) {
      return -1;
    }
    return 0;
  };
  return H5Ovisit(handle.id(), H5_INDEX_NAME, H5_ITER_NATIVE, read_each, nullptr) >= 0;
}

/// Goes on with the file until it has all stages; each comes in two blocks and a rest. Writes a byte when it begins and
/// after each stage.
[[noreturn]] void write_rest(const std::filesystem::path& file, const RunRecord& run, std::size_t n_kept,
                             int progress) noexcept {
  std::vector<std::string> kept;
  for (std::size_t k = 0; k < n_kept; ++k) kept.push_back(run.stages[k].name);
  RunWriter writer(file, run, true, kept);
  if (::write(progress, "b", 1) != 1) ::_exit(1);
  for (std::size_t k = kept.size(); k < run.stages.size(); ++k) {
    StageRecord rest = run.stages[k];
    for (int block = 0; block < 2; ++block) {
      std::vector<std::vector<double>> values;
      for (std::vector<double>& of : rest.values) {
        values.emplace_back(of.begin(), of.begin() + 50);
        of.erase(of.begin(), of.begin() + 50);
      }
      writer.append(SampleBlock{rest.name, rest.channels, std::span(rest.time).first(50), values});
      rest.time.erase(rest.time.begin(), rest.time.begin() + 50);
    }
    writer.append(rest);
    if (::write(progress, "s", 1) != 1) ::_exit(1);
  }
  ::_exit(0);
}

/// Waits until so many bytes have come, or the other end is closed, and then for a share of the time the last one took;
/// `pace` [s] is that time, kept from before where there is only one.
void wait_into_stage(int progress, int n_bytes, double share, std::chrono::duration<double>& pace) {
  auto last = std::chrono::steady_clock::now();
  for (int k = 0; k < n_bytes; ++k) {
    char byte = 0;
    if (::read(progress, &byte, 1) != 1) return;
    const auto now = std::chrono::steady_clock::now();
    if (k > 0) pace = now - last;
    last = now;
  }
  std::this_thread::sleep_for(share * pace);
}

/// The stages from that one on, with the samples of their first channel.
std::vector<StageRecord> read_stages(const std::filesystem::path& file, std::size_t first) {
  const Hdf5Session session;
  const Hdf5Source source(file);
  const Hdf5Handle stages = open_group(source.root(), "stages");
  const std::vector<std::string> names = find_children(stages);
  std::vector<StageRecord> read;
  for (std::size_t k = first; k < names.size(); ++k) {
    read.push_back(read_stage_outline(stages, names[k]));
    const StageSamples samples(stages, names[k]);
    samples.read_time(read.back());
    samples.read_values(read.back(), 0);
  }
  return read;
}

TEST(GrowingFile, KillsOverAHundredStagesLoseNothing) {
  const ScratchDirectory scratch;
  const std::filesystem::path path = scratch / "x.h5";
#ifdef GUDGEON_SANITIZE
  const RunRecord run = make_many_stages(30);
#else
  const RunRecord run = make_many_stages(100);
#endif
  std::mt19937 random(7);
  std::chrono::duration<double> pace{0.0};
  std::size_t n_before = 0;
  int n_kills = 0;
  while (n_before < run.stages.size()) {
    int progress[2];
    ASSERT_EQ(::pipe(progress), 0);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) write_rest(path, run, n_before, progress[1]);
    ::close(progress[1]);
    // At most ten stages at a time, however fast the machine is at the moment.
    const int n_bytes = 1 + static_cast<int>(random() % 10);
    wait_into_stage(progress[0], n_bytes, static_cast<double>(random() % 1000) / 1000.0, pace);
    ::kill(child, SIGKILL);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ::close(progress[0]);
    n_kills += WIFSIGNALED(status) ? 1 : 0;
    ASSERT_LT(n_kills, 2000) << "no progress";
    if (!std::filesystem::exists(path)) continue;
    const std::vector<StageRecord> back = read_stages(path, n_before);
    for (std::size_t k = 0; k < back.size(); ++k) {
      ASSERT_EQ(back[k].name, run.stages[n_before + k].name);
      ASSERT_EQ(back[k].values[0], run.stages[n_before + k].values[0]);
    }
    const bool is_within_commit = std::filesystem::exists(path.string() + ".journal");
    ASSERT_TRUE(is_within_commit || n_kills % 5 != 0 || is_readable_by_others(path));
    n_before += back.size();
  }
  EXPECT_GT(n_kills, static_cast<int>(run.stages.size() / 20));
  const RunRecord back = read_run(path);
  int n_lost = 0;
  for (std::size_t k = 0; k < run.stages.size(); ++k) n_lost += back.stages[k].values == run.stages[k].values ? 0 : 1;
  book::record_fault({"kill at any moment while a hundred stages are written", n_kills, n_lost, "finished stages"});
}

/// [bytes] that this process handed to the system for writing.
std::uint64_t count_written() {
  std::ifstream io("/proc/self/io");
  std::string name;
  std::uint64_t count = 0;
  while (io >> name >> count) {
    if (name == "wchar:") return count;
  }
  return 0;
}

TEST(GrowingFile, EachStageIsWrittenOnce) {
  if (count_written() == 0) GTEST_SKIP() << "the system does not count what is written";
#ifdef GUDGEON_SANITIZE
  const std::vector<int> counts{1, 41};
#else
  const std::vector<int> counts{1, 10, 41, 100};
#endif
  for (const int n_stages : counts) {
    const ScratchDirectory scratch;
    const RunRecord run = make_many_stages(n_stages);
    const std::uint64_t before = count_written();
    {
      RunWriter writer(scratch / "x.h5", run, false);
      for (const StageRecord& stage : run.stages) writer.append(stage);
    }
    const auto written = static_cast<double>(count_written() - before);
    const auto size = static_cast<double>(std::filesystem::file_size(scratch / "x.h5"));
    EXPECT_LT(written, 2.2 * size) << n_stages;
    RecordProperty("written_" + std::to_string(n_stages), std::to_string(written / size));
  }
}

}  // namespace
}  // namespace gudgeon
