// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon draw: the mechanism in one position, as SVG.
#pragma once

#include <CLI/CLI.hpp>

#include "gudgeon/app/exit_code.h"

namespace gudgeon {

void add_draw_command(CLI::App& program, Action& action);

}  // namespace gudgeon
