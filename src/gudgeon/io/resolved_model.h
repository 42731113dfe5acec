// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The whole model written out, so that nothing that was assumed stays hidden.
#pragma once

#include <string>

#include "gudgeon/model/mechanism.h"
#include "gudgeon/model/study.h"

namespace gudgeon {

/// The model as a model file in SI units with every default written out. read_model_text() makes the same mechanism
/// and study of it, bit by bit.
std::string write_resolved_model(const Mechanism& mechanism, const Study& study);

}  // namespace gudgeon
