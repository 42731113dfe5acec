// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Where joints and loads take hold of a body.
#pragma once

#include <string>

namespace gudgeon {

/// A point of a body, written "crank_1.A" in the model file.
struct Anchor {
  std::string body;
  std::string point;
};

}  // namespace gudgeon
