// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Every damping form. A new form is one more alternative here; the point law of its name comes with it.
#pragma once

#include <variant>

#include "gudgeon/laws/damping/carvalho_martins.h"
#include "gudgeon/laws/damping/exact_restitution.h"
#include "gudgeon/laws/damping/flores.h"
#include "gudgeon/laws/damping/gonthier.h"
#include "gudgeon/laws/damping/herbert_mcwhannell.h"
#include "gudgeon/laws/damping/hu_guo.h"
#include "gudgeon/laws/damping/hunt_crossley.h"
#include "gudgeon/laws/damping/lankarani_nikravesh.h"
#include "gudgeon/laws/damping/lee_wang.h"
#include "gudgeon/laws/damping/no_damping.h"
#include "gudgeon/laws/damping/zhiying_qishao.h"

namespace gudgeon {

using AnyDamping = std::variant<LankaraniNikraveshDamping, NoDamping, HuntCrossleyDamping, HerbertMcwhannellDamping,
                                LeeWangDamping, GonthierDamping, ZhiyingQishaoDamping, FloresDamping, HuGuoDamping,
                                CarvalhoMartinsDamping, ExactRestitutionDamping>;

/// χ of whichever form it is.
inline double find_damping_factor(const AnyDamping& any) {
  return std::visit([](const auto& damping) { return damping.damping_factor(); }, any);
}

}  // namespace gudgeon
