// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Cases, their comparison, data, script; and what each may take of the page.
#include "gudgeon/report/html/page.h"

#include <fmt/format.h>

#include <algorithm>

#include "gudgeon/report/html/case_page.h"
#include "gudgeon/report/html/case_sections.h"
#include "gudgeon/report/html/figure_data.h"
#include "gudgeon/report/html/html_text.h"
#include "gudgeon/report/html/page_assets.h"

namespace gudgeon {

namespace {

// Of the page's size.
constexpr std::size_t kSlack = 300'000;             // [bytes] header, footer, warnings
constexpr std::size_t kComparisonSize = 1'500'000;  // [bytes]
constexpr std::size_t kLeastCaseSize = 400'000;     // [bytes] of a nine-bar's: texts, worn surfaces, a cycle
constexpr std::size_t kLineSize = 500;              // [bytes] of a case in the list and in the choice

}  // namespace

ReportPage::ReportPage(std::size_t n_cases)
    : n_cases_(n_cases), room_(kPageSize - kSlack - page_script().size() - page_style().size()) {
  if (n_cases_ > 1) room_ -= kComparisonSize;
  cases_.begin_array();
  comparisons_.begin_array();
}

std::size_t ReportPage::find_share() const {
  const std::size_t n_left = std::max<std::size_t>(1, n_cases_ - std::min(n_cases_, list_.size()));
  const std::size_t lines = kLineSize * std::min(n_left, kMostListed);
  const std::size_t room = room_ - std::min(room_, lines);
  // Many cases get a share that shows something, as many of them as there is room for.
  return std::min(room, std::max(room / n_left, kLeastCaseSize));
}

bool ReportPage::has_room() const { return find_share() >= kLeastCaseSize; }

void ReportPage::add_case(const ReportCase& one) {
  if (title_.empty()) title_ = one.mechanism.empty() ? one.run.model_file : one.mechanism;
  const std::optional<CasePage> page = has_room() ? fit_case(one, find_share(), n_blocks_) : std::nullopt;
  room_ -= std::min(room_, kLineSize);
  list_.add(one, page ? page->extent : "only this line");
  if (!page) return;
  room_ -= std::min(room_, page->size());
  ++n_shown_;
  n_blocks_ = page->blocks.end();
  articles_ += page->article;
  blocks_ += page->blocks.html();
  cases_.add_json(page->data.text());
  choices_ += fmt::format("<option value=\"{0}\">{0}{1}{2}</option>", escape_html(one.run.case_name),
                          one.case_description.empty() ? "" : ": ", escape_html(one.case_description));
}

void ReportPage::add_comparisons(const std::vector<CaseComparison>& comparisons) {
  std::size_t room = kComparisonSize;
  for (const Figure& figure : make_comparison_figures(comparisons)) {
    JsonText data;
    BlockStore blocks(n_blocks_);
    add_figure(data, blocks, figure, {kMostFullCycles, 0, true});
    const std::size_t size = data.text().size() + blocks.html().size();
    if (size > room) {
      left_out_ += fmt::format("{}“{}”", left_out_.empty() ? "" : ", ", figure.title);
      continue;
    }
    room -= size;
    comparisons_.add_json(data.text());
    blocks_ += blocks.html();
    n_blocks_ = blocks.end();
  }
}

std::string ReportPage::render_comparison() const {
  std::string html = list_.render();
  const std::size_t n_hidden = list_.size() - n_shown_;
  if (n_hidden > 0) {
    html += make_paragraph(fmt::format("The page holds {} of {} cases; the others are in this list only. A report made "
                                       "of a run file alone shows all of its case.",
                                       n_shown_, list_.size()),
                           "warning");
  }
  const bool has_figures = !comparisons_.text().ends_with('[');
  if (has_figures) html += make_figure_place("", "comparison");
  if (!left_out_.empty()) {
    html += make_paragraph("No room for " + left_out_ + "; gudgeon plot draws them.", "warning");
  }
  if (html.empty()) return {};
  return "<section id=\"comparison\" class=\"comparison\" data-brief=\"Cases\"><h2>Cases side by side</h2>\n" + html +
         "</section>\n";
}

void ReportPage::add_warning(const std::string& text) { warnings_ += make_paragraph(text, "warning"); }

std::string ReportPage::render() const {
  const std::string choice =
      n_shown_ < 2
          ? std::string{}
          : fmt::format("<label class=\"choice\">Case <select id=\"case-choice\">{}</select></label>", choices_);
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'unsafe-inline'; "
      "style-src 'unsafe-inline'; img-src data: blob:\">\n<link rel=\"icon\" href=\"data:,\">\n<title>{0} · "
      "gudgeon</title>\n"
      "<style>{1}</style>\n</head>\n<body>\n<header class=\"top\"><h1>{0}</h1>{2}"
      "<nav aria-label=\"Sections\" id=\"sections\"></nav>"
      "<button type=\"button\" id=\"theme\" aria-label=\"Dark or light\" title=\"Dark or light\">◐</button></header>\n"
      "<main>\n{3}<noscript><p class=\"warning\">The figures of this page need "
      "JavaScript.</p></noscript>\n{4}{5}</main>\n"
      "<footer><p>Made by gudgeon from run files alone. All numbers are stored in SI; data buttons give them "
      "so.</p></footer>\n"
      "<script type=\"application/json\" id=\"report-data\">{{\"cases\":{6}],\"comparisons\":{7}]}}</script>\n{8}"
      "<script>{9}</script>\n</body>\n</html>\n",
      escape_html(title_), page_style(), choice, warnings_, articles_, render_comparison(), cases_.text(),
      comparisons_.text(), blocks_, page_script());
}

}  // namespace gudgeon
