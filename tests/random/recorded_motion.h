// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A recorded motion beside the textbook form of its mechanism.
#pragma once

#include <string>

#include "gudgeon/results/run_record.h"
#include "tests/oracle/textbook.h"

namespace gudgeon::random {

/// Values of a stage by body and joint; throws std::out_of_range for a channel that was not recorded.
class RecordedMotion {
 public:
  RecordedMotion(const Mechanism& mechanism, const StageRecord& stage) : textbook_(mechanism), stage_(stage) {}

  [[nodiscard]] const oracle::Textbook& textbook() const { return textbook_; }
  [[nodiscard]] std::size_t n_samples() const { return stage_.time.size(); }
  [[nodiscard]] double time(std::size_t sample) const { return stage_.time[sample]; }
  [[nodiscard]] double value(const std::string& channel, std::size_t sample) const;
  [[nodiscard]] oracle::TextbookState state(std::size_t sample) const;

 private:
  oracle::Textbook textbook_;
  const StageRecord& stage_;
};

/// The largest gap of any ideal joint and driver at a sample [m, rad]: what should be zero in exact arithmetic.
double find_largest_gap(const RecordedMotion& motion, std::size_t sample);

/// Expects bodies to accelerate and joints to carry as the textbook has it. Where constraints are dependent, what every
/// body feels from all its joints together.
void expect_same_dynamics(const RecordedMotion& motion, std::size_t sample, double tolerance);

/// A state by many small steps of the textbook form, and how far it can be relied on.
struct TextbookEnd {
  oracle::TextbookState state;
  double error = 0.0;  ///< [m, rad] what half the step changes
};

/// From one state on, over the time given, in steps that are halved until it no longer matters.
TextbookEnd integrate(const oracle::Textbook& textbook, const oracle::TextbookState& start, double from, double to);

/// The largest distance between two states' bodies [m, rad].
double find_distance(const oracle::TextbookState& a, const oracle::TextbookState& b);

}  // namespace gudgeon::random
