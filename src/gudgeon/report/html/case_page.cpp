// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Sections with their figures, and their data, tried with less and less detail.
#include "gudgeon/report/html/case_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "gudgeon/report/figures/case_figures.h"
#include "gudgeon/report/figures/function_figures.h"
#include "gudgeon/report/html/case_sections.h"
#include "gudgeon/report/html/figure_data.h"
#include "gudgeon/report/html/html_text.h"

namespace gudgeon {

namespace {

/// A section's title and what the links at the page's top call it, which have to find room in a line.
struct SectionTitle {
  std::string_view whole;
  std::string_view brief;
};

std::string make_section(std::string_view case_name, std::string_view id, const SectionTitle& title,
                         const std::string& content) {
  if (content.empty()) return {};
  return fmt::format("<section id=\"{0}-{1}\" class=\"{1}\" data-brief=\"{2}\"><h2>{3}</h2>\n{4}</section>\n",
                     escape_html(case_name), id, title.brief, title.whole, content);
}

bool is_recorded_signal(const Figure& figure) {
  return std::ranges::any_of(figure.curves, [](const FigureCurve& curve) { return curve.cycle_samples > 0; });
}

/// What of the samples is not on the page; nothing when all of them are.
std::string render_reduction(const RunRecord& run, const SignalDetail& detail, bool has_figures) {
  if (!detail.has_samples) {
    return make_paragraph(
        fmt::format("All cases together are more than one page holds. Of this one, {} are here; made of its run file "
                    "alone, a report shows all of it.",
                    has_figures ? "tables and worn surfaces" : "tables"),
        "warning");
  }
  const bool is_whole = std::ranges::all_of(run.stages, [&](const StageRecord& stage) {
    const std::size_t cycle_samples = find_cycle_samples(stage);
    return cycle_samples == 0 || find_full_count(detail.full_cycles, cycle_samples) >= stage.time.size();
  });
  if (is_whole) return {};
  return make_paragraph(
      fmt::format("Of every stage the last {:.3g} cycles are here sample by sample. Of those before, each of {} spans "
                  "shows its least and greatest value, so that no recorded peak is lost. The run file has all samples.",
                  detail.full_cycles, detail.n_spans),
      "note");
}

std::string render_article(const ReportCase& one, const std::vector<Figure>& figures, const SignalDetail& detail) {
  const RunRecord& run = one.run;
  const std::string& name = run.case_name;
  const auto place = [&](std::string_view topic) {
    const bool has_topic = std::ranges::any_of(figures, [&](const Figure& figure) { return figure.topic == topic; });
    return has_topic ? make_figure_place(name, topic) : std::string{};
  };
  std::string html =
      fmt::format("<article class=\"case\" data-case=\"{0}\" aria-label=\"Case {0}\">\n", escape_html(name));
  html += render_warnings(one);
  if (one.scene && !run.stages.empty() && detail.has_samples) {
    html += make_section(name, "moving", {"The mechanism, moving", "Moving"},
                         fmt::format("<div class=\"mechanism\" data-case=\"{}\"></div>\n", escape_html(name)));
  }
  html += make_section(name, "simulated", {"What was simulated", "Simulated"},
                       render_simulated(one) + render_reduction(run, detail, !figures.empty()));
  html +=
      make_section(name, "reference", {"Comparison with reference values", "Reference"}, render_reference_values(one));
  html += make_section(name, "wear", {"Wear", "Wear"}, render_wear_table(run) + place("wear"));
  html += make_section(name, "motion", {"Motion", "Motion"}, render_ideal_table(run) + place("motion"));
  html += make_section(name, "forces", {"Drivers and contact forces", "Forces"},
                       render_peak_table(run) + place("drive") + place("contact"));
  html += make_section(name, "journals", {"Journals in their bearings", "Journals"},
                       render_contact_table(run) + place("journal"));
  html += make_section(name, "given", {"Loads and motions as they were given", "Given"}, place("given"));
  html += make_section(name, "energy", {"Energy", "Energy"}, render_energy_table(run));
  html += make_section(name, "solver", {"Solver", "Solver"}, render_solver_table(run));
  html += make_section(name, "stated", {"Values and where they come from", "Values"}, render_stated_values(one));
  html += make_section(name, "repeat", {"How to repeat it", "Repeat"}, render_repetition(one));
  return html + "</article>\n";
}

std::string name_extent(const SignalDetail& detail, bool has_figures) {
  if (detail.has_samples) return "all figures";
  return has_figures ? "tables and worn surfaces" : "tables";
}

CasePage render_case(const ReportCase& one, Signals& signals, const std::vector<Figure>& figures,
                     const SignalDetail& detail, int first_block) {
  CasePage page{
      render_article(one, figures, detail), {}, BlockStore(first_block), name_extent(detail, !figures.empty())};
  JsonText& data = page.data;
  data.begin_object();
  data.put("name", one.run.case_name);
  data.put("full_cycles", detail.full_cycles);
  if (one.scene && detail.has_samples) {
    data.key("scene");
    add_scene(data, *one.scene, one.run);
    data.key("motions");
    add_motions(data, page.blocks, *one.scene, signals, detail.full_cycles);
  }
  data.key("figures");
  data.begin_array();
  for (const Figure& figure : figures) add_figure(data, page.blocks, figure, detail);
  data.end_array();
  data.end_object();
  return page;
}

}  // namespace

std::string make_figure_place(std::string_view case_name, std::string_view topic) {
  return fmt::format("<div class=\"figures\" data-case=\"{}\" data-topic=\"{}\"></div>\n", escape_html(case_name),
                     topic);
}

std::optional<CasePage> fit_case(const ReportCase& one, std::size_t bytes, int first_block) {
  Signals signals(one.run);
  std::vector<Figure> figures = make_case_figures(signals);
  std::ranges::move(make_function_figures(one.functions), std::back_inserter(figures));
  // Texts and what is no signal come first: signals get what those leave.
  const std::size_t fixed = render_article(one, figures, {}).size() + find_fixed_size(figures);
  std::size_t room = bytes > fixed ? bytes - fixed : 0;
  constexpr int kTries = 3;  // what the estimate missed is taken off; once is nearly always enough
  for (int k = 0; k < kTries; ++k) {
    CasePage page = render_case(one, signals, figures, find_signal_detail(one.run, room), first_block);
    if (page.size() <= bytes) return page;
    room -= std::min(room, page.size() - bytes);
  }
  std::erase_if(figures, is_recorded_signal);
  for (const bool has_figures : {true, false}) {
    if (!has_figures) figures.clear();
    CasePage page = render_case(one, signals, figures, {0.0, 0, false}, first_block);
    if (page.size() <= bytes) return page;
  }
  return std::nullopt;
}

}  // namespace gudgeon
