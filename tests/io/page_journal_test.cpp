// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A journal beside a run file that it does not belong to: told, and never read with it.
#include "gudgeon/io/page_journal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "gudgeon/io/run_reader.h"
#include "gudgeon/io/run_verifier.h"
#include "tests/io/scratch_directory.h"
#include "tests/io/written_run.h"
#include "tests/results/same_run.h"
#include "tests/results/synthetic_run.h"

namespace gudgeon {
namespace {

using test::RunBytes;
using test::ScratchDirectory;
using testing::ElementsAre;
using testing::HasSubstr;

/// A case of the same model: other numbers, in files of the same layout.
RunRecord make_setting(const std::string& name, const std::string& setting, double scale) {
  RunRecord run = test::make_run();
  run.case_name = name;
  run.overrides.clear();
  // Longer than what lies in the file's first page.
  for (int k = 0; k < 3000; ++k) run.resolved_model += std::to_string(k * 7919 % 10007);
  run.resolved_model += " clearance " + setting;
  for (StageRecord& stage : run.stages) {
    for (const Channel& channel : stage.channels) {
      if (find_statistics(stage, channel.name) == nullptr) stage.statistics.push_back({channel.name});
    }
    for (std::vector<double>& values : stage.values) {
      for (double& value : values) value *= scale;
    }
  }
  return run;
}

void write_first(const std::filesystem::path& file, RunRecord run, std::size_t n_stages) {
  run.stages.resize(n_stages);
  test::write_run(file, run);
}

Hdf5Target::Page take_page(const std::string& bytes, std::size_t number) {
  Hdf5Target::Page page{};
  const std::string part = bytes.substr(number * Hdf5Target::kPageSize, Hdf5Target::kPageSize);
  std::memcpy(page.data(), part.data(), part.size());
  return page;
}

/// The journal with which a run goes from so many stages to one more.
std::string make_journal(const ScratchDirectory& scratch, const RunRecord& run, std::size_t n_stages) {
  write_first(scratch / "before.h5", run, n_stages);
  write_first(scratch / "after.h5", run, n_stages + 1);
  const std::string before = test::read_text_file(scratch / "before.h5");
  const std::string after = test::read_text_file(scratch / "after.h5");
  PageJournal journal{after.size(), {}, take_page(before, 0)};
  for (std::size_t k = 0; k * Hdf5Target::kPageSize < before.size(); ++k) {
    if (take_page(before, k) != take_page(after, k)) journal.pages.emplace(k, take_page(after, k));
  }
  return pack(journal);
}

TEST(PageJournal, OfItsOwnFileIsReadWithIt) {
  const ScratchDirectory scratch;
  const RunRecord run = make_setting("base", "0.3 mm", 1.0);
  const std::string journal = make_journal(scratch, run, 1);
  // Its second stage lies behind the end.
  std::string bytes = test::read_text_file(scratch / "after.h5");
  const std::string before = test::read_text_file(scratch / "before.h5");
  bytes.replace(0, before.size(), before);
  test::write_text_file(scratch / "x.h5", bytes);
  EXPECT_EQ(read_run(scratch / "x.h5").stages.size(), 1U);
  test::write_text_file(scratch / "x.h5.journal", journal);
  EXPECT_EQ(read_run(scratch / "x.h5").stages.size(), 2U);
  EXPECT_FALSE(has_foreign_journal(scratch / "x.h5"));
}

TEST(PageJournal, OfAnotherCaseIsToldAndNotUsed) {
  const ScratchDirectory scratch;
  const RunRecord own = make_setting("base", "0.3 mm", 1.0);
  // Of another case, and of the same one with another value set; texts of the same lengths.
  for (const RunRecord& other : {make_setting("wide", "0.4 mm", 1.5), make_setting("base", "0.4 mm", 1.5)}) {
    for (const std::size_t n_stages : {0, 1, 2}) {
      const std::string journal = make_journal(scratch, other, n_stages);
      for (const std::size_t n_own : {0, 1, 2, 3}) {
        write_first(scratch / "x.h5", own, n_own);
        const std::string right = RunBytes(read_run(scratch / "x.h5")).bytes();
        test::write_text_file(scratch / "x.h5.journal", journal);
        EXPECT_TRUE(has_foreign_journal(scratch / "x.h5")) << n_stages << n_own;
        EXPECT_EQ(RunBytes(read_run(scratch / "x.h5")).bytes(), right) << n_stages << n_own;
        const RunVerification found = verify_run(scratch / "x.h5");
        EXPECT_THAT(found.errors, testing::IsEmpty());
        EXPECT_THAT(found.remarks,
                    ElementsAre(HasSubstr("x.h5.journal: belongs to another run file, and is not used")));
      }
    }
  }
}

}  // namespace
}  // namespace gudgeon
