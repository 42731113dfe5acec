// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One case's part of the page, as much of it as there is room for.
#pragma once

#include <optional>
#include <string>

#include "gudgeon/report/html/block_store.h"
#include "gudgeon/report/html/json_text.h"
#include "gudgeon/report/html/report_case.h"

namespace gudgeon {

struct CasePage {
  std::string article;  ///< sections in the order of a paper's results
  JsonText data;        ///< scene, motions, figures
  BlockStore blocks;    ///< the numbers of both
  std::string extent;   ///< what of the case is there, in a few words

  [[nodiscard]] std::size_t size() const { return article.size() + data.text().size() + blocks.html().size(); }
};

/// The case in so many bytes. Where they do not hold it, cycles become fewer, then signals go, then all figures; each
/// time the article says so. Nothing when not even the tables fit.
std::optional<CasePage> fit_case(const ReportCase& one, std::size_t bytes, int first_block);

}  // namespace gudgeon
