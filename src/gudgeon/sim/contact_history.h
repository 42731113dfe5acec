// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The contacts of a stage, one after the other.
#pragma once

#include <vector>

#include "gudgeon/base/state_archive.h"
#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// Follows each contact from onset to separation; those that begin before `first_counted` [s] are left out.
class ContactHistory {
 public:
  ContactHistory(std::size_t n_contacts, double first_counted) : open_(n_contacts), first_counted_(first_counted) {}

  /// The opening event tells joint, onset and place.
  void begin(std::size_t contact, const ContactEvent& opening) { open_[contact] = opening; }
  void watch(std::size_t contact, double normal_force);
  void end(std::size_t contact, double time);

  /// All contacts in the order of their end.
  [[nodiscard]] std::vector<ContactEvent>& events() { return events_; }

  void transfer(StateArchive& archive) {
    archive(open_);
    archive.list(events_);
  }

 private:
  std::vector<ContactEvent> open_;  // one a contact
  std::vector<ContactEvent> events_;
  double first_counted_;
};

}  // namespace gudgeon
