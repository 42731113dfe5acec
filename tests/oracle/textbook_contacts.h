// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Contacts of unworn surfaces in maximal coordinates: from the poses of the bodies alone.
#pragma once

#include <vector>

#include "tests/oracle/textbook.h"

namespace gudgeon::oracle {

/// One of a bearing; of a block four, of a pin in a slot two; none of an ideal joint. Those of a slot's left side come
/// first, seen along its direction; of a block's the rear corner before the front one.
int n_contacts(const AnyJoint& joint);

/// All contacts of the textbook's mechanism, joint after joint.
std::vector<TextbookContactForce> find_contacts(const Textbook& textbook, const TextbookState& state);

}  // namespace gudgeon::oracle
