// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One sweep, and the least of all reactions where there are many.
#include "gudgeon/system/reactions.h"

namespace gudgeon {

ReactionFinder::ReactionFinder(const System& system)
    : system_(&system), sweep_(system.mechanism, system.topology, system.tables), self_stress_(system) {}

const std::vector<JointReaction>& ReactionFinder::update(const Workspace& workspace,
                                                         const std::vector<BodyMotion>& motions) noexcept {
  sweep_.update(system_->tables, workspace, motions);
  self_stress_.relax(workspace, motions, sweep_.reactions());
  return sweep_.reactions();
}

}  // namespace gudgeon
