// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A model file of one bar on the frame, to which more may be added.
#pragma once

#include <string>
#include <string_view>

namespace gudgeon::test {

inline std::string make_pendulum_model(std::string_view more) {
  std::string text = R"(name = "pendulum"
[bodies.frame]
points = { O = [0, 0] }
[bodies.bar]
mass = "1 kg"
inertia = "1 kg m^2"
points = { O = [0, 0], tip = ["1 m", 0] }
[joints.O]
type = "revolute"
between = ["frame.O", "bar.O"]
)";
  return text += more;
}

}  // namespace gudgeon::test
