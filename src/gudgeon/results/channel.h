// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A channel is one recorded signal: what it is, in which unit.
#pragma once

#include <string>

namespace gudgeon {

struct Channel {
  std::string name;         ///< "slider_9.x_acceleration", "A.normal_force", "crank_1.effort"
  std::string symbol;       ///< "ẍ"
  std::string unit;         ///< SI, "m/s^2"
  std::string description;  ///< one sentence
};

}  // namespace gudgeon
