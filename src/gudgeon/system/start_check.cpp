// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What a run would meet first, found without one.
#include "gudgeon/system/start_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/system/dynamics.h"
#include "gudgeon/system/loose_start.h"
#include "gudgeon/system/mobility.h"
#include "gudgeon/system/motion_chart.h"
#include "gudgeon/system/self_stress.h"
#include "gudgeon/system/system.h"

namespace gudgeon {

namespace {

void require_regular(const Mechanism& mechanism, const Assembly& assembly) {
  if (!find_mobility(mechanism, assembly).singular_start) return;
  Diagnostics diagnostics;
  diagnostics.error("E-MODEL-073", "",
                    "the mechanism starts in a singular position, where its motion is not determined",
                    {"start a little beside it: change a start angle or a driver's start"});
  throw ModelError(diagnostics);
}

// The first coordinate whose own pivot vanished; what is eliminated after it is spoilt, too.
int find_massless(const System& system, const Workspace& workspace) {
  for (int k = 0; k < system.tables.counts.n_free(); ++k) {
    const int at = system.tables.elimination.find_slot(k, k);
    if (!std::isfinite(workspace.inverse_pivots[at])) return k;
  }
  return -1;
}

// [N] forces of self-stress are of order one.
constexpr double kOpen = 1e-9;

bool is_open(const JointReaction& openness) {
  return std::max({openness.force.x, openness.force.y, openness.moment}) > kOpen;
}

// Whether friction of a joint depends on what of its reaction is open; a guide and a slot have no open force along
// them.
bool follows_open_reaction(const FrictionJoint& joint, const JointReaction& openness) {
  const bool tilts = joint.kind == FrictionKind::guide && joint.friction.guide_length > 0.0;
  return std::max(openness.force.x, openness.force.y) > kOpen || (tilts && openness.moment > kOpen);
}

/// A law without any coefficient above zero, as a sweep of one begins with.
bool never_rubs(const AnyFriction& any) {
  return std::visit(
      []<class Law>(const Law& law) {
        return std::ranges::all_of(Law::kParameters, [&](const Parameter<Law>& parameter) {
          const bool is_coefficient = parameter.symbol.starts_with("μ") || parameter.symbol == "σ₂";
          return !is_coefficient || law.*parameter.member == 0.0;
        });
      },
      any);
}

// Where constraints imply each other the joints' elasticity decides what each of them carries, and rubs with.
void require_unique_reactions(const System& system, const Workspace& workspace) {
  if (system.tables.friction_joints.empty()) return;
  SelfStress self_stress(system);
  if (self_stress.empty()) return;
  BodyMotionFinder finder(system);
  const std::vector<JointReaction> openness = self_stress.find_openness(workspace, finder.update(workspace));
  std::string open;
  for (std::size_t j = 0; j < openness.size(); ++j) {
    if (!is_open(openness[j])) continue;
    open += fmt::format("{}'{}'", open.empty() ? "" : ", ", system.mechanism.joints[j].name);
  }
  Diagnostics diagnostics;
  for (const FrictionJoint& joint : system.tables.friction_joints) {
    if (never_rubs(joint.friction.law) || !follows_open_reaction(joint, openness[joint.joint])) continue;
    const std::string& name = system.mechanism.joints[joint.joint].name;
    diagnostics.error("E-MODEL-092", "joints." + name + ".friction",
                      fmt::format("joint '{}' has friction, and the force that it carries is not determined: the "
                                  "constraints of joints {} imply each other",
                                  name, open),
                      {"leave one of them out, or let it give way: a pin_in_slot, a joint with clearance, a bushing"});
  }
  if (diagnostics.has_errors()) throw ModelError(diagnostics);
}

void require_accelerations(const Mechanism& mechanism, const Assembly& assembly) {
  const System system = compile(mechanism, assembly);
  Workspace workspace(system.tables);
  const State state = make_state(system, assembly);
  const std::vector<ContactMode> open(system.tables.contacts.size());
  eval_dynamics(system.tables, 0.0, state.q.data(), state.v.data(), open, {}, workspace);
  require_unique_reactions(system, workspace);
  bool determined = true;
  for (int k = 0; k < system.tables.counts.n_free(); ++k) {
    determined = determined && std::isfinite(workspace.equations[k]);
  }
  if (determined) return;
  Diagnostics diagnostics;
  if (!(workspace.friction_margin > 0.0)) {
    const std::string& joint = mechanism.joints[workspace.friction_joint].name;
    diagnostics.error("E-MODEL-093", "joints." + joint + ".friction",
                      fmt::format("joint '{}' jams at the start: no acceleration, or more than one, agrees with its "
                                  "friction",
                                  joint),
                      {kJamAdvice});
    throw ModelError(diagnostics);
  }
  const int massless = find_massless(system, workspace);
  const std::string name = massless >= 0 ? name_coordinate(system, massless) : std::string{};
  if (massless >= 0 && massless < system.tables.counts.n_free_turns) {
    diagnostics.error("E-MODEL-076", "bodies." + name + ".inertia",
                      fmt::format("body '{}': nothing has inertia about the point it turns about, and something acts "
                                  "on its angle; its angular acceleration is not determined",
                                  name),
                      {"give it an inertia above 0"});
  } else {
    diagnostics.error("E-MODEL-073", "", "the accelerations at the start are not determined",
                      {"the start may be singular: change a start angle or a driver's start"});
  }
  throw ModelError(diagnostics);
}

}  // namespace

void require_start(const Mechanism& mechanism, const Assembly& assembly) {
  require_regular(mechanism, assembly);
  require_clear_start(mechanism, assembly);
  require_accelerations(mechanism, assembly);
}

void require_ideal_start(const Mechanism& mechanism, const Study& study) {
  const bool has_any =
      std::ranges::any_of(mechanism.joints, [](const Joint& joint) { return has_clearance(joint.kind); });
  if (!has_any || !study.compare_ideal || !study.ideal_friction) return;
  if (const auto assembly = assemble_ideal(mechanism)) require_start(make_ideal_with_friction(mechanism), *assembly);
}

}  // namespace gudgeon
