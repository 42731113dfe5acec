// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Every friction law. A new law is one more alternative here.
#pragma once

#include <variant>

#include "gudgeon/laws/friction/bengisu_akay.h"
#include "gudgeon/laws/friction/brown_mcphee.h"
#include "gudgeon/laws/friction/coulomb_ramp.h"
#include "gudgeon/laws/friction/coulomb_smooth.h"
#include "gudgeon/laws/friction/dahl.h"
#include "gudgeon/laws/friction/frictionless.h"
#include "gudgeon/laws/friction/lugre.h"
#include "gudgeon/laws/friction/lugre_steady.h"
#include "gudgeon/laws/friction/stribeck_smooth.h"
#include "gudgeon/laws/friction/threlfall.h"

namespace gudgeon {

using AnyFriction = std::variant<Frictionless, CoulombSmooth, CoulombRamp, Threlfall, BengisuAkay, StribeckSmooth,
                                 BrownMcPhee, LugreSteady, Dahl, Lugre>;

}  // namespace gudgeon
