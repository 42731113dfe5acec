// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The branches that joints ask for: whether they can be asked, and whether they were reached.
#pragma once

#include "gudgeon/system/loop_folds.h"

namespace gudgeon {

/// Whether a loop folds to the side that its joint asks for, if it does.
bool is_on_branch(const Joint& joint, const FoldAngle& angle);
/// Throws ModelError when a joint asks for a branch and closes no loop.
void require_closing_branches(const Mechanism& mechanism, const Topology& topology);
/// Throws ModelError: the loops do not close with this joint's on the branch that it asks for.
[[noreturn]] void throw_missing_branch(const Joint& joint);
/// Throws ModelError when a loop is on another branch than its joint asks for.
void require_branches(const Mechanism& mechanism, const Tables& tables, const LoopFolds& folds,
                      const Coordinates& coordinates);

}  // namespace gudgeon
