// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon equilibrium: where the mechanism stays at rest, and how it swings about there.
#pragma once

#include <CLI/CLI.hpp>

#include "gudgeon/app/exit_code.h"

namespace gudgeon {

void add_equilibrium_command(CLI::App& program, Action& action);

}  // namespace gudgeon
