// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Scene and motion of the animation to JSON.
#include <algorithm>

#include "gudgeon/report/figures/case_figures.h"
#include "gudgeon/report/html/figure_data.h"

namespace gudgeon {

namespace {

void add_place(JsonText& json, std::string_view name, Vec2 place) {
  json.key(name);
  json.begin_array();
  json.add(place.x);
  json.add(place.y);
  json.end_array();
}

void add_scene_body(JsonText& json, const SceneBody& body) {
  json.begin_object();
  json.put("name", body.name);
  json.put("frame", body.is_frame);
  json.key("points");
  json.begin_array();
  for (const ScenePoint& point : body.points) {
    json.begin_object();
    json.put("name", point.name);
    add_place(json, "place", point.place);
    json.end_object();
  }
  json.end_array();
  json.end_object();
}

/// Bearing and journal radius where the run has them.
void add_radii(JsonText& json, const RunRecord& run, const std::string& joint) {
  for (const StageRecord& stage : run.stages) {
    const JointWear* wear = find_wear(stage, joint);
    if (wear == nullptr) continue;
    json.put("bearing_radius", wear->bearing_radius);
    json.put("journal_radius", wear->journal_radius);
    return;
  }
}

void add_scene_joint(JsonText& json, const SceneJoint& joint, const RunRecord& run) {
  json.begin_object();
  json.put("name", joint.name);
  json.put("kind", joint.kind);
  json.put("first", joint.first);
  json.put("second", joint.second);
  add_place(json, "first_place", joint.first_place);
  add_place(json, "second_place", joint.second_place);
  json.put("direction", joint.direction);
  json.put("clearance", joint.clearance);
  json.put("slot_length", joint.slot_length);
  json.put("block_length", joint.block_length);
  json.put("block_height", joint.block_height);
  add_radii(json, run, joint.name);
  json.end_object();
}

/// Adds the last samples of a channel under a name; nothing when it was not read.
void add_tail(JsonText& json, BlockStore& blocks, std::string_view name, const Numbers& numbers, std::size_t n_last) {
  if (!numbers) return;
  const std::size_t n = std::min(n_last, numbers->size());
  blocks.keep(numbers);
  // As trajectories of figures do, so that they are one block.
  json.put(name,
           blocks.find({numbers.get(), 2 * n + 1}, [&] { return blocks.add_signal(std::span(*numbers).last(n)); }));
}

void add_channels_of(JsonText& json, BlockStore& blocks, Signals& signals, const StageRecord& stage,
                     const std::string& owner, std::initializer_list<std::string_view> parts, std::size_t n_last) {
  json.begin_object();
  for (const std::string_view part : parts) {
    add_tail(json, blocks, part, signals.find_values_of(stage, owner + "." + std::string(part)), n_last);
  }
  json.end_object();
}

void add_stage_motion(JsonText& json, BlockStore& blocks, const Scene& scene, Signals& signals,
                      const StageRecord& stage, double full_cycles) {
  const std::size_t n_last = std::min(stage.time.size(), find_full_count(full_cycles, find_cycle_samples(stage)));
  json.begin_object();
  json.put("stage", stage.name);
  json.put("label", label_stage(stage.name));
  json.put("color", find_stage_color(signals.run(), stage.name));
  json.put("cycle_time", stage.cycle_time);
  json.put("time", blocks.add_times(std::span(stage.time).last(n_last)));
  json.key("bodies");
  json.begin_array();
  for (const SceneBody& body : scene.bodies) {
    add_channels_of(json, blocks, signals, stage, body.name, {"x", "y", "angle"}, n_last);
  }
  json.end_array();
  json.key("joints");
  json.begin_array();
  for (const SceneJoint& joint : scene.joints) {
    add_channels_of(json, blocks, signals, stage, joint.name,
                    {"x_offset", "y_offset", "x_force", "y_force", "normal_force", "displacement", "height", "tilt",
                     "left_force", "right_force", "n_contacts"},
                    n_last);
  }
  json.end_array();
  json.end_object();
}

}  // namespace

std::vector<std::string> find_pose_channels(const Scene& scene, const StageRecord& stage) {
  std::vector<std::string> wanted;
  for (const SceneBody& body : scene.bodies) {
    for (const char* ending : {".x", ".y", ".angle"}) wanted.push_back(body.name + ending);
  }
  for (const SceneJoint& joint : scene.joints) {
    if (!joint.kind.ends_with("_clearance")) continue;
    for (const char* ending : {".x_force", ".y_force", ".left_force", ".right_force", ".n_contacts"})
      wanted.push_back(joint.name + ending);
  }
  std::erase_if(wanted, [&](const std::string& name) {
    return std::ranges::find(stage.channels, name, &Channel::name) == stage.channels.end();
  });
  return wanted;
}

void add_scene(JsonText& json, const Scene& scene, const RunRecord& run) {
  json.begin_object();
  add_place(json, "gravity", scene.gravity);
  json.key("bodies");
  json.begin_array();
  for (const SceneBody& body : scene.bodies) add_scene_body(json, body);
  json.end_array();
  json.key("joints");
  json.begin_array();
  for (const SceneJoint& joint : scene.joints) add_scene_joint(json, joint, run);
  json.end_array();
  json.end_object();
}

void add_motions(JsonText& json, BlockStore& blocks, const Scene& scene, Signals& signals, double full_cycles) {
  json.begin_array();
  for (const StageRecord& stage : signals.run().stages) {
    if (stage.time.size() > 1) add_stage_motion(json, blocks, scene, signals, stage, full_cycles);
  }
  json.end_array();
}

}  // namespace gudgeon
