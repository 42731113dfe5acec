// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Some samples of a stage under way, on their way out of memory.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "gudgeon/results/channel.h"

namespace gudgeon {

/// Samples that follow those of the block before; a view that lives as long as the call it is handed to.
struct SampleBlock {
  std::string_view stage;
  std::span<const Channel> channels;
  std::span<const double> time;                 ///< [s] of each sample
  std::span<const std::vector<double>> values;  ///< values[channel][sample]
};

}  // namespace gudgeon
