// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Ideal run, then dynamics and wear in turn.
#include "gudgeon/sim/run_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/model/cycle_time.h"
#include "gudgeon/sim/stage_run.h"
#include "gudgeon/system/assembly.h"
#include "gudgeon/system/start_check.h"

namespace gudgeon {

namespace {

std::string stage_name(int wear_updates) {
  return wear_updates == 0 ? std::string{"no_wear"} : fmt::format("wear_{}", wear_updates);
}

// The surfaces that the next stage runs on, and how far they have slid.
void rebuild_surfaces(System& system, const StageRecord& stage, double wear_acceleration) {
  for (std::size_t k = 0; k < stage.wear.size(); ++k) {
    const JointWear& wear = stage.wear[k];
    set_surfaces(system, k, wear.bearing_depth_after(), wear.journal_depth_after());
    const ContactGroup& group = system.tables.contact_groups[k];
    for (int c = group.first_contact; c < group.end_contact; ++c) {
      system.tables.contacts[c].sliding_distance += wear_acceleration * wear.sliding_distance;
    }
  }
}

// The joints whose journal has nothing left after the stage; empty when all have.
std::string find_worn_through(const StageRecord& stage) {
  std::string text;
  for (const JointWear& wear : stage.wear) {
    const double deepest = std::ranges::max(wear.journal_depth_after());
    if (deepest < wear.journal_radius) continue;
    text += fmt::format("{}joint '{}': its journal of radius {:.4g} mm would be worn {:.4g} mm deep",
                        text.empty() ? "" : "; ", wear.joint, 1e3 * wear.journal_radius, 1e3 * deepest);
  }
  return text;
}

// Values stay an empty list a channel.
void drop_samples(StageRecord& stage) {
  stage.time = {};
  stage.values = std::vector<std::vector<double>>(stage.channels.size());
}

class StudyRunner {
 public:
  StudyRunner(const Mechanism& mechanism, Assembly assembly, const Study& study, const RunHooks& hooks,
              std::vector<StageRecord> finished, std::optional<Checkpoint> checkpoint)
      : mechanism_(mechanism),
        study_(study),
        hooks_(hooks),
        finished_(std::move(finished)),
        checkpoint_(std::move(checkpoint)),
        assembly_(std::move(assembly)),
        ideal_assembly_(assembly_),
        cycle_time_(find_cycle_time(mechanism, study)),
        has_clearance_(std::ranges::any_of(mechanism.joints, [](const Joint& j) { return has_clearance(j.kind); })),
        runs_ideal_(!has_clearance_ || (study.compare_ideal && find_ideal_assembly())),
        n_stages_(has_clearance_ ? (runs_ideal_ ? 1 : 0) + 1 + study.wear_stages : 1) {}

  std::vector<StageRecord> run() {
    // A mechanism without clearance is its own ideal.
    if (runs_ideal_) {
      if (is_stopped_before("ideal") ||
          !run_stage(compile(make_ideal_counterpart(), ideal_assembly_), ideal_assembly_, "ideal")) {
        return std::move(stages_);
      }
    }
    if (!has_clearance_ || is_stopped_before(stage_name(0))) return std::move(stages_);
    System system = compile(mechanism_, assembly_);
    for (int wear_updates = 0; wear_updates <= study_.wear_stages; ++wear_updates) {
      if (!run_stage(system, assembly_, stage_name(wear_updates))) break;
      if (wear_updates == study_.wear_stages) break;
      if (const std::string worn_through = find_worn_through(stages_.back()); !worn_through.empty()) {
        fail_stage(stage_name(wear_updates + 1), worn_through);
        break;
      }
      if (is_stopped_before(stage_name(wear_updates + 1))) break;
      rebuild_surfaces(system, stages_.back(), study_.wear_acceleration);
    }
    return std::move(stages_);
  }

 private:
  // What closes only thanks to its clearance, or starts as only clearance permits, has no ideal to compare with.
  bool find_ideal_assembly() {
    const auto ideal = assemble_ideal(mechanism_);
    if (ideal) ideal_assembly_ = *ideal;
    return ideal.has_value();
  }

  [[nodiscard]] Mechanism make_ideal_counterpart() const {
    return study_.ideal_friction ? make_ideal_with_friction(mechanism_) : make_ideal(mechanism_);
  }

  // Every stage starts from the assembled position.
  bool run_stage(const System& system, const Assembly& assembly, const std::string& name) {
    const int index = static_cast<int>(stages_.size());
    if (stages_.size() < finished_.size() && finished_[stages_.size()].name == name) {
      stages_.push_back(std::move(finished_[stages_.size()]));
      return true;
    }
    const auto report = [&](double fraction) {
      if (hooks_.progress) hooks_.progress({name, index, n_stages_, fraction});
    };
    report(0.0);
    StageRun stage(system, study_, cycle_time_, name);
    if (is_stopped_before(name)) return false;  // it takes a second to be made where surfaces have a million cells
    if (hooks_.samples) stage.stream(hooks_.samples_per_block, hooks_.samples);
    if (hooks_.checkpoint) stage.save(hooks_.checkpoint_wanted, hooks_.checkpoint);
    if (checkpoint_ && checkpoint_->stage == name) stage.resume(*std::exchange(checkpoint_, std::nullopt));
    stages_.push_back(stage.run(make_state(system, assembly), hooks_.stop, report));
    if (hooks_.stage_finished) hooks_.stage_finished(stages_.back());
    if (hooks_.samples) drop_samples(stages_.back());
    return stages_.back().status == StageStatus::finished;
  }

  // What a stage needs is not made any more; of hundreds of bodies it would take a second.
  bool is_stopped_before(const std::string& name) {
    if (!hooks_.stop.stop_requested() || stages_.size() < finished_.size() || checkpoint_) return false;
    end_stage(name, StageStatus::stopped, "stopped on request before it began");
    return true;
  }

  // A stage that cannot be run is told like one that could not go on.
  void fail_stage(const std::string& name, const std::string& reason) {
    end_stage(name, StageStatus::failed, fmt::format("E-NUM-004: {}; lower study.wear_acceleration", reason));
  }

  void end_stage(const std::string& name, StageStatus status, std::string message) {
    StageRecord stage;
    stage.name = name;
    stage.status = status;
    stage.cycle_time = cycle_time_;
    stage.message = std::move(message);
    stages_.push_back(std::move(stage));
    if (hooks_.stage_finished) hooks_.stage_finished(stages_.back());
  }

  const Mechanism& mechanism_;
  const Study& study_;
  const RunHooks& hooks_;
  std::vector<StageRecord> finished_;     // by an earlier run, in order
  std::optional<Checkpoint> checkpoint_;  // of the stage after them
  Assembly assembly_;
  Assembly ideal_assembly_;
  double cycle_time_;
  bool has_clearance_;
  bool runs_ideal_;
  int n_stages_;
  std::vector<StageRecord> stages_;
};

}  // namespace

std::vector<StageRecord> run_study(const Mechanism& mechanism, const Study& study, const RunHooks& hooks,
                                   std::vector<StageRecord> finished, std::optional<Checkpoint> checkpoint) {
  Assembly assembly = assemble(mechanism);
  require_start(mechanism, assembly);
  require_ideal_start(mechanism, study);
  return StudyRunner(mechanism, std::move(assembly), study, hooks, std::move(finished), std::move(checkpoint)).run();
}

}  // namespace gudgeon
