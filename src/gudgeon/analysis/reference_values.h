// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Our values beside reference values.
#pragma once

#include <string>
#include <vector>

#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// One reference quantity with a value a stage.
struct ReferenceRow {
  std::string quantity;        ///< in words
  std::string channel;         ///< channel; for "wear_depth" the joint
  std::string measure;         ///< "peak" in a stage, or "wear_depth": the largest depth of the surfaces it ran on
  std::vector<double> values;  ///< in SI, k of the stage after k wear updates ("no_wear", "wear_1" …); NaN for nothing
  std::string unit;            ///< SI; empty takes the channel's, or m for a depth
};

/// A reference row and ours, value by value.
struct ReferenceComparison {
  ReferenceRow reference;           ///< with its unit filled in
  std::vector<double> ours;         ///< NaN where our run has no such value
  std::vector<double> ratio;        ///< |ours| / |reference|, as peaks compare in magnitude; NaN where either lacks
  std::vector<std::string> stages;  ///< the stage each value was taken from, "no_wear", "wear_1" …
};

/// NumericalError for an unknown measure.
ReferenceComparison compare_with_reference(const RunRecord& run, const ReferenceRow& row);

/// "no_wear" for 0 wear updates, "wear_1" for one …
std::string name_worn_stage(std::size_t n_updates);

}  // namespace gudgeon
