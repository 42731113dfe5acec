// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What a formula or curve of a model looks like.
#pragma once

#include <string>
#include <vector>

namespace gudgeon {

/// A formula or curve as the user gave it, over one of what it depends on.
struct FunctionSamples {
  std::string id;           ///< "loads.cut.force.0"; a motion's acceleration "drivers.motor.motion.acceleration"
  std::string subject;      ///< "load 'cut'"
  std::string what;         ///< "force in x", "acceleration"
  std::string unit;         ///< of the values, SI
  std::string over;         ///< "t", "guide.displacement"
  std::string over_unit;    ///< SI
  bool is_formula = false;  ///< otherwise a curve
  std::string others;       ///< where what else it depends on is held: "at the start"; empty without any
  std::vector<double> arguments;
  std::vector<double> values;           ///< one an argument; not finite where the formula has none
  std::vector<double> point_arguments;  ///< of a curve: what it was given by
  std::vector<double> point_values;
};

}  // namespace gudgeon
