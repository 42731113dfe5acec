// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon draw.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/program.h"
#include "tests/report/drawn_labels.h"

namespace gudgeon::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

TEST(DrawCommand, DrawsToAFile) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"draw", find_slider_crank(), "-o", "x.svg"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "x.svg\n");
  const std::string svg = read_text(folder.path() / "x.svg");
  EXPECT_THAT(svg, StartsWith("<svg "));
  EXPECT_THAT(svg, HasSubstr(">pin</text>"));
  EXPECT_THAT(svg, HasSubstr("clearance joint"));
}

TEST(DrawCommand, DashIsStandardOutput) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"draw", find_slider_crank(), "-o", "-"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, StartsWith("<svg "));
}

TEST(DrawCommand, TimeMovesIt) {
  const TemporaryFolder folder;
  const Outcome start = run_program(folder, {"draw", find_slider_crank(), "-o", "-"});
  const Outcome later = run_program(folder, {"draw", find_slider_crank(), "-o", "-", "--time", "250 ms"});
  EXPECT_THAT(later.out, HasSubstr("t = 0.25 s"));
  EXPECT_NE(start.out, later.out);
}

TEST(DrawCommand, TraceFollowsAPoint) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"draw", find_slider_crank(), "-o", "-", "--trace", "crank.A"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("<polyline"));
}

TEST(DrawCommand, UnknownTracePointIsAUsageError) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"draw", find_slider_crank(), "-o", "-", "--trace", "crank.B"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("Did you mean 'crank."));
}

TEST(DrawCommand, TimeMustBeATime) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"draw", find_slider_crank(), "-o", "-", "--time", "3 mm"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("a length"));
}

TEST(DrawCommand, ExistingFileIsKeptWithoutOverwrite) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.write("x.svg", "mine");
  const Outcome refused = run_program(folder, {"draw", find_slider_crank(), "-o", "x.svg"});
  EXPECT_EQ(refused.exit_code, 5);
  EXPECT_EQ(read_text(file), "mine");
  const Outcome replaced = run_program(folder, {"draw", find_slider_crank(), "-o", "x.svg", "--overwrite"});
  EXPECT_EQ(replaced.exit_code, 0);
  EXPECT_THAT(read_text(file), Not(HasSubstr("mine")));
}

TEST(DrawCommand, MissingDirectoryIsAFileError) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"draw", find_slider_crank(), "-o", "nowhere/x.svg"});
  EXPECT_EQ(outcome.exit_code, 5);
  EXPECT_THAT(outcome.err, HasSubstr("nowhere/x.svg"));
}

// A scissor lift that is small on its sheet, because the path of its top point is long.
TEST(DrawCommand, NoNameOfAScissorLiftCoversAnother) {
  const TemporaryFolder folder;
  for (const std::vector<std::string>& trace : {std::vector<std::string>{}, {"--trace", "link_left_4.B"}}) {
    std::vector<std::string> arguments{"draw", find_case("draw_scissors"), "-o", "-"};
    arguments.insert(arguments.end(), trace.begin(), trace.end());
    const Outcome outcome = run_program(folder, arguments);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::vector<Label> labels = find_labels(outcome.out);
    EXPECT_EQ(labels.size(), 4U + 10U + 15U) << "title, time, scale, legend; bodies; joints";
    EXPECT_EQ(find_covered_labels(labels), "");
  }
}

// Two pins of the frame, in one slot of a plate, are marked as fixed, as is the crank's pivot.
TEST(DrawCommand, PinsOfTheFrameCarryItsMark) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program(folder, {"draw", find_case("draw_fixed_pins"), "-o", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::size_t frame = outcome.out.find("class=\"frame\"");
  const std::string supports = outcome.out.substr(frame, outcome.out.find("</g>", frame) - frame);
  EXPECT_EQ(find_tags(supports, "polygon").size(), 3U);
}

}  // namespace
}  // namespace gudgeon::test
