// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Drivers and loads as sections of a model file.
#pragma once

#include "gudgeon/io/toml_lines.h"
#include "gudgeon/model/driver.h"
#include "gudgeon/model/load.h"

namespace gudgeon {

/// [drivers.NAME] in SI.
void write_driver(const Driver& driver, TomlLines& out);
/// [loads.NAME] in SI.
void write_load(const Load& load, TomlLines& out);

}  // namespace gudgeon
