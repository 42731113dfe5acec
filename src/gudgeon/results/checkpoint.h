// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A stage under way, as it was between two steps.
#pragma once

#include <cstdint>
#include <string>

namespace gudgeon {

/// What a stage goes on from with the same bits, when it is run by the same program with the same model and study, on
/// the surfaces that the same stages before it left. The samples that it handed over before are not in it.
struct Checkpoint {
  std::string stage;
  double time = 0.0;  ///< [s] reached
  std::int64_t n_samples_handed_over = 0;
  std::string state;  ///< sealed bytes (base/state_archive.h)
};

}  // namespace gudgeon
