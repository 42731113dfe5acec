// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Every friction law. A new law is one more alternative here.
#pragma once

#include <variant>

#include "gudgeon/laws/friction/coulomb_smooth.h"
#include "gudgeon/laws/friction/frictionless.h"
#include "gudgeon/laws/friction/lugre_steady.h"

namespace gudgeon {

using AnyFriction = std::variant<Frictionless, CoulombSmooth, LugreSteady>;

}  // namespace gudgeon
