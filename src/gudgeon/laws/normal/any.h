// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Every normal contact force law. A new law is one more alternative here.
#pragma once

#include <variant>

#include "gudgeon/laws/normal/hertz.h"
#include "gudgeon/laws/normal/lankarani_nikravesh.h"

namespace gudgeon {

using AnyNormalForce = std::variant<LankaraniNikravesh, Hertz>;

}  // namespace gudgeon
