// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Sections in the order of a paper's results, then data, then script.
#include "gudgeon/report/html/page.h"

#include <fmt/format.h>

#include "gudgeon/report/figures/case_figures.h"
#include "gudgeon/report/html/case_sections.h"
#include "gudgeon/report/html/figure_data.h"
#include "gudgeon/report/html/full_cycles.h"
#include "gudgeon/report/html/html_text.h"
#include "gudgeon/report/html/page_assets.h"

namespace gudgeon {

namespace {

/// Where the script puts the figures of a topic.
std::string make_figure_place(std::string_view case_name, std::string_view topic) {
  return fmt::format("<div class=\"figures\" data-case=\"{}\" data-topic=\"{}\"></div>\n", escape_html(case_name),
                     topic);
}

std::string make_section(std::string_view case_name, std::string_view id, std::string_view title,
                         const std::string& content) {
  if (content.empty()) return {};
  return fmt::format("<section id=\"{0}-{1}\" class=\"{1}\"><h2>{2}</h2>\n{3}</section>\n", escape_html(case_name), id,
                     title, content);
}

bool has_topic(const std::vector<Figure>& figures, std::string_view topic) {
  return std::ranges::any_of(figures, [&](const Figure& figure) { return figure.topic == topic; });
}

std::string render_article(const ReportCase& one, const std::vector<Figure>& figures) {
  const RunRecord& run = one.run;
  const std::string& name = run.case_name;
  const auto place = [&](std::string_view topic) {
    return has_topic(figures, topic) ? make_figure_place(name, topic) : std::string{};
  };
  std::string html =
      fmt::format("<article class=\"case\" data-case=\"{0}\" aria-label=\"Case {0}\">\n", escape_html(name));
  if (one.scene && !run.stages.empty()) {
    html += make_section(name, "moving", "The mechanism, moving",
                         fmt::format("<div class=\"mechanism\" data-case=\"{}\"></div>\n", escape_html(name)));
  }
  html += make_section(name, "simulated", "What was simulated", render_simulated(one));
  html += make_section(name, "published", "Beside the published values", render_published_values(one));
  html += make_section(name, "wear", "Wear", render_wear_table(run) + place("wear"));
  html += make_section(name, "motion", "Motion", render_ideal_table(run) + place("motion"));
  html += make_section(name, "forces", "Drivers and contact forces",
                       render_peak_table(run) + place("drive") + place("contact"));
  html += make_section(name, "journals", "Journals in their bearings", render_contact_table(run) + place("journal"));
  html += make_section(name, "energy", "Energy", render_energy_table(run));
  html += make_section(name, "solver", "Solver", render_solver_table(run));
  html += make_section(name, "stated", "Values and where they come from", render_stated_values(one));
  html += make_section(name, "repeat", "How to repeat it", render_repetition(one));
  return html + "</article>\n";
}

}  // namespace

ReportPage::ReportPage(std::size_t n_cases) : n_cases_(n_cases) {
  cases_.begin_array();
  figures_.begin_array();
}

void ReportPage::add_case(const ReportCase& one) {
  if (title_.empty()) title_ = one.mechanism.empty() ? one.run.model_file : one.mechanism;
  Signals signals(one.run);
  const double full_cycles = find_full_cycles(one.run, kPageNumbers / n_cases_);
  const std::vector<Figure> figures = make_case_figures(signals);
  articles_ += render_article(one, figures);
  choices_ += fmt::format("<option value=\"{0}\">{0}{1}{2}</option>", escape_html(one.run.case_name),
                          one.case_description.empty() ? "" : ": ", escape_html(one.case_description));
  cases_.begin_object();
  cases_.put("name", one.run.case_name);
  cases_.put("full_cycles", full_cycles);
  if (one.scene) {
    cases_.key("scene");
    add_scene(cases_, *one.scene, one.run);
    cases_.key("motions");
    add_motions(cases_, blocks_, *one.scene, signals, full_cycles);
  }
  cases_.key("figures");
  cases_.begin_array();
  for (const Figure& figure : figures) add_figure(cases_, blocks_, figure, full_cycles);
  cases_.end_array();
  cases_.end_object();
  blocks_.forget();
}

void ReportPage::add_comparisons(const std::vector<CaseComparison>& comparisons) {
  const std::vector<Figure> figures = make_comparison_figures(comparisons);
  if (figures.empty()) return;
  comparisons_ = "<section id=\"comparison\" class=\"comparison\"><h2>Cases side by side</h2>\n" +
                 make_figure_place("", "comparison") + "</section>\n";
  for (const Figure& figure : figures) add_figure(figures_, blocks_, figure, kMostFullCycles);
  blocks_.forget();
}

void ReportPage::add_warning(const std::string& text) { warnings_ += make_paragraph(text, "warning"); }

std::string ReportPage::render() const {
  const std::string choice =
      n_cases_ < 2
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
      escape_html(title_), page_style(), choice, warnings_, articles_, comparisons_, cases_.text(), figures_.text(),
      blocks_.html(), page_script());
}

}  // namespace gudgeon
