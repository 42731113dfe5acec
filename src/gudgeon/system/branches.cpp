// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Compares signs of folds with what is asked for.
#include "gudgeon/system/branches.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "gudgeon/base/diagnostics.h"

namespace gudgeon {

namespace {

void add_missing_branch(const Joint& joint, Diagnostics& diagnostics) {
  diagnostics.error("E-MODEL-077", "joints." + joint.name + ".branch",
                    fmt::format("joint '{}' cannot be assembled on the branch \"{}\"", joint.name,
                                *joint.branch == Branch::left ? "left" : "right"),
                    {"`gudgeon kinematics --branches` lists those that assemble; or leave the branch out and let the "
                     "start angles choose"});
}

}  // namespace

bool is_on_branch(const Joint& joint, const FoldAngle& angle) {
  return !joint.branch || (*joint.branch == Branch::left ? angle.sine > 0.0 : angle.sine < 0.0);
}

void require_closing_branches(const Mechanism& mechanism, const Topology& topology) {
  std::vector<std::string> closing;
  for (const Closure& closure : topology.closures) {
    if (closure.joint >= 0) closing.push_back(mechanism.joints[closure.joint].name);
  }
  Diagnostics diagnostics;
  for (const Joint& joint : mechanism.joints) {
    if (!joint.branch || std::ranges::find(closing, joint.name) != closing.end()) continue;
    diagnostics.error("E-MODEL-078", "joints." + joint.name + ".branch",
                      fmt::format("joint '{}' closes no loop, so it has no branch", joint.name),
                      {closing.empty() ? std::string("no joint of this mechanism closes a loop")
                                       : fmt::format("loops are closed by: {}", join_names(closing))});
  }
  if (diagnostics.has_errors()) throw ModelError(diagnostics);
}

void require_branches(const Mechanism& mechanism, const Tables& tables, const LoopFolds& folds,
                      const Coordinates& coordinates) {
  Diagnostics diagnostics;
  for (const LoopFold& fold : folds.folds()) {
    const Joint& joint = mechanism.joints[tables.closures[fold.closure].joint];
    if (is_on_branch(joint, folds.find_angle(fold, coordinates))) continue;
    add_missing_branch(joint, diagnostics);
  }
  if (diagnostics.has_errors()) throw ModelError(diagnostics);
}

void throw_missing_branch(const Joint& joint) {
  Diagnostics diagnostics;
  add_missing_branch(joint, diagnostics);
  throw ModelError(diagnostics);
}

}  // namespace gudgeon
