// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The page's size, whatever the number of cases.
#include "gudgeon/report/html/page.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/results/synthetic_run.h"

namespace gudgeon {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

/// The made-up run, recorded over many cycles.
ReportCase make_long_case(int number, int cycles) {
  ReportCase one;
  one.run = test::make_run();
  one.run.case_name = fmt::format("case_{}", number);
  one.mechanism = "many";
  for (StageRecord& stage : one.run.stages) {
    const double step = stage.time[1] - stage.time[0];
    const std::size_t n = stage.time.size() * static_cast<std::size_t>(cycles) / 2;
    for (std::size_t k = stage.time.size(); k < n; ++k) stage.time.push_back(step * static_cast<double>(k));
    for (std::vector<double>& values : stage.values) {
      for (std::size_t k = values.size(); k < n; ++k) values.push_back(std::sin(0.1 * static_cast<double>(k)));
    }
  }
  return one;
}

std::string make_page(int n_cases, int cycles, std::size_t text_size) {
  ReportPage page(static_cast<std::size_t>(n_cases));
  for (int k = 0; k < n_cases; ++k) {
    ReportCase one = make_long_case(k, cycles);
    one.run.model_text.assign(text_size, 'x');
    page.add_case(one);
  }
  return page.render();
}

TEST(ReportPage, HoldsAShortRunWhole) {
  const std::string page = make_page(1, 4, 0);
  EXPECT_THAT(page, Not(HasSubstr("sample by sample")));
  EXPECT_THAT(page, Not(HasSubstr("All cases, after their last stage")));
}

TEST(ReportPage, WarnsOfAStageThatDoesNotAddUp) {
  ReportPage page(2);
  ReportCase one = make_long_case(0, 4);
  page.add_case(one);
  one.run.case_name = "off";
  one.run.stages[1].energy.friction += 1.0;
  page.add_case(one);
  const std::string html = page.render();
  EXPECT_EQ(count(html, "E-NUM-020"), 1U);
  EXPECT_THAT(html, HasSubstr("Stage “no wear”: E-NUM-020: its energy balance does not close"));
  EXPECT_EQ(count(html, "finished, energy balance does not close"), 1U);
}

TEST(ReportPage, SaysWhatOfALongRunIsReduced) {
  EXPECT_THAT(make_page(1, 60, 0), HasSubstr("Of every stage the last 20 cycles are here sample by sample. Of those "
                                             "before, each of 1000 spans"));
}

TEST(ReportPage, ThirtyCasesAreAllShownBelow15Megabytes) {
  const std::string page = make_page(30, 100, 100'000);
  EXPECT_LT(page.size(), kPageSize);
  EXPECT_GT(page.size(), kPageSize / 2) << "room is used";
  EXPECT_EQ(count(page, "<article "), 30U);
  EXPECT_EQ(count(page, "<option "), 30U);
  EXPECT_THAT(page, HasSubstr("All cases, after their last stage"));
}

TEST(ReportPage, OfVeryManyCasesSomeAreALine) {
  const std::string page = make_page(150, 100, 100'000);
  EXPECT_LT(page.size(), kPageSize);
  EXPECT_GT(count(page, "<article "), 20U);
  EXPECT_LT(count(page, "<article "), 150U);
  EXPECT_EQ(count(page, "<article "), count(page, "<option "));
  for (const int k : {0, 75, 149}) EXPECT_THAT(page, HasSubstr(fmt::format(">case_{}</th>", k)));
  EXPECT_THAT(page, HasSubstr("of 150 cases; the others are in this list only"));
}

TEST(ReportPage, TextThatLeavesNoRoomForSignalsLeavesTables) {
  // The model's text takes nearly all of the share of 430 kB.
  const std::string page = make_page(30, 100, 400'000);
  EXPECT_LT(page.size(), kPageSize);
  EXPECT_THAT(page, HasSubstr("Of this one, tables"));
  EXPECT_THAT(page, HasSubstr("made of its run file"));
}

}  // namespace
}  // namespace gudgeon
