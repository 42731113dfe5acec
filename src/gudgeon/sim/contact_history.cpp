// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Peak and separation.
#include "gudgeon/sim/contact_history.h"

#include <algorithm>

namespace gudgeon {

void ContactHistory::watch(std::size_t contact, double normal_force) {
  open_[contact].peak_force = std::max(open_[contact].peak_force, normal_force);
}

void ContactHistory::end(std::size_t contact, double time) {
  ContactEvent& event = open_[contact];
  event.duration = time - event.onset_time;
  if (event.onset_time >= first_counted_) events_.push_back(event);
}

}  // namespace gudgeon
