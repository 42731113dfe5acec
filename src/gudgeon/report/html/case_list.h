// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// All cases of a study, a line each.
#pragma once

#include <cstddef>
#include <string>

#include "gudgeon/report/html/html_text.h"
#include "gudgeon/report/html/report_case.h"

namespace gudgeon {

class CaseList {
 public:
  /// extent: what of the case is on the page.
  void add(const ReportCase& one, const std::string& extent);
  [[nodiscard]] std::size_t size() const { return n_cases_; }
  /// Nothing for a single case.
  [[nodiscard]] std::string render() const;

 private:
  HtmlTable table_ = make_table();
  std::size_t n_cases_ = 0;
  static HtmlTable make_table();
};

/// Lines that a list has at most.
inline constexpr std::size_t kMostListed = 5000;

}  // namespace gudgeon
