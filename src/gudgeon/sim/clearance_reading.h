// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What is recorded of one clearance joint: all its contacts taken together.
#pragma once

#include <span>
#include <vector>

#include "gudgeon/sim/contact_events.h"
#include "gudgeon/system/body_motion.h"
#include "gudgeon/system/system.h"

namespace gudgeon {

/// Motion of the journal in its bearing and the forces between them. Along and across are a slot's axes, which turn
/// with the bearing's body; across is to the left.
struct ClearanceReading {
  Vec2 offset;                 ///< [m] journal's anchor minus bearing's, in the frame's axes
  Vec2 offset_rate;            ///< [m/s]
  double contact_angle = 0.0;  ///< [rad] of the line of centres in the bearing's body, in [-π, π]
  double displacement = 0.0;   ///< [m] along the slot
  double speed = 0.0;          ///< [m/s]
  double height = 0.0;         ///< [m] across the slot
  double height_rate = 0.0;    ///< [m/s]
  double tilt = 0.0;           ///< [rad] of a block against its slot, in [-π, π]
  double tilt_rate = 0.0;      ///< [rad/s]

  int n_contacts = 0;           ///< that touch
  double penetration = 0.0;     ///< [m] of the deepest contact
  double normal_force = 0.0;    ///< [N] sum
  double left_force = 0.0;      ///< [N] sum of normal forces on the slot's left side
  double right_force = 0.0;     ///< [N]
  double friction_force = 0.0;  ///< [N] of the slip speed's sign; in a slot the sum along it
  double slip_speed = 0.0;      ///< [m/s] in contact; in a slot along it, of the contact that presses most
  double bristle = 0.0;         ///< [m] of the same contact, where its friction law has one
};

class ClearanceReader {
 public:
  ClearanceReader(const System& system, std::size_t group);

  /// The motion; needs the points' and the bodies' motions of the state.
  void read_motion(const Workspace& workspace, const std::vector<BodyMotion>& motions, ClearanceReading& reading) const;
  /// The forces of the last evaluation, and the deepest of the contacts' gaps.
  void read_forces(const Workspace& workspace, std::span<const double> penetrations, ClearanceReading& reading) const;

 private:
  struct Arm {
    int body;
    Vec2 local;  // from the centre of mass
  };
  void read_slot(const std::vector<BodyMotion>& motions, ClearanceReading& reading) const;

  const Tables* tables_;
  ContactGroup group_;
  Arm bearing_;
  Arm journal_;
  bool is_slot_ = false;
  double direction_ = 0.0;       // [rad] of the slot
  double relative_angle_ = 0.0;  // [rad] of a block that lies along it
};

}  // namespace gudgeon
