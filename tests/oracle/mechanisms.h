// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Mechanisms for tests, as plain descriptions that assemble from their start guesses. Values are uneven on purpose
// (offset centres of mass, oblique gravity, pivots off the origin), so that a wrong sign or a swapped axis shows.
// Driven bodies carry no start angle; start rates are given for the free coordinates only.
#pragma once

#include <vector>

#include "gudgeon/model/mechanism.h"

namespace gudgeon::oracle {

/// n bars hanging one on the other, n degrees of freedom.
Mechanism make_pendulum_chain(int n);
/// A01: a point mass of 1 kg on a massless bar of 1 m, from (−1, 0) at rest; the bar has no inertia.
Mechanism make_point_mass_pendulum();
/// Swinging arm, a body fixed to its tip at an angle, and a pendulum on that; 2 degrees of freedom.
Mechanism make_rigid_chain();

/// Offset slider-crank with an oblique guide and a force on the slider, 1 degree of freedom.
Mechanism make_slider_crank();
/// The slider-crank of benchmarks.md: 0.1 N m on the crank from rest, no gravity.
Mechanism make_slider_crank_torque();
/// The slider-crank of Flores and Ambrosio: driven at 5000 rpm from the outer dead centre, clearance joint "pin"
/// between rod (bearing) and slider (journal), no friction, no gravity.
Mechanism make_slider_crank_clearance();

/// Four-bar with a torque on the crank and a force on the coupler, 1 degree of freedom.
Mechanism make_four_bar();
/// Five-bar, 2 degrees of freedom, both cranks with start rates.
Mechanism make_five_bar();
/// Three equal cranks on one coupler: one constraint row is redundant, 1 degree of freedom.
Mechanism make_parallelogram();
/// A02: n loops, 1 degree of freedom, the first top joint at 1 m/s along x.
Mechanism make_n_four_bar(int n);

/// Quick-return: a block on the crank pin slides along a slotted rocker, which pushes a ram; 1 degree of freedom.
Mechanism make_six_bar_slide();
/// A body on an oblique guide, a second one on a perpendicular guide on the first, a pendulum on the second; 3.
Mechanism make_two_slides();
/// A block driven along a freely swinging arm, with a pendulum on the block; 2 degrees of freedom.
Mechanism make_driven_slide();

/// The slider-crank with a crank that swings to and fro by an expression; no freedom.
Mechanism make_swung_slider_crank();
/// Arm, hand welded to a bracket at an angle, and a tassel: a driver bends the hand against the arm, which swings
/// freely or is driven by an expression.
Mechanism make_driven_arm(bool shoulder_driven);
/// A crank pin in the oblique slot of a yoke on an oblique guide; 1 degree of freedom.
Mechanism make_scotch_yoke();
/// The quick-return with the pin straight in the rocker's slot and a crank that does not turn uniformly.
Mechanism make_quick_return();
/// A rod that only two pins in slots hold, one of the slots its own; 1 degree of freedom.
Mechanism make_trammel();
/// The two slides and the pendulum all driven with acceleration, and a free tail on the pendulum.
Mechanism make_moved_slides();
/// The driven slide with a table for its motion.
Mechanism make_splined_slide();
/// A body without any joint, thrown.
Mechanism make_projectile();

/// A disc whose journal sits off its centre in a bearing of the frame, with friction; 3 degrees of freedom.
Mechanism make_free_body_in_bearing();
/// Two free bodies that meet only in one clearance joint; no joint leads to the frame and there is no gravity.
Mechanism make_free_pair();
/// The free pair of unlike materials, pressing by a law of cylinders: what counts is E*, not K.
Mechanism make_free_pair_of_cylinders();
/// A driven slider-crank whose slider stands in an oblique guide with clearance; 2 degrees of freedom.
Mechanism make_slider_crank_guide();
/// A block with a pendulum, loose in the slot of a swinging arm; 5 degrees of freedom.
Mechanism make_block_in_turning_slot();
/// The scotch yoke with a pin that is thinner than its slot; 2 degrees of freedom.
Mechanism make_scotch_yoke_clearance();
/// A free block of 2 kg and 1 g m², 100 x 50 mm with corners of 5 mm, in a level slot of the frame that is 1 m long and
/// leaves it 1 mm on either side; the start is that of its middle, from the slot's. No gravity, no friction, Hertz.
Mechanism make_loose_block(BodyStart start, double young_modulus);
/// The free pair with a block in a slot instead of a journal in a bearing.
Mechanism make_free_pair_in_slot();
/// The paper's press (nine_bar.md): clearance joints A and B, Lankarani-Nikravesh, lugre_steady, archard.
Mechanism make_nine_bar();

/// make_four_bar() with springs and dampers to the frame and between moving bodies.
Mechanism make_sprung_four_bar();
/// make_slider_crank() with a motor's torque-speed line and a press force over the slider's displacement.
Mechanism make_press();
/// Two links, each with a controller that follows a reference angle.
Mechanism make_controlled_arm();
/// A loose body on a bushing at the tip of a swinging bar.
Mechanism make_pod_on_bushing();
/// make_rigid_chain() with torsion springs between its bodies.
Mechanism make_torsion_chain();
/// make_five_bar() with a force that turns with a rod, over a periodic curve of the time.
Mechanism make_pushed_five_bar();
/// make_driven_slide() with a spring, a follower force and a brake.
Mechanism make_loaded_driven_slide();
/// make_two_slides() with forces over both displacements and speeds.
Mechanism make_loaded_slides();
/// make_slider_crank_clearance() with loads on the journal's body.
Mechanism make_loaded_clearance();
/// All mechanisms with variable loads.
std::vector<Mechanism> make_loaded_mechanisms();

/// One of each.
std::vector<Mechanism> make_all_mechanisms();

}  // namespace gudgeon::oracle
