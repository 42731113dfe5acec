// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon diagnostics: what the codes of messages mean.
#pragma once

#include <CLI/CLI.hpp>

#include "gudgeon/app/exit_code.h"

namespace gudgeon {

void add_diagnostics_command(CLI::App& program, Action& action);

}  // namespace gudgeon
