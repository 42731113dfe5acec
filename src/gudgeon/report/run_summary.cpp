// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The sections of a run one after the other.
#include "gudgeon/report/run_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "gudgeon/analysis/energy_audit.h"
#include "gudgeon/base/shown_text.h"
#include "gudgeon/report/comparison_section.h"
#include "gudgeon/report/joint_section.h"
#include "gudgeon/report/number_format.h"
#include "gudgeon/report/stage_section.h"
#include "gudgeon/report/table.h"

namespace gudgeon {

namespace {

std::string render_header(const RunRecord& run, bool color) {
  std::string text = render_title(fmt::format("{}, case '{}'", run.model_file, run.case_name), color).substr(1);
  text += fmt::format("  written by gudgeon {}\n", show_line(run.program_version));
  for (const auto& [path, value] : run.overrides) {
    text += fmt::format("  {} = {}\n", show_line(path), show_line(value));
  }
  return text;
}

/// A channel's owner and what of it: "slider_9" and "x_velocity".
struct ChannelName {
  std::string owner;
  std::string part;
};

ChannelName split_name(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string::npos) return {"", name};
  return {name.substr(0, dot), name.substr(dot + 1)};
}

/// One line an owner, parts of the same unit together: "x, y [m], angle [rad]".
std::string render_channel_groups(const StageRecord& stage, bool color) {
  struct Group {
    std::string owner;
    std::string parts;
    std::string unit;  // of the last part, not yet written
  };
  const auto end_unit = [](Group& group) {
    if (!group.unit.empty()) group.parts += fmt::format(" [{}]", group.unit);
  };
  std::vector<Group> groups;
  for (const Channel& channel : stage.channels) {
    const ChannelName name = split_name(channel.name);
    auto group = std::ranges::find(groups, name.owner, &Group::owner);
    if (group == groups.end()) group = groups.insert(groups.end(), Group{name.owner, "", channel.unit});
    if (group->unit != channel.unit) end_unit(*group);
    group->parts += (group->parts.empty() ? "" : ", ") + name.part;
    group->unit = channel.unit;
  }
  Table table({{"of"}, {"channels"}});
  for (Group& group : groups) {
    end_unit(group);
    table.add_row({group.owner, group.parts});
  }
  return table.render(color);
}

std::string render_channels(const RunRecord& run, bool color) {
  std::string text;
  const StageRecord* last = nullptr;
  for (const StageRecord& stage : run.stages) {
    const bool same =
        last != nullptr && std::ranges::equal(stage.channels, last->channels, {}, &Channel::name, &Channel::name);
    if (!same) {
      text += render_title(fmt::format("{} channels from stage '{}' on", stage.channels.size(), stage.name), color);
      text += render_channel_groups(stage, color);
    }
    last = &stage;
  }
  return text;
}

std::string render_contents(const RunRecord& run, bool color) {
  Table table({{"stage"},
               {"from", Alignment::right},
               {"to", Alignment::right},
               {"samples", Alignment::right},
               {"statistics", Alignment::right},
               {"contacts", Alignment::right},
               {"energy residual", Alignment::right},
               {"balanced"},
               {"worn joints (cells)"}});
  for (const StageRecord& stage : run.stages) {
    std::string joints;
    for (const JointWear& wear : stage.wear) {
      joints += fmt::format("{}{} ({})", joints.empty() ? "" : ", ", wear.joint, wear.n_cells());
    }
    const std::string samples =
        stage.time.empty() ? std::string(kNoNumber) : format_count(static_cast<std::int64_t>(stage.time.size()));
    table.add_row({stage.name, format_engineering(stage.start_time, "s"), format_engineering(stage.end_time, "s"),
                   samples, format_count(static_cast<std::int64_t>(stage.statistics.size())),
                   format_count(static_cast<std::int64_t>(stage.events.size())),
                   fmt::format("{:.1e}", check_energy(stage.energy).relative), is_balanced(stage.energy) ? "yes" : "NO",
                   joints});
  }
  return table.empty() ? "" : render_title("Contents", color) + table.render(color);
}

}  // namespace

std::string render_summary(const RunRecord& run, std::span<const ReferenceRow> reference, bool color) {
  return render_header(run, color) + render_stages(run, color) + render_limits_exceeded(run, color) +
         render_peaks(run, color) + render_wear(run, color) + render_contacts(run, color) +
         render_ideal_errors(run, color) + render_energy(run, color) + render_reference(run, reference, color);
}

std::string render_info(const RunRecord& outline, bool color) {
  return render_header(outline, color) + render_stages(outline, color) + render_contents(outline, color) +
         render_channels(outline, color);
}

}  // namespace gudgeon
