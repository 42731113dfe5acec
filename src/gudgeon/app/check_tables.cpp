// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Tables of a sound model.
#include "gudgeon/app/check_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gudgeon/app/table_units.h"
#include "gudgeon/report/table.h"
#include "gudgeon/system/characteristic_length.h"

namespace gudgeon {
namespace {

std::string find_side(double fold) {
  constexpr double kStraight = 1e-6;  // on such a fold the two branches meet
  if (std::abs(fold) < kStraight) return "neither side";
  return fold < 0.0 ? "right" : "left";
}

bool find_has_clearance(const Mechanism& mechanism) {
  return std::ranges::any_of(mechanism.joints, [](const Joint& joint) { return has_clearance(joint.kind); });
}

}  // namespace

std::string render_counts(const Mechanism& mechanism, const Mobility& mobility, bool color) {
  const auto n_drivers = mechanism.drivers.size();
  Table table({{"mobility, in the textbook count"}, {"", Alignment::right}, {""}});
  const auto add = [&](std::string_view name, int count, std::string_view remark) {
    table.add_row({std::string(name), fmt::format("{}", count), std::string(remark)});
  };
  add("moving bodies", mobility.n_bodies, "");
  add("coordinates", mobility.n_coordinates, "3 a moving body");
  add("constraint rows", mobility.n_constraint_rows,
      n_drivers == 0 ? "" : fmt::format("{} of them by driver{}", n_drivers, n_drivers == 1 ? "" : "s"));
  add("redundant rows", mobility.n_redundant_rows, "");
  add("degrees of freedom", mobility.n_degrees_of_freedom,
      find_has_clearance(mechanism) ? "a clearance joint takes none away" : "");
  add("unknowns integrated", mobility.n_unknowns, "angles and displacements that gudgeon keeps");
  add("closure rows", mobility.n_closure_rows, "loops that gudgeon closes with them");
  std::string text = table.render(color);
  for (const std::string& constraint : mobility.redundant_constraints)
    text += fmt::format("  redundant: {}\n", constraint);
  if (mobility.n_redundant_rows > 0) {
    text += fmt::format(
        "  joint forces are the least that balance the loads; moments count as forces at the characteristic length of "
        "{:.6g} mm\n",
        find_characteristic_length(mechanism) / kMillimeter);
  }
  if (!mobility.held_to_second_order.empty()) {
    text +=
        fmt::format("  '{}' is held to second order only: it yields to any load, and a run stops when a joint opens\n",
                    mobility.held_to_second_order);
  }
  return text;
}

std::string render_start(const Mechanism& mechanism, const Assembly& assembly, bool color) {
  Table table({{"body"},
               {"x (mm)", Alignment::right},
               {"y (mm)", Alignment::right},
               {"angle (deg)", Alignment::right},
               {"from its guess (deg)", Alignment::right}});
  for (std::size_t i = 1; i < mechanism.bodies.size(); ++i) {
    const BodyPose& pose = assembly.poses[i];
    table.add_row({mechanism.bodies[i].name, render_fixed(pose.position.x / kMillimeter, 4),
                   render_fixed(pose.position.y / kMillimeter, 4), render_fixed(pose.angle / kDegree, 4),
                   render_fixed(assembly.angle_changes[i] / kDegree, 4)});
  }
  return render_title(find_has_clearance(mechanism) ? "Start position, clearance joints closed" : "Start position",
                      color) +
         table.render(color) +
         fmt::format("  largest gap left in a joint: {:.2g} mm\n", assembly.closure_residual / kMillimeter);
}

std::string render_loops(const Assembly& assembly, bool color) {
  if (assembly.branches.empty()) return {};
  Table table({{"closed at"}, {"from"}, {"to"}, {"folds to the"}, {"sine", Alignment::right}});
  for (const LoopBranch& branch : assembly.branches) {
    table.add_row({branch.joint, branch.first_body, branch.second_body, find_side(branch.fold),
                   fmt::format("{:+.3f}", branch.fold)});
  }
  return render_title("Loops and the branch each is on", color) + table.render(color);
}

std::string render_cycle(const Study& study) {
  return study.cycle_time > 0.0 ? fmt::format("\nOne cycle takes {:.6g} s.\n", study.cycle_time) : std::string{};
}

}  // namespace gudgeon
