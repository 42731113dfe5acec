// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What was simulated, on which assumptions, beside which reference values, and how to do it again.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "gudgeon/analysis/energy_audit.h"
#include "gudgeon/base/diagnostics.h"
#include "gudgeon/report/figures/figure.h"
#include "gudgeon/report/html/case_sections.h"
#include "gudgeon/report/html/html_text.h"
#include "gudgeon/report/number_format.h"
#include "gudgeon/report/stage_section.h"

namespace gudgeon {

namespace {

std::string render_list(const std::vector<NamedText>& items) {
  if (items.empty()) return {};
  std::string html = "<dl class=\"facts\">\n";
  for (const auto& [name, text] : items) {
    html += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", escape_html(name), escape_html(text));
  }
  return html + "</dl>\n";
}

HtmlTable make_stated_table(std::string caption) {
  return {std::move(caption), {"value", "as written", "status", "remark"}, 4};
}

/// The value as the file has it, and what the run put in its place.
std::string print_stated(const ReportCase& one, const StatedValue& value) {
  std::string text = value.written;
  for (const auto* changes : {&one.case_settings, &one.run.overrides}) {
    const auto found = std::ranges::find(*changes, value.path, &NamedText::first);
    if (found != changes->end()) text += fmt::format(" (here: {})", found->second);
  }
  return text;
}

std::string render_stated_group(const ReportCase& one, const std::string& status, const std::string& caption,
                                bool open) {
  HtmlTable table = make_stated_table(caption);
  for (const StatedValue& value : one.stated) {
    if (value.status.substr(0, 1) == status)
      table.add_row({value.path, print_stated(one, value), value.status, value.remark});
  }
  if (table.empty()) return {};
  return fmt::format("<details{}><summary>{}</summary>\n{}</details>\n", open ? " open" : "", escape_html(caption),
                     table.render());
}

/// A word of a shell command: quoted where the shell would read something into it.
std::string quote_word(const std::string& word) {
  const bool is_plain = !word.empty() && std::ranges::all_of(word, [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string_view("_-./=,:+").find(static_cast<char>(c)) != std::string_view::npos;
  });
  if (is_plain) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string make_command(const RunRecord& run) {
  std::string command = "gudgeon run " + quote_word(run.model_file);
  if (!run.case_name.empty() && run.case_name != "base") command += " --case " + quote_word(run.case_name);
  for (const auto& [path, value] : run.overrides) command += " --set " + quote_word(path + "=" + value);
  return command;
}

}  // namespace

std::string render_simulated(const ReportCase& one) {
  std::string html;
  if (!one.description.empty()) html += make_paragraph(one.description, "lead");
  if (!one.case_description.empty()) {
    html += make_paragraph(fmt::format("Case {}: {}.", one.run.case_name, one.case_description));
  }
  html += render_list(one.study);
  std::vector<NamedText> changed = one.case_settings;
  for (const auto& [path, value] : one.run.overrides) changed.emplace_back(path, value);
  if (!changed.empty()) html += "<h3>Changed from the model file</h3>\n" + render_list(changed);
  return html;
}

std::string render_warnings(const ReportCase& one) {
  std::string html;
  if (!one.model_error.empty()) html += make_paragraph(one.model_error, "warning");
  for (const StageRecord& stage : one.run.stages) {
    if (is_unbalanced(stage)) {
      html +=
          make_paragraph(fmt::format("Stage “{}”: {}", label_stage(stage.name), explain_imbalance(stage)), "warning");
    }
    if (stage.status == StageStatus::finished) continue;
    html += make_paragraph(
        fmt::format("Stage “{}” {} at {} after {} counted cycles: what it recorded is shown.", label_stage(stage.name),
                    name_status(stage.status), format_engineering(stage.end_time, "s"), stage.cycles),
        "warning");
  }
  if (one.run.stages.empty()) html += make_paragraph("The run file holds no stage.", "warning");
  return html;
}

std::string render_reference_values(const ReportCase& one) {
  std::size_t n_values = 0;
  std::vector<ReferenceComparison> comparisons;
  for (const ReferenceRow& row : one.reference) {
    comparisons.push_back(compare_with_reference(one.run, row));
    n_values = std::max(n_values, comparisons.back().ours.size());
  }
  HtmlTable table("Ours beside the reference values", {"quantity", "stage", "reference", "ours", "ratio"}, 2);
  for (const ReferenceComparison& c : comparisons) {
    for (std::size_t k = 0; k < c.ours.size(); ++k) {
      if (std::isnan(c.reference.values[k])) continue;
      table.add_row({c.reference.quantity, label_stage(c.stages[k]),
                     format_engineering(c.reference.values[k], c.reference.unit),
                     format_engineering(c.ours[k], c.reference.unit),
                     std::isnan(c.ratio[k]) ? std::string(kNoNumber) : fmt::format("{:.2f}", c.ratio[k])});
    }
  }
  if (table.empty()) return {};
  const char* changed = one.run.overrides.empty() ? "" : " This run was changed by --set; reference values are not.";
  return table.render() +
         make_paragraph(
             fmt::format("Impacts between journal and bearing are chaotic: a peak agrees in magnitude, not in sign or "
                         "time. Ratios are of magnitudes, ours over reference.{}",
                         changed),
             "note");
}

std::string render_stated_values(const ReportCase& one) {
  if (one.stated.empty()) return {};
  std::string html;
  std::vector<StatusMeaning> statuses = one.statuses;
  // Printed values are the least to argue about: the rest comes first.
  std::stable_partition(statuses.begin(), statuses.end(), [](const StatusMeaning& s) { return s.status != "P"; });
  for (const StatusMeaning& status : statuses) {
    html += render_stated_group(one, status.status, fmt::format("{}: {}", status.status, status.meaning),
                                status.status == "A");
  }
  html += render_stated_group(one, "", one.statuses.empty() ? "Values with their remarks" : "Other remarks", false);
  return html;
}

std::string render_repetition(const ReportCase& one) {
  const RunRecord& run = one.run;
  return fmt::format(
      "<p>Written by gudgeon {}. The run file holds the model; the same model gives the same bits again.</p>\n"
      "<pre class=\"command\"><code>{}</code></pre>\n<details><summary>The model file, "
      "{}</summary><pre><code>{}</code></pre>"
      "</details>\n<details><summary>The model in SI with every "
      "default</summary><pre><code>{}</code></pre></details>\n",
      escape_html(run.program_version), escape_html(make_command(run)), escape_html(run.model_file),
      escape_html(run.model_text), escape_html(run.resolved_model));
}

}  // namespace gudgeon
