// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Shows how far each case has come: moving bars on a terminal, now and then a line elsewhere.
#pragma once

#include <chrono>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "gudgeon/sim/run_study.h"

namespace gudgeon {

enum class ProgressStyle { bars, lines, silent };

/// Bars when standard error is a terminal, lines when not.
ProgressStyle find_progress_style();

class ProgressDisplay {
 public:
  ProgressDisplay(ProgressStyle style, const std::vector<std::string>& case_names);

  // From the thread that runs the case.
  void begin(int index);
  void update(int index, const Progress& progress);
  void finish(int index, std::string_view outcome);
  /// A line about the case; one that tells of an error is written whatever the style.
  void tell(int index, std::string_view line, bool is_error);

  /// A message that waits to be shown among the outcomes; from any thread.
  void add_message(std::string text);

  // From the thread that owns the terminal.
  void refresh();
  /// A message of its own, above the bars.
  void write_note(std::string_view text);

 private:
  using Clock = std::chrono::steady_clock;
  struct CaseProgress {
    std::string name;
    std::string stage;
    int stage_index = 0;
    int n_stages = 1;
    double fraction = 0.0;
    bool is_running = false;
    std::string outcome;      ///< lines that wait to be shown; empty otherwise
    std::string shown_stage;  ///< of the last line written
    Clock::time_point start;
    Clock::time_point stage_start;
    Clock::time_point shown;
  };

  [[nodiscard]] std::string render_bar_line(const CaseProgress& one, int columns) const;
  [[nodiscard]] std::string render_plain_line(const CaseProgress& one) const;
  void write_outcomes(std::string& text);
  void write_bars(std::string& text);
  void write_lines(std::string& text);

  ProgressStyle style_;
  std::mutex mutex_;
  std::vector<CaseProgress> cases_;
  std::string messages_;
  int n_lines_ = 0;  ///< bars on the terminal below which the cursor stands
};

/// "1:05", "2:00:07"
std::string render_duration(double seconds);

}  // namespace gudgeon
