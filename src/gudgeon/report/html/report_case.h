// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One case as the page is made of it.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gudgeon/analysis/reference_values.h"
#include "gudgeon/report/html/scene.h"
#include "gudgeon/results/function_samples.h"
#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// A value of the model file and what its author wrote beside it.
struct StatedValue {
  std::string path;     ///< "joints.A.radial_clearance"
  std::string written;  ///< "0.5 mm"
  std::string status;   ///< "P", "A"; empty when the remark has none
  std::string remark;   ///< the rest of the remark
};

/// What a status letter stands for, as the model file explains it.
struct StatusMeaning {
  std::string status;
  std::string meaning;
};

using NamedText = std::pair<std::string, std::string>;

struct ReportCase {
  RunRecord run;            ///< with the values of the channels that find_figure_channels and find_pose_channels name
  std::string mechanism;    ///< its name
  std::string description;  ///< of the mechanism
  std::string case_description;          ///< of the case
  std::vector<NamedText> study;          ///< what was done, "Cycles a stage" and "100"
  std::vector<NamedText> case_settings;  ///< values that the case replaces
  std::optional<Scene> scene;
  std::vector<FunctionSamples> functions;  ///< formulas and curves that loads and drivers were given
  std::vector<ReferenceRow> reference;
  std::vector<StatedValue> stated;
  std::vector<StatusMeaning> statuses;
  std::string model_error;  ///< why the model in the file could not be used; empty when it could
};

}  // namespace gudgeon
