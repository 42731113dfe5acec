// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What a verification test uses: a case whose numbers are checked and go into docs/verification.md.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "tests/verification/book/entry.h"

namespace gudgeon::book {

/// Checks numbers against their references; what was checked is written when the recorder goes out of scope.
class Recorder {
 public:
  explicit Recorder(Case about) : entry_{std::move(about), {}} {}
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;
  ~Recorder() { write_entry(GUDGEON_BOOK_ENTRIES, entry_); }

  /// Expects |ours − reference| <= tolerance.
  void verify(std::string quantity, double reference, double ours, double tolerance) {
    EXPECT_LE(std::abs(ours - reference), tolerance)
        << quantity << ": ours is " << ours << ", the reference " << reference;
    EXPECT_TRUE(std::isfinite(ours)) << quantity;
    entry_.lines.push_back({std::move(quantity), reference, ours, tolerance});
  }

 private:
  Entry entry_;
};

}  // namespace gudgeon::book
