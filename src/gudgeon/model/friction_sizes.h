// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The sizes that friction of an ideal joint has beside its law, one table a type of joint.
#pragma once

#include <array>
#include <span>

#include "gudgeon/base/parameter_table.h"
#include "gudgeon/model/joint.h"

namespace gudgeon {

using FrictionSize = Parameter<JointFriction>;

inline constexpr std::array<FrictionSize, 1> kPinFrictionSizes{
    {{"pin_radius", "r", dimension::kLength, kPositive, "radius of the pin", &JointFriction::pin_radius}}};
inline constexpr std::array<FrictionSize, 1> kSlotFrictionSizes{{
    {"pin_radius", "r", dimension::kLength, kNotNegative, "radius of the pin", &JointFriction::pin_radius},
}};
inline constexpr std::array<FrictionSize, 2> kGuideFrictionSizes{{
    {"guide_length", "L", dimension::kLength, kNotNegative, "length over which block and guide touch",
     &JointFriction::guide_length},
    {"guide_height", "h", dimension::kLength, kNotNegative, "height of the block across its guide",
     &JointFriction::guide_height},
}};

/// The sizes of an ideal joint's friction; none for a joint that cannot have friction. What must be above zero has to
/// be given.
constexpr std::span<const FrictionSize> list_friction_sizes(const Revolute&) { return kPinFrictionSizes; }
constexpr std::span<const FrictionSize> list_friction_sizes(const PinInSlot&) { return kSlotFrictionSizes; }
constexpr std::span<const FrictionSize> list_friction_sizes(const Prismatic&) { return kGuideFrictionSizes; }

}  // namespace gudgeon
