// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon info: what is in a run file.
#pragma once

#include <CLI/CLI.hpp>

#include "gudgeon/app/exit_code.h"

namespace gudgeon {

void add_info_command(CLI::App& program, Action& action);

}  // namespace gudgeon
