// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon kinematics: the motion that drivers prescribe, the efforts it takes, and the branches of the loops.
#pragma once

#include <CLI/CLI.hpp>

#include "gudgeon/app/exit_code.h"

namespace gudgeon {

void add_kinematics_command(CLI::App& program, Action& action);

}  // namespace gudgeon
