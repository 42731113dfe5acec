// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Values of the drivers as they are in the assembled mechanism.
#include "gudgeon/system/held_mechanism.h"

#include "gudgeon/system/assembly.h"
#include "gudgeon/system/body_motion.h"
#include "gudgeon/system/slide_motion.h"

namespace gudgeon {

Mechanism hold_at_rest(const Mechanism& mechanism) {
  Mechanism held = make_ideal(mechanism);
  remove_friction(held);
  const std::vector<BodyPose> poses = assemble(held).poses;
  std::vector<BodyMotion> motions;
  for (std::size_t b = 0; b < poses.size(); ++b) {
    BodyMotion motion;
    motion.position = poses[b].find_point(held.bodies[b].center_of_mass);
    motion.angle = poses[b].angle;
    motions.push_back(motion);
  }
  for (Driver& driver : held.drivers) {
    if (const auto* angle = std::get_if<DrivenAngle>(&driver.target)) {
      driver.start = poses[find_body(held, angle->body)].angle - poses[find_body(held, angle->against)].angle;
    } else {
      const int joint = find_joint(held, std::get<DrivenSlide>(driver.target).joint);
      driver.start = find_slide_motion(held, held.joints[joint], motions).displacement;
    }
    driver.speed = 0.0;
    driver.motion = std::monostate{};
  }
  for (Body& body : held.bodies) body.start.angle_rate.reset(), body.start.velocity.reset();
  for (Joint& joint : held.joints) {
    if (auto* slide = std::get_if<Prismatic>(&joint.kind)) slide->start.speed.reset();
  }
  return held;
}

}  // namespace gudgeon
