// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One error a gap, or one for all drivers.
#include "gudgeon/system/open_loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "gudgeon/base/diagnostics.h"

namespace gudgeon {

namespace {

void add_missed_angle(const Mechanism& mechanism, const Tables& tables, const ClosureRows& rows, double gap,
                      Diagnostics& diagnostics) {
  const Driver& driver = mechanism.drivers[tables.driven[rows.driver].driver];
  const auto& angle = std::get<DrivenAngle>(driver.target);
  diagnostics.error("E-MODEL-070", "drivers." + driver.name,
                    fmt::format("driver '{}' cannot be followed: the angle of '{}' against '{}' stays {:.6g} deg off",
                                driver.name, angle.body, angle.against, gap * 180.0 / std::numbers::pi),
                    {"check its start, lengths and pivots, or remove a driver that contradicts it"});
}

void add_open_joint(const Joint& joint, double gap, Diagnostics& diagnostics) {
  const auto [first, second] = anchors(joint.kind);
  diagnostics.error("E-MODEL-070", "joints." + joint.name,
                    fmt::format("joint '{}' cannot be closed: {}.{} and {}.{} stay {:.6g} mm apart", joint.name,
                                first.body, first.point, second.body, second.point, 1e3 * gap),
                    {"check lengths and pivots, or give start angles nearer to a position that closes"});
}

}  // namespace

void throw_open_loop(const Mechanism& mechanism, const Tables& tables, const LoopCloser& closer) {
  Diagnostics diagnostics;
  double widest = 0.0;
  for (const Vec2 gap : closer.workspace.closure_gap) widest = std::max(widest, norm(gap));
  // Gaps far below any length are named only where there are no others.
  const double least = std::min(1e-9 * closer.size(), 0.5 * widest);
  for (std::size_t c = 0; c < tables.closures.size(); ++c) {
    const double gap = norm(closer.workspace.closure_gap[c]);
    if (gap <= least) continue;
    if (tables.closures[c].kind == ClosureKind::angle) {
      add_missed_angle(mechanism, tables, tables.closures[c], gap, diagnostics);
    } else {
      add_open_joint(mechanism.joints[tables.closures[c].joint], gap, diagnostics);
    }
  }
  throw ModelError(diagnostics);
}

void throw_over_driven(const Mechanism& mechanism, int n_degrees_of_freedom) {
  std::vector<std::string> names;
  for (const Driver& driver : mechanism.drivers) names.push_back(driver.name);
  const auto n = static_cast<int>(names.size());
  Diagnostics diagnostics;
  diagnostics.error(
      "E-MODEL-045", "drivers." + names.back(),
      fmt::format("{} drivers ({}) on {} degree{} of freedom: they ask for positions that exclude each other", n,
                  join_names(names), n_degrees_of_freedom, n_degrees_of_freedom == 1 ? "" : "s"),
      {fmt::format("remove {} of them; without drivers all joints close", n - n_degrees_of_freedom)});
  throw ModelError(diagnostics);
}

}  // namespace gudgeon
