// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Every normal contact force law: the point law of every damping form, and those below. A new damping form is one more
// alternative of AnyDamping, another law one more alternative here.
#pragma once

#include <variant>

#include "gudgeon/laws/damping/any.h"
#include "gudgeon/laws/normal/anagnostopoulos.h"
#include "gudgeon/laws/normal/bai_zhao.h"
#include "gudgeon/laws/normal/damped_hertz.h"
#include "gudgeon/laws/normal/dubowsky_freudenstein.h"
#include "gudgeon/laws/normal/esdu_78035.h"
#include "gudgeon/laws/normal/goldsmith.h"
#include "gudgeon/laws/normal/hertz.h"
#include "gudgeon/laws/normal/johnson.h"
#include "gudgeon/laws/normal/kelvin_voigt.h"
#include "gudgeon/laws/normal/liu.h"
#include "gudgeon/laws/normal/pereira.h"
#include "gudgeon/laws/normal/persson.h"
#include "gudgeon/laws/normal/radzimovsky.h"

namespace gudgeon {

using LankaraniNikravesh = DampedHertz<LankaraniNikraveshDamping>;

/// The point law of a damping form; without damping it is Hertz.
template <class Damping>
struct PointLaw {
  using Type = DampedHertz<Damping>;
};
template <>
struct PointLaw<NoDamping> {
  using Type = Hertz;
};

/// A variant of the point laws of all damping forms, then of the other laws.
template <class AnyForm, class... Others>
struct WithPointLaws;
template <class... Dampings, class... Others>
struct WithPointLaws<std::variant<Dampings...>, Others...> {
  static_assert((NormalForceLaw<typename PointLaw<Dampings>::Type> && ...));
  using Type = std::variant<typename PointLaw<Dampings>::Type..., Others...>;
};

using AnyNormalForce = WithPointLaws<AnyDamping, KelvinVoigt, Anagnostopoulos, BaiZhao, Johnson, Radzimovsky, Goldsmith,
                                     DubowskyFreudenstein, Esdu78035, Liu, Persson, Pereira>::Type;

}  // namespace gudgeon
