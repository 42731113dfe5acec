// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The JSON schema of a model file, which editors with a TOML language server complete and check by.
#pragma once

#include <string>

namespace gudgeon {

/// Draft 7, indented. It knows keys, kinds of values and ranges of bare numbers; units, names and all other rules are
/// left to `gudgeon check`.
std::string render_model_schema();

}  // namespace gudgeon
