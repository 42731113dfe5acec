// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Ranges as intervals, for tables of parameters.
#pragma once

#include <string>

#include "gudgeon/base/parameter_table.h"

namespace gudgeon {

/// "[0, 1)"; '(' and ')' leave their end out.
std::string interval_text(const ParameterRange& range);

}  // namespace gudgeon
