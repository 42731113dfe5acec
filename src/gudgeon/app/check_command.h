// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon check: is the model sound, and what is it made of?
#pragma once

#include <CLI/CLI.hpp>

#include "gudgeon/app/exit_code.h"

namespace gudgeon {

void add_check_command(CLI::App& program, Action& action);

}  // namespace gudgeon
