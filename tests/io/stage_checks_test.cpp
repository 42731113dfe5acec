// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Names and texts that no run has: they neither command a terminal nor name a file.
#include "gudgeon/io/stage_checks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/base/shown_text.h"
#include "gudgeon/io/run_reader.h"
#include "tests/io/scratch_directory.h"
#include "tests/io/written_run.h"
#include "tests/results/synthetic_run.h"

namespace gudgeon {
namespace {

using test::find_message;
using test::ScratchDirectory;
using testing::HasSubstr;

/// What reading says of a run that was changed before it was written; fit to be shown on one line.
std::string read_odd(const std::function<void(StageRecord& stage)>& change) {
  const ScratchDirectory scratch;
  RunRecord run = test::make_run();
  change(run.stages[2]);
  test::write_run(scratch / "x.h5", run);
  std::string message = find_message<FileError>([&] { read_run_outline(scratch / "x.h5"); });
  EXPECT_EQ(show_line(message), message);
  EXPECT_LT(message.size(), 1500U);
  return message;
}

TEST(StageChecks, StagesAreNamedAsFilesMayBe) {
  const auto name = [](std::string text) { return [=](StageRecord& stage) { stage.name = text; }; };
  for (const char* odd : {"wear 1", "..", "wear_1\n", "\x1b[2J", "a\u202Eb", "wear\\1"}) {
    EXPECT_THAT(read_odd(name(odd)), HasSubstr("no run has a stage of the name '" + show_line(odd) + "'")) << odd;
  }
  EXPECT_THAT(read_odd(name(std::string(5000, 'w'))), HasSubstr("characters left out"));
  EXPECT_NO_THROW(check_stage_name("wear_100"));
}

TEST(StageChecks, TextsAreOneLineWithoutControls) {
  EXPECT_THAT(read_odd([](StageRecord& stage) { stage.channels[1].name = "slider.x\n  E-NUM-001"; }),
              HasSubstr("the channel 'slider.x\\u000A  E-NUM-001' holds control characters"));
  EXPECT_THAT(read_odd([](StageRecord& stage) { stage.channels[1].unit = "m\r"; }),
              HasSubstr("the unit 'm\\u000D' holds control characters"));
  EXPECT_THAT(read_odd([](StageRecord& stage) { stage.channels[1].symbol = "\u2066x"; }),
              HasSubstr("the symbol '\\u2066x' holds control characters"));
  EXPECT_THAT(read_odd([](StageRecord& stage) { stage.channels[1].description = "a\x1b]0;b"; }),
              HasSubstr("the description 'a\\u001B]0;b' holds control characters"));
  EXPECT_THAT(read_odd([](StageRecord& stage) { stage.wear[0].joint = "A\tB"; }),
              HasSubstr("the joint 'A\\u0009B' holds control characters"));
  EXPECT_THAT(read_odd([](StageRecord& stage) { stage.statistics[0].channel = "a\u0085"; }),
              HasSubstr("the channel 'a\\u0085' holds control characters"));
}

}  // namespace
}  // namespace gudgeon
