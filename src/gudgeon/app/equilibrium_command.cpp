// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon equilibrium.
#include "gudgeon/app/equilibrium_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "gudgeon/app/model_options.h"
#include "gudgeon/app/table_units.h"
#include "gudgeon/app/text_output.h"
#include "gudgeon/report/number_format.h"
#include "gudgeon/report/table.h"
#include "gudgeon/system/equilibrium.h"

namespace gudgeon {
namespace {

constexpr double kLeastArm = 1e-3;  // [m] moments of joint forces on a shorter arm than this do not show

struct EquilibriumOptions {
  ModelOptions model;
  std::string case_name;
  bool all = false;
};

/// What is only rounding beside the largest value of its kind is shown as zero.
std::string format_beside(double value, double largest, std::string_view unit) {
  constexpr double kRounding = 1e-12;
  return format_engineering(std::abs(value) <= kRounding * largest ? 0.0 : value, unit);
}

std::string render_pose(const Equilibrium& found, bool color) {
  double farthest = 0.0;
  for (const BodyPose& pose : found.poses) farthest = std::max(farthest, norm(pose.position));
  Table table({{"body"}, {"x", Alignment::right}, {"y", Alignment::right}, {"angle", Alignment::right}});
  for (std::size_t b = 1; b < found.poses.size(); ++b) {
    const BodyPose& pose = found.poses[b];
    table.add_row({found.mechanism.bodies[b].name, format_beside(pose.position.x, farthest, "m"),
                   format_beside(pose.position.y, farthest, "m"), render_fixed(pose.angle / kDegree, 6) + "°"});
  }
  return render_title("Position of each body's origin", color) + table.render(color);
}

std::string render_forces(const Equilibrium& found, bool color) {
  const Mechanism& mechanism = found.mechanism;
  Table table({{"driver or joint"},
               {"effort or force", Alignment::right},
               {"along x", Alignment::right},
               {"along y", Alignment::right},
               {"moment", Alignment::right}});
  double force = 0.0;
  double moment = 0.0;
  for (const JointReaction& reaction : found.reactions) {
    force = std::max(force, norm(reaction.force));
    moment = std::max({moment, std::abs(reaction.moment), norm(reaction.force) * kLeastArm});
  }
  for (std::size_t d = 0; d < found.efforts.size(); ++d) {
    const bool turns = std::holds_alternative<DrivenAngle>(mechanism.drivers[d].target);
    table.add_row({mechanism.drivers[d].name, format_engineering(found.efforts[d], turns ? "N m" : "N")});
  }
  for (std::size_t j = 0; j < found.reactions.size(); ++j) {
    const JointReaction& reaction = found.reactions[j];
    const AnyJoint& kind = mechanism.joints[j].kind;
    const bool has_moment = std::holds_alternative<Prismatic>(kind) || std::holds_alternative<Rigid>(kind);
    table.add_row({mechanism.joints[j].name, format_beside(norm(reaction.force), force, "N"),
                   format_beside(reaction.force.x, force, "N"), format_beside(reaction.force.y, force, "N"),
                   has_moment ? format_beside(reaction.moment, moment, "N m") : ""});
  }
  if (table.empty()) return {};
  return render_title("Efforts that hold the drivers, forces on each joint's second body", color) + table.render(color);
}

std::string describe_mode(const EquilibriumMode& mode) {
  switch (mode.kind) {
    case EquilibriumMode::Kind::neutral:
      return "neutral: nothing brings it back";
    case EquilibriumMode::Kind::unstable:
      return fmt::format("unstable, grows e-fold in {}", format_engineering(1.0 / mode.growth_rate, "s"));
    case EquilibriumMode::Kind::stable:
      break;
  }
  if (mode.growth_rate == 0.0) return "swings, undamped";
  return fmt::format("dies e-fold in {}", format_engineering(-1.0 / mode.growth_rate, "s"));
}

/// "stable", "neutral in mode 1", "unstable in mode 2", "held".
std::string name_stability(const Equilibrium& found) {
  if (found.modes.empty()) return "held";
  std::string verdict = "stable";
  for (const auto& [kind, word] :
       {std::pair{EquilibriumMode::Kind::neutral, "neutral"}, std::pair{EquilibriumMode::Kind::unstable, "unstable"}}) {
    const auto first = std::ranges::find(found.modes, kind, &EquilibriumMode::kind);
    if (first != found.modes.end()) verdict = fmt::format("{} in mode {}", word, first - found.modes.begin() + 1);
  }
  return verdict;
}

std::string render_modes(const Equilibrium& found, bool color) {
  if (found.modes.empty()) return "\nNo degree of freedom is left: the drivers hold it.\n";
  Table table({{"mode"}, {"moves most"}, {"frequency", Alignment::right}, {"damping ratio", Alignment::right}, {""}});
  for (std::size_t k = 0; k < found.modes.size(); ++k) {
    const EquilibriumMode& mode = found.modes[k];
    table.add_row({fmt::format("{}", k + 1), mode.most_moved, fmt::format("{:.6g} Hz", mode.frequency),
                   fmt::format("{:.4g}", mode.damping_ratio), describe_mode(mode)});
  }
  return render_title("Small motions: " + name_stability(found), color) + table.render(color);
}

bool has_variable_loads(const Mechanism& mechanism) {
  return std::ranges::any_of(mechanism.loads, [](const Load& load) {
    return std::holds_alternative<VariableForce>(load.kind) || std::holds_alternative<VariableTorque>(load.kind);
  });
}

std::string render_found(const Equilibrium& found, bool color) {
  return render_pose(found, color) + render_forces(found, color) + render_modes(found, color) +
         fmt::format("\nPotential energy: {}\n", format_engineering(found.potential_energy, "J"));
}

ExitCode run_equilibrium(const EquilibriumOptions& options) {
  const ModelFile model = read_case(options.model, options.case_name);
  require_sound_mechanism(model);
  const std::vector<Equilibrium> found = with_source(model, [&] {
    return options.all ? find_equilibria(model.mechanism) : std::vector<Equilibrium>{find_equilibrium(model.mechanism)};
  });
  const bool color = find_color_wanted();
  write_stdout(render_model_title(model) + name_closed_joints(model.mechanism) + tell_redundancy(model.mechanism));
  if (has_variable_loads(model.mechanism)) write_stdout("Loads that vary are taken as they are at t = 0, at rest.\n");
  if (!options.all) {
    const int n = found.front().iterations;
    write_stdout(fmt::format("At rest, {} step{} from the start.\n", n, n == 1 ? "" : "s"));
  }
  for (std::size_t k = 0; k < found.size(); ++k) {
    if (options.all) {
      const std::string title = fmt::format("Equilibrium {} of {}: {}", k + 1, found.size(), name_stability(found[k]));
      write_stdout(render_title(title, color));
    }
    write_stdout(render_found(found[k], color));
  }
  return ExitCode::done;
}

}  // namespace

void add_equilibrium_command(CLI::App& program, Action& action) {
  const auto options = std::make_shared<EquilibriumOptions>();
  CLI::App* command = program.add_subcommand(
      "equilibrium", "Where the mechanism stays at rest, what holds it there, natural frequencies and stability");
  add_model_options(*command, options->model);
  add_case_option(*command, options->case_name);
  command->add_flag("--all", options->all, "Walk one turn from the start and list every equilibrium met");
  command->footer("\nExample:\n  gudgeon equilibrium press.toml --set gravity=\"[0, -9.81]\"\n");
  command->callback([options, &action] { action = [options] { return run_equilibrium(*options); }; });
}

}  // namespace gudgeon
