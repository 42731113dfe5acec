// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The report: one HTML file that needs nothing else.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "gudgeon/report/figures/comparison_figures.h"
#include "gudgeon/report/html/case_list.h"
#include "gudgeon/report/html/json_text.h"
#include "gudgeon/report/html/report_case.h"

namespace gudgeon {

/// [bytes] that a page may take: mail and browsers take 15 MB well.
inline constexpr std::size_t kPageSize = 15'000'000;

/// Grows case by case, so that only one case's samples are in memory. However many cases there are, it stays below
/// kPageSize: each gets its share, and when no more than kLeastCaseSize are left, only its line in the list of cases.
class ReportPage {
 public:
  explicit ReportPage(std::size_t n_cases);

  /// False when the next case will be no more than a line: its samples need not be read.
  [[nodiscard]] bool has_room() const;
  void add_case(const ReportCase& one);
  void add_comparisons(const std::vector<CaseComparison>& comparisons);
  /// Something that the reader must know about the whole, such as a file that could not be read.
  void add_warning(const std::string& text);
  [[nodiscard]] std::string render() const;

 private:
  [[nodiscard]] std::size_t find_share() const;
  [[nodiscard]] std::string render_comparison() const;

  std::size_t n_cases_;
  std::size_t room_;  ///< [bytes] left for cases
  std::size_t n_shown_ = 0;
  int n_blocks_ = 0;
  std::string title_;
  std::string warnings_;
  std::string choices_;
  std::string articles_;
  std::string blocks_;
  std::string left_out_;  ///< what of the comparisons is not there
  CaseList list_;
  JsonText comparisons_;
  JsonText cases_;
};

}  // namespace gudgeon
