// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Functions in a model file: "10 N", "-k * piston.x", { over = "t", arguments = […], values = […] }.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "gudgeon/io/table_reader.h"
#include "gudgeon/model/function.h"

namespace gudgeon {

/// The constants = { name = "quantity" } of a table, in SI; none when it has none.
std::vector<std::pair<std::string, double>> read_constants(TableReader& owner);

/// A function's node: a quantity of that dimension is a constant, any other text a formula with the constants given,
/// and a table a curve. argument_unit and value_unit of a curve scale its numbers.
Function read_function(const DocumentNode& node, const std::string& path, Dimension dimension,
                       const std::vector<std::pair<std::string, double>>& constants, TableReader& owner);

}  // namespace gudgeon
