// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Progress bars and lines on standard error.
#include "gudgeon/app/progress_display.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "gudgeon/app/text_output.h"
#include "gudgeon/base/shown_text.h"

namespace gudgeon {
namespace {

constexpr std::chrono::seconds kLineInterval{30};

double find_seconds(std::chrono::steady_clock::time_point since) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
}

/// Time left if every stage still to come takes as long as this one; negative while nothing can be said.
double estimate_remaining(double stage_seconds, double fraction, int n_stages_after) {
  if (fraction < 0.01) return -1.0;
  const double whole = stage_seconds / fraction;
  return whole - stage_seconds + n_stages_after * whole;
}

std::string render_remaining(double seconds) {
  return seconds < 0.0 ? std::string{} : fmt::format("about {} left", render_duration(seconds));
}

/// A bar with eighths of a character.
std::string render_bar(double fraction, int width) {
  static constexpr std::string_view kPartial[] = {"", "▏", "▎", "▍", "▌", "▋", "▊", "▉"};
  const int eighths = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * 8 * width);
  std::string bar;
  for (int i = 0; i < eighths / 8; ++i) bar += "█";
  bar += kPartial[eighths % 8];
  for (int i = eighths / 8 + (eighths % 8 != 0); i < width; ++i) bar += "░";
  return bar;
}

int find_columns() {
  struct winsize size {};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

}  // namespace

ProgressStyle find_progress_style() { return ::isatty(STDERR_FILENO) ? ProgressStyle::bars : ProgressStyle::lines; }

ProgressDisplay::ProgressDisplay(ProgressStyle style, const std::vector<std::string>& case_names) : style_(style) {
  cases_.resize(case_names.size());
  for (std::size_t i = 0; i < case_names.size(); ++i) cases_[i].name = show_controls(case_names[i]);
}

void ProgressDisplay::begin(int index) {
  const std::lock_guard lock(mutex_);
  CaseProgress& one = cases_[index];
  one.is_running = true;
  one.stage = "starting";
  one.start = one.stage_start = Clock::now();
}

void ProgressDisplay::update(int index, const Progress& progress) {
  const std::lock_guard lock(mutex_);
  CaseProgress& one = cases_[index];
  if (one.stage != progress.stage) one.stage = progress.stage, one.stage_start = Clock::now();
  one.stage_index = progress.stage_index;
  one.n_stages = progress.n_stages;
  one.fraction = progress.fraction;
}

void ProgressDisplay::finish(int index, std::string_view outcome) {
  const std::lock_guard lock(mutex_);
  CaseProgress& one = cases_[index];
  one.is_running = false;
  one.outcome += fmt::format("{}: {} after {}\n", one.name, outcome, render_duration(find_seconds(one.start)));
}

void ProgressDisplay::tell(int index, std::string_view line, bool is_error) {
  const std::lock_guard lock(mutex_);
  CaseProgress& one = cases_[index];
  const std::string text = fmt::format("{}: {}\n", one.name, line);
  if (style_ != ProgressStyle::silent) {
    one.outcome += text;
  } else if (is_error) {
    write_stderr("gudgeon: case " + text);
  }
}

void ProgressDisplay::add_message(std::string text) {
  const std::lock_guard lock(mutex_);
  messages_ += show_controls(text);
}

void ProgressDisplay::refresh() {
  if (style_ == ProgressStyle::silent) return;
  std::string text;
  {
    const std::lock_guard lock(mutex_);
    if (n_lines_ > 0) text += fmt::format("\x1b[{}A\r\x1b[J", n_lines_);
    n_lines_ = 0;
    write_outcomes(text);
    style_ == ProgressStyle::bars ? write_bars(text) : write_lines(text);
  }
  if (!text.empty()) write_display(text);
}

void ProgressDisplay::write_note(std::string_view text) {
  if (style_ == ProgressStyle::silent) return;
  std::string above;
  if (n_lines_ > 0) above = fmt::format("\x1b[{}A\r\x1b[J", n_lines_);
  n_lines_ = 0;
  write_display(above + std::string(text) + "\n");
}

void ProgressDisplay::write_outcomes(std::string& text) {
  text += messages_;
  messages_.clear();
  for (CaseProgress& one : cases_) {
    text += one.outcome;
    one.outcome.clear();
  }
}

void ProgressDisplay::write_bars(std::string& text) {
  const int columns = find_columns();
  for (const CaseProgress& one : cases_) {
    if (!one.is_running) continue;
    text += render_bar_line(one, columns) + "\n";
    ++n_lines_;
  }
}

void ProgressDisplay::write_lines(std::string& text) {
  for (CaseProgress& one : cases_) {
    if (!one.is_running || one.stage == "starting") continue;
    if (one.stage == one.shown_stage && Clock::now() - one.shown < kLineInterval) continue;
    text += render_plain_line(one) + "\n";
    one.shown_stage = one.stage;
    one.shown = Clock::now();
  }
}

std::string ProgressDisplay::render_bar_line(const CaseProgress& one, int columns) const {
  const double remaining =
      estimate_remaining(find_seconds(one.stage_start), one.fraction, one.n_stages - one.stage_index - 1);
  const std::string head =
      fmt::format("{:<10.20} {}/{} {:<8.12} ", one.name, one.stage_index + 1, one.n_stages, one.stage);
  const std::string tail = fmt::format(" {:3.0f} %  {}  {:<18}", std::floor(100.0 * one.fraction),
                                       render_duration(find_seconds(one.start)), render_remaining(remaining));
  // A line that wraps could not be taken back.
  const int width = columns - 1 - static_cast<int>(head.size() + tail.size());
  if (width < 4) return (head + tail).substr(0, static_cast<std::size_t>(std::max(columns - 1, 1)));
  return head + render_bar(one.fraction, std::min(width, 30)) + tail;
}

std::string ProgressDisplay::render_plain_line(const CaseProgress& one) const {
  const double remaining =
      estimate_remaining(find_seconds(one.stage_start), one.fraction, one.n_stages - one.stage_index - 1);
  return fmt::format("{}: {} (stage {} of {}), {:.0f} %, {} elapsed{}{}", one.name, one.stage, one.stage_index + 1,
                     one.n_stages, std::floor(100.0 * one.fraction), render_duration(find_seconds(one.start)),
                     remaining < 0.0 ? "" : ", ", render_remaining(remaining));
}

std::string render_duration(double seconds) {
  const long whole = std::lround(std::max(seconds, 0.0));
  if (whole >= 3600) return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

}  // namespace gudgeon
