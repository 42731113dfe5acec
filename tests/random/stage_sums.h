// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Sums over a stage that are known some other way.
#pragma once

#include "gudgeon/results/run_record.h"
#include "tests/random/random_mechanism.h"

namespace gudgeon::random {

/// Expects the works of loads that are curves over the places that they push along to be the curves' integrals.
void expect_works_of_curves(const RandomModel& model, const StageRecord& stage);

/// Expects surfaces to lose what is worn off, and that to be in proportion to the friction that the energy balance has.
void expect_volumes(const RandomModel& model, const StageRecord& stage);

}  // namespace gudgeon::random
