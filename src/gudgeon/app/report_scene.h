// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A model as the report tells and animates it.
#pragma once

#include <string>
#include <vector>

#include "gudgeon/io/model_reader.h"
#include "gudgeon/report/html/report_case.h"

namespace gudgeon {

Scene make_scene(const Mechanism& mechanism);

/// What was simulated, in the words of a paper.
std::vector<NamedText> describe_study(const Mechanism& mechanism, const Study& study);

/// The file's remarks, split into status and the rest where the file explains its letters.
void read_stated_values(std::string_view model_text, ReportCase& one);

}  // namespace gudgeon
