// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What a case's page says in words and tables, section by section; a section with nothing to say is empty.
#pragma once

#include <string>
#include <string_view>

#include "gudgeon/report/html/report_case.h"

namespace gudgeon {

/// Where the script puts the figures of a topic.
std::string make_figure_place(std::string_view case_name, std::string_view topic);

std::string render_simulated(const ReportCase& one);
std::string render_warnings(const ReportCase& one);
std::string render_reference_values(const ReportCase& one);
std::string render_peak_table(const RunRecord& run);
std::string render_ideal_table(const RunRecord& run);
std::string render_wear_table(const RunRecord& run);
std::string render_contact_table(const RunRecord& run);
std::string render_energy_table(const RunRecord& run);
std::string render_solver_table(const RunRecord& run);
std::string render_stated_values(const ReportCase& one);
std::string render_repetition(const ReportCase& one);

}  // namespace gudgeon
