// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The results of a run, by the names of stages, joints and channels. A name that is not there throws
// std::out_of_range, which says which there are. What is handed out as a reference or span lives as long as the Result.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// Wear depths [m], one a cell. A round bearing or journal is one surface, its cells counter-clockwise from the x axis
/// of its body on, each 2π/n wide. Sides of a slot and corners of a block are several, one behind the other:
/// docs/theory/wear.md.
class DepthProfile {
 public:
  explicit DepthProfile(std::vector<double> depths) : depths_(std::move(depths)) {}

  [[nodiscard]] std::size_t size() const { return depths_.size(); }
  [[nodiscard]] double operator[](std::size_t cell) const { return depths_[cell]; }
  [[nodiscard]] std::span<const double> values() const { return depths_; }
  [[nodiscard]] auto begin() const { return depths_.begin(); }
  [[nodiscard]] auto end() const { return depths_.end(); }
  /// [m] of the deepest cell; 0 without cells.
  [[nodiscard]] double max() const;
  /// [m] over all cells; 0 without cells.
  [[nodiscard]] double mean() const;

 private:
  std::vector<double> depths_;
};

/// A clearance joint in one stage.
class JointResult {
 public:
  explicit JointResult(const JointWear& wear) : wear_(&wear) {}

  [[nodiscard]] const std::string& name() const { return wear_->joint; }
  /// Depths after the stage: what all stages up to and with it have worn, times the wear acceleration.
  [[nodiscard]] DepthProfile bearing_depth() const { return DepthProfile(wear_->bearing_depth_after()); }
  [[nodiscard]] DepthProfile journal_depth() const { return DepthProfile(wear_->journal_depth_after()); }
  /// What this stage alone has added to them.
  [[nodiscard]] DepthProfile bearing_depth_added() const { return DepthProfile(wear_->bearing_depth_added); }
  [[nodiscard]] DepthProfile journal_depth_added() const { return DepthProfile(wear_->journal_depth_added); }
  /// Radii, clearance, volumes, sliding distance, time in contact, impulse.
  [[nodiscard]] const JointWear& record() const { return *wear_; }

 private:
  const JointWear* wear_;
};

/// One stage: "ideal", "no_wear", "wear_1", "wear_2" …
class StageResult {
 public:
  explicit StageResult(const StageRecord& stage) : stage_(&stage) {}

  [[nodiscard]] const std::string& name() const { return stage_->name; }
  [[nodiscard]] std::vector<std::string> joint_names() const;  ///< those with clearance
  [[nodiscard]] JointResult joint(std::string_view name) const;

  /// "slider_9.x_acceleration", "A.normal_force" …; docs/guide/run_file.md explains them.
  [[nodiscard]] std::vector<std::string> channel_names() const;
  [[nodiscard]] const Channel& channel(std::string_view name) const;  ///< its unit and meaning
  /// [s] of each sample, study.outputs_per_cycle a counted cycle, from the first counted cycle on.
  [[nodiscard]] std::span<const double> time() const { return stage_->time; }
  /// One a sample, in the channel's SI unit.
  [[nodiscard]] std::span<const double> values(std::string_view channel) const;
  /// Extremes, mean and root mean square over the counted cycles, of all steps of the integrator, not only of samples.
  [[nodiscard]] const ChannelStatistics& statistics(std::string_view channel) const;

  /// [1] what is missing in the stage's energy balance, over what it is measured by (docs/theory/energy.md).
  [[nodiscard]] double energy_error() const;
  /// Everything: contact events, energies, work of the integrator, how it ended.
  [[nodiscard]] const StageRecord& record() const { return *stage_; }

 private:
  const StageRecord* stage_;
};

/// All stages of one model.
class Result {
 public:
  explicit Result(std::vector<StageRecord> stages) : stages_(std::move(stages)) {}

  [[nodiscard]] std::vector<std::string> stage_names() const;
  [[nodiscard]] StageResult stage(std::string_view name) const&;
  [[nodiscard]] StageResult stage(std::string_view name) && = delete;  // it would outlive what it shows
  /// The last stage that was run.
  [[nodiscard]] StageResult last_stage() const& { return StageResult(stages_.back()); }
  [[nodiscard]] StageResult last_stage() && = delete;
  /// Why its numbers are not all to be relied on: stages that failed, were stopped, or whose energy is not balanced;
  /// a sentence each. Empty when all is right, as it always is of a run that require_sound was asked of.
  [[nodiscard]] std::vector<std::string> problems() const;

 private:
  std::vector<StageRecord> stages_;
};

}  // namespace gudgeon
