// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon kinematics.
#include "gudgeon/app/kinematics_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <optional>

#include "gudgeon/app/command_line.h"
#include "gudgeon/app/model_options.h"
#include "gudgeon/app/table_units.h"
#include "gudgeon/app/text_output.h"
#include "gudgeon/io/csv_export.h"
#include "gudgeon/model/check.h"
#include "gudgeon/report/kinematic_summary.h"
#include "gudgeon/report/table.h"
#include "gudgeon/sim/kinematic_cycle.h"
#include "gudgeon/system/assembly.h"

namespace gudgeon {
namespace {

struct KinematicsOptions {
  ModelOptions model;
  std::string case_name;
  int cycles = 1;
  int samples = 360;
  std::filesystem::path directory;
  bool overwrite = false;
  bool branches = false;
};

constexpr std::size_t kMostLoops = 10;  // 1024 combinations to try
constexpr double kMostSamples = 1e6;    // some gigabytes of channels

std::optional<Assembly> try_branches(Mechanism& mechanism, const std::vector<int>& joints, unsigned choice) {
  for (std::size_t k = 0; k < joints.size(); ++k) {
    mechanism.joints[joints[k]].branch = ((choice >> k) & 1u) != 0u ? Branch::right : Branch::left;
  }
  try {
    return assemble(mechanism);
  } catch (const ModelError&) {
    return std::nullopt;  // this combination does not assemble
  }
}

std::string render_places(const Mechanism& mechanism, const Assembly& assembly, bool color) {
  Table table({{"joint"}, {"x (mm)", Alignment::right}, {"y (mm)", Alignment::right}});
  for (const Joint& joint : mechanism.joints) {
    const Anchor& anchor = anchors(joint.kind).second;
    const int body = find_body(mechanism, anchor.body);
    const Vec2 place = assembly.poses[body].find_point(find_point(mechanism.bodies[body], anchor.point)->position);
    table.add_row({joint.name, render_fixed(place.x / kMillimeter, 4), render_fixed(place.y / kMillimeter, 4)});
  }
  return table.render(color);
}

std::string render_angles(const Mechanism& mechanism, const Assembly& assembly, bool color) {
  Table table({{"body"}, {"angle (deg)", Alignment::right}});
  for (std::size_t b = 1; b < mechanism.bodies.size(); ++b) {
    table.add_row({mechanism.bodies[b].name, render_fixed(assembly.poses[b].angle / kDegree, 4)});
  }
  return table.render(color);
}

bool is_same_position(const Assembly& one, const Assembly& other) {
  constexpr double kSame = 1e-4;  // [rad, m] assemblies are further apart, unless they meet
  for (std::size_t b = 0; b < one.poses.size(); ++b) {
    if (std::abs(std::remainder(one.poses[b].angle - other.poses[b].angle, 2.0 * std::numbers::pi)) > kSame ||
        norm(one.poses[b].position - other.poses[b].position) > kSame) {
      return false;
    }
  }
  return true;
}

std::string_view name_side(double fold) {
  constexpr double kFlat = 1e-6;  // on such a fold two branches meet
  if (std::abs(fold) < kFlat) return "flat";
  return fold > 0.0 ? "left" : "right";
}

std::string name_sides(const Assembly& assembly) {
  std::string sides;
  for (const LoopBranch& branch : assembly.branches) {
    sides += fmt::format("{} joint '{}' {}", sides.empty() ? "" : ",", branch.joint, name_side(branch.fold));
  }
  return sides;
}

// All of them, those with the first joint on the left first.
std::string render_assemblies(const Mechanism& mechanism, const Assembly& start, std::vector<Assembly> all,
                              bool color) {
  const auto find_order = [](const Assembly& one) {
    std::vector<bool> rights;
    for (std::size_t k = one.branches.size(); k-- > 0;) rights.push_back(!(one.branches[k].fold > 0.0));
    return rights;
  };
  std::ranges::stable_sort(all, [&](const Assembly& a, const Assembly& b) { return find_order(a) < find_order(b); });
  std::map<std::string, int> n_alike;
  for (const Assembly& one : all) ++n_alike[name_sides(one)];
  std::string text;
  int n_listed = 0;
  bool any_alike = false;
  for (const Assembly& one : all) {
    const bool is_start = is_same_position(one, start);
    text +=
        render_title(fmt::format("Branch {}:{}{}", ++n_listed, name_sides(one), is_start ? " (the model's start)" : ""),
                     color) +
        render_places(mechanism, one, color) + render_angles(mechanism, one, color);
    any_alike = any_alike || n_alike[name_sides(one)] > 1;
  }
  if (any_alike) text += "\nWhere branches fold to the same sides, the start angles choose between them.\n";
  return text;
}

std::string render_branches(const ModelFile& model, bool color) {
  const Assembly start = assemble(model.mechanism);
  if (const auto all = find_all_assemblies(model.mechanism); all && !start.branches.empty()) {
    return render_model_title(model) + name_closed_joints(model.mechanism) +
           render_assemblies(make_ideal(model.mechanism), start, *all, color);
  }
  Mechanism mechanism = make_ideal(model.mechanism);
  std::vector<int> joints;
  for (const LoopBranch& branch : start.branches) joints.push_back(find_joint(mechanism, branch.joint));
  if (joints.empty()) return "No joint closes a loop: there is one way to assemble the mechanism.\n";
  if (joints.size() > kMostLoops) {
    throw UsageError(fmt::format("--branches tries both sides of at most {} loops; this mechanism has {}", kMostLoops,
                                 joints.size()));
  }
  std::string text;
  int n_found = 0;
  for (unsigned choice = 0; choice < (1u << joints.size()); ++choice) {
    const std::optional<Assembly> assembly = try_branches(mechanism, joints, choice);
    if (!assembly) continue;
    std::string title = fmt::format("Branch {}:", ++n_found);
    bool is_start = true;
    for (std::size_t k = 0; k < joints.size(); ++k) {
      const bool left = assembly->branches[k].fold > 0.0;
      is_start = is_start && left == (start.branches[k].fold > 0.0);
      title += fmt::format("{} joint '{}' {}", k == 0 ? "" : ",", assembly->branches[k].joint, left ? "left" : "right");
    }
    text += render_title(title + (is_start ? " (the model's start)" : ""), color) +
            render_places(mechanism, *assembly, color);
  }
  if (n_found == 0) text = "The loops lie flat at the start: their branches meet there and cannot be told apart.\n";
  return render_model_title(model) + name_closed_joints(model.mechanism) + text;
}

ExitCode run_cycle(const KinematicsOptions& options, const ModelFile& model) {
  KinematicPlan plan{find_cycle_time(model.mechanism, model.study), options.cycles, options.samples, {}};
  if (const Driver* driver = find_cycle_driver(model.mechanism, model.study)) plan.driver = driver->name;
  const KinematicRecord record = with_source(model, [&] { return run_kinematics(model.mechanism, plan); });
  write_stdout(render_model_title(model) + name_closed_joints(model.mechanism) + tell_redundancy(model.mechanism));
  write_stdout(render_kinematics(record, find_color_wanted()));
  if (!options.directory.empty()) {
    for (const auto& path : export_motion(record.motion, options.directory, options.overwrite)) {
      write_stdout(fmt::format("{}\n", path.string()));
    }
  }
  if (record.motion.status == StageStatus::failed) throw NumericalError(record.motion.message);
  return ExitCode::done;
}

ExitCode run_command(const KinematicsOptions& options) {
  if (options.cycles < 1) throw UsageError(fmt::format("--cycles must be at least 1; it is {}", options.cycles));
  if (options.samples < 2) throw UsageError(fmt::format("--samples must be at least 2; it is {}", options.samples));
  if (static_cast<double>(options.cycles) * options.samples > kMostSamples) {
    throw UsageError(fmt::format("--cycles {} with --samples {} asks for more than {:.0e} samples", options.cycles,
                                 options.samples, kMostSamples));
  }
  const ModelFile model = read_case(options.model, options.case_name);
  require_sound(model);
  if (!options.branches) return run_cycle(options, model);
  write_stdout(with_source(model, [&] { return render_branches(model, find_color_wanted()); }));
  return ExitCode::done;
}

}  // namespace

void add_kinematics_command(CLI::App& program, Action& action) {
  const auto options = std::make_shared<KinematicsOptions>();
  CLI::App* command = program.add_subcommand(
      "kinematics", "Motion of the ideal mechanism under its drivers, efforts, dead centres, transmission angles");
  add_model_options(*command, options->model);
  add_case_option(*command, options->case_name);
  command->add_option("--cycles", options->cycles, "Cycles to follow")->capture_default_str();
  command->add_option("--samples", options->samples, "Samples a cycle")->capture_default_str();
  command->add_option("-o,--output", options->directory, "Output directory for CSV files (created if missing)");
  command->add_flag("--overwrite", options->overwrite, "Replace existing files");
  command->add_flag("--branches", options->branches, "Only list the ways in which the loops can be assembled");
  command->footer(
      "\nExamples:\n  gudgeon kinematics press.toml --samples 720 -o csv\n  gudgeon kinematics press.toml "
      "--branches\n");
  command->callback([options, &action] { action = [options] { return run_command(*options); }; });
}

}  // namespace gudgeon
