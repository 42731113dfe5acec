// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A call that must report model errors, and what it reported.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "gudgeon/base/diagnostics.h"

namespace gudgeon {

/// The diagnostics of the ModelError that `call` throws; a failure and nothing when it does not throw.
template <class Call>
std::vector<Diagnostic> catch_diagnostics(Call&& call) {
  try {
    call();
  } catch (const ModelError& error) {
    const auto items = error.diagnostics().items();
    return {items.begin(), items.end()};
  }
  ADD_FAILURE() << "no ModelError";
  return {};
}

}  // namespace gudgeon
