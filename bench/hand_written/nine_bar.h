// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The nine-bar press written out by hand: five absolute angles, one closure, constants folded, no loops. Nothing more
// general can be faster than this on the same floating-point operations; it is the floor that the engine is held to.
#pragma once

#include "gudgeon/system/contact_force.h"

namespace gudgeon::hand_written {

/// y = [θ6 θ7 θ2 θ3 θ8 | their rates]; the slider follows rod 8 and cranks 1 and 4 are driven. Contacts A and B with
/// Lankarani-Nikravesh and lugre_steady. The data are those of oracle::make_nine_bar().
class NineBar {
 public:
  static constexpr int kCoordinates = 5;
  static constexpr const char* kBodies[kCoordinates] = {"rod_6", "panel_7", "rod_2", "rod_3", "rod_8"};

  void eval(double t, const double* y, double* slope) const noexcept;

  ContactMode a;
  ContactMode b;
};

}  // namespace gudgeon::hand_written
