// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The report: one HTML file that needs nothing else.
#pragma once

#include <string>
#include <vector>

#include "gudgeon/report/figures/comparison_figures.h"
#include "gudgeon/report/html/block_store.h"
#include "gudgeon/report/html/json_text.h"
#include "gudgeon/report/html/report_case.h"

namespace gudgeon {

/// Grows case by case, so that only one case's samples are in memory.
class ReportPage {
 public:
  /// The cases share what room there is.
  explicit ReportPage(std::size_t n_cases);

  void add_case(const ReportCase& one);
  void add_comparisons(const std::vector<CaseComparison>& comparisons);
  /// Something that the reader must know about the whole, such as a file that could not be read.
  void add_warning(const std::string& text);
  [[nodiscard]] std::string render() const;

 private:
  std::size_t n_cases_;
  std::string title_;
  std::string warnings_;
  std::string choices_;
  std::string articles_;
  std::string comparisons_;
  JsonText figures_;
  JsonText cases_;
  BlockStore blocks_;
};

}  // namespace gudgeon
