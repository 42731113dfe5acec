// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The rules that a mechanism and its study must keep, whoever made them.
#pragma once

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/model/cycle_time.h"
#include "gudgeon/model/mechanism.h"
#include "gudgeon/model/study.h"

namespace gudgeon {

/// Everything that is wrong, and remarks on what is unwise. With the source of the model, messages show values as they
/// were written there too. Of a model that was read with errors, a value that is not a number is one that could not be
/// read: it has been reported and breaks no further rule. The codes are listed in docs/guide/diagnostics.md.
Diagnostics check(const Mechanism& mechanism, const Study& study, const SourceMap* source = nullptr,
                  bool read_with_errors = false);

}  // namespace gudgeon
