// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Time and force in contact.
#include "gudgeon/analysis/contact_summary.h"

#include <gtest/gtest.h>

#include "tests/results/synthetic_run.h"

namespace gudgeon {
namespace {

TEST(ContactSummary, DividesTheTime) {
  const RunRecord run = test::make_run();
  EXPECT_TRUE(summarize_contacts(run.stages[0]).empty());
  const JointContactSummary summary = summarize_contacts(run.stages[1]).front();
  EXPECT_EQ(summary.joint, "A");
  EXPECT_EQ(summary.onsets, 3);
  EXPECT_DOUBLE_EQ(summary.contact_fraction, 0.3);
  EXPECT_DOUBLE_EQ(summary.flight_fraction, 0.7);
  EXPECT_NEAR(summary.lasting_fraction, 0.595 / 0.6, 1e-12);
  EXPECT_NEAR(summary.impact_fraction, 0.005 / 0.6, 1e-12);
  EXPECT_DOUBLE_EQ(summary.mean_force, 100.0);
  EXPECT_DOUBLE_EQ(summary.largest_force, 2000.0);
}

TEST(ContactSummary, CountsOnlyTimeWithinTheStage) {
  RunRecord run = test::make_run();
  run.stages[1].start_time = 0.3;  // the long stay began before and has 0.25 s left
  run.stages[1].events[1].duration = 0.25;
  run.stages[1].events.resize(2);
  const JointContactSummary summary = summarize_contacts(run.stages[1]).front();
  EXPECT_DOUBLE_EQ(summary.lasting_fraction, 1.0);
  EXPECT_DOUBLE_EQ(summary.impact_fraction, 0.0);
}

TEST(ContactSummary, JointThatNeverTouches) {
  RunRecord run = test::make_run();
  StageRecord& stage = run.stages[1];
  stage.events.clear();
  stage.statistics.clear();
  stage.wear[0].contact_time = stage.wear[0].impulse = 0.0;
  const JointContactSummary summary = summarize_contacts(stage).front();
  EXPECT_EQ(summary.flight_fraction, 1.0);
  EXPECT_EQ(summary.lasting_fraction, 0.0);
  EXPECT_EQ(summary.mean_force, 0.0);
  EXPECT_EQ(summary.largest_force, 0.0);
}

}  // namespace
}  // namespace gudgeon
