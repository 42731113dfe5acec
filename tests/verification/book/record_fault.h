// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What a test that tries faults uses, at its end.
#pragma once

#include <gtest/gtest.h>

#include "tests/verification/book/fault.h"

namespace gudgeon::book {

/// Puts what the running test tried into docs/verification.md; fails where something was lost.
inline void record_fault(const Fault& fault) {
  EXPECT_GT(fault.n_tried, 0) << fault.kind;
  EXPECT_EQ(fault.n_lost, 0) << fault.lost << " by " << fault.kind;
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  write_fault(std::string(test->test_suite_name()) + "_" + test->name(), fault);
}

}  // namespace gudgeon::book
