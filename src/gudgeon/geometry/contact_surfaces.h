// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The pairs of surfaces that can touch, and their gap.
#pragma once

#include <variant>

#include "gudgeon/geometry/guide_gap.h"
#include "gudgeon/geometry/revolute_gap.h"

namespace gudgeon {

using ContactSurfaces = std::variant<RevoluteSurfaces, GuideSurfaces>;

/// Writes all of the gap.
inline void update_gap(const ContactSurfaces& surfaces, const RelativeMotion& motion, ContactGap& gap) noexcept {
  if (const auto* revolute = std::get_if<RevoluteSurfaces>(&surfaces)) {
    update_revolute_gap(*revolute, motion, gap);
  } else {
    gap = find_guide_gap(*std::get_if<GuideSurfaces>(&surfaces), motion);
  }
}

inline ContactGap find_gap(const ContactSurfaces& surfaces, const RelativeMotion& motion) noexcept {
  ContactGap gap;
  update_gap(surfaces, motion, gap);
  return gap;
}

inline bool is_worn(const ContactSurfaces& surfaces) {
  return std::visit([](const auto& kind) { return kind.is_worn(); }, surfaces);
}

}  // namespace gudgeon
