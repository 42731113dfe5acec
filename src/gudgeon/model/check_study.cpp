// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Rules for the study: its cycle, its ranges, and wear that has nothing to wear.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "gudgeon/model/check_fields.h"
#include "gudgeon/model/cycle_time.h"

namespace gudgeon {

namespace {

// A cycle time that differs from its driver's by more was not computed from it.
constexpr double kSameTime = 1e-9;

/// Demands that a named cycle driver is there, is an angle, and turns.
bool check_cycle_driver(CheckRules& rules) {
  const std::string& name = rules.study.cycle_driver;
  const std::vector<Driver>& drivers = rules.mechanism.drivers;
  const auto found = std::ranges::find(drivers, name, &Driver::name);
  if (name.empty()) return true;
  if (found == drivers.end()) {
    rules.report_unknown("E-STUDY-001", "study.cycle_driver",
                         fmt::format("study: cycle_driver: unknown driver '{}'", name), name, "drivers",
                         list_names(drivers));
  } else if (!std::holds_alternative<DrivenAngle>(found->target)) {
    rules.diagnostics.error("E-STUDY-002", "study.cycle_driver",
                            fmt::format("study: cycle_driver '{}' drives a slide, which has no turns", name),
                            {"give cycle_time instead"});
  } else if (!found->is_uniform()) {
    rules.diagnostics.error(
        "E-STUDY-012", "study.cycle_driver",
        fmt::format("study: cycle_driver '{}' moves as its motion says, which need not make turns", name),
        {"give cycle_time instead"});
  } else if (found->speed == 0.0) {
    rules.diagnostics.error("E-STUDY-003", "study.cycle_driver",
                            fmt::format("study: cycle_driver '{}' stands still, so it has no turns", name),
                            {"give cycle_time instead"});
  } else {
    return std::isfinite(found->speed);  // reported with the driver
  }
  return false;
}

void check_cycle(CheckRules& rules) {
  const Study& study = rules.study;
  if (!check_cycle_driver(rules)) return;
  const bool given = study.cycle_time != 0.0;
  const bool any_motion = std::ranges::any_of(rules.mechanism.drivers, std::not_fn(&Driver::is_uniform));
  if (!given && any_motion && find_cycle_driver(rules.mechanism, study) == nullptr) {
    rules.diagnostics.error("E-STUDY-013", "study",
                            "study: cycle_time is missing; no driver turns uniformly, so nothing says what a cycle is",
                            {"give cycle_time = \"1 s\", a period of the drivers' motions for example"});
    return;
  }
  const double time = find_cycle_time(rules.mechanism, study);
  const CheckRules::Value written{"study", "study.cycle_time", given ? study.cycle_time : time, dimension::kTime};
  rules.check_range("E-STUDY-004", written, kPositive);
  if (given && !study.cycle_driver.empty() && std::abs(study.cycle_time - time) > kSameTime * time) {
    rules.diagnostics.error("E-STUDY-009", "study.cycle_time",
                            fmt::format("study: cycle_time is {}, but one turn of cycle_driver '{}' takes {:.6g} s",
                                        rules.describe(written), study.cycle_driver, time));
  }
}

bool wears(const AnyWear& wear) { return !std::holds_alternative<NoWear>(wear); }

void check_wear(CheckRules& rules) {
  const Study& study = rules.study;
  const bool any_wear = std::ranges::any_of(rules.mechanism.joints, [](const Joint& joint) {
    const ContactProperties* contact = find_contact(joint.kind);
    return contact != nullptr && (wears(contact->bearing_wear) || wears(contact->journal_wear));
  });
  if (study.wear_stages > 0 && !any_wear) {
    rules.diagnostics.warning(
        "W-STUDY-001", "study.wear_stages",
        fmt::format("study: wear_stages is {}, but no contact of a joint wears", study.wear_stages),
        {"give a contact a wear law, or set wear_stages = 0"});
  }
  if (study.wear_distribution == WearDistribution::point && study.wear_stages > 0) {
    rules.diagnostics.remark(
        "R-STUDY-002", "study.wear_distribution",
        "study: wear_distribution \"point\" does not conserve the worn volume; its depth depends on cells",
        {"\"spread\" conserves it"});
  }
}

/// What a study asks for in all, in numbers that may be far beyond an int.
struct StudySize {
  double n_stages = 0.0;
  double n_cycles = 0.0;   // of all stages, warm-up included
  double n_samples = 0.0;  // of one stage
  double room = 0.0;       // [B] of all stages in the run file, before compression
  double stage_room = 0.0;
};

StudySize find_size(const Mechanism& mechanism, const Study& study) {
  constexpr double kStageHead = 1e4;  // [B] channels, statistics and energies of the smallest stage
  // Nine channels a moving body, up to ten a joint; drivers and energies hardly count.
  const double n_channels =
      9.0 * static_cast<double>(mechanism.bodies.size()) + 10.0 * static_cast<double>(mechanism.joints.size());
  StudySize size;
  size.n_stages = 1.0 + study.wear_stages + (study.compare_ideal ? 1.0 : 0.0);
  size.n_cycles = size.n_stages * (static_cast<double>(study.warm_up_cycles) + study.cycles);
  size.n_samples = static_cast<double>(study.cycles) * study.outputs_per_cycle;
  size.stage_room = 8.0 * n_channels * size.n_samples;
  size.room = size.n_stages * (size.stage_room + kStageHead);
  return size;
}

/// The count that is largest beside its default: lowering that one helps most.
const char* find_largest_count(const Study& study) {
  const Study usual;
  const std::array<std::pair<double, const char*>, 4> counts{
      {{study.wear_stages / 10.0, "study.wear_stages"},
       {static_cast<double>(study.warm_up_cycles) / usual.cycles, "study.warm_up_cycles"},
       {static_cast<double>(study.cycles) / usual.cycles, "study.cycles"},
       {static_cast<double>(study.outputs_per_cycle) / usual.outputs_per_cycle, "study.outputs_per_cycle"}}};
  return std::ranges::max_element(counts, {}, &std::pair<double, const char*>::first)->second;
}

// A stage's samples go to the disk as they come.
void check_room(CheckRules& rules, const StudySize& size) {
  constexpr double kMuchRoom = 4e9;        // [B] more than most programs can load at once
  constexpr double kMuchRoomInAll = 1e11;  // [B] more than a disk has to spare
  const Study& study = rules.study;
  if (size.stage_room > kMuchRoom) {
    rules.diagnostics.warning(
        "W-STUDY-010", "study.outputs_per_cycle",
        fmt::format("study: {} cycles of {} samples take up to {:.0f} GB of the run file a stage, {:.0f} GB in all",
                    study.cycles, study.outputs_per_cycle, 1e-9 * size.stage_room, 1e-9 * size.room),
        {"lower outputs_per_cycle or cycles; peaks are found at every step whatever is recorded"});
  } else if (size.room > kMuchRoomInAll) {
    rules.diagnostics.warning(
        "W-STUDY-010", find_largest_count(study),
        fmt::format("study: {:.0f} stages of {:.0f} samples take up to {:.0f} GB of the run file", size.n_stages,
                    size.n_samples, 1e-9 * size.room),
        {"lower wear_stages, raise wear_acceleration instead; or record less (outputs_per_cycle)"});
  }
}

// Only told where it is days whatever the mechanism: hardly one takes less for a cycle, and many take a hundred times
// it.
void check_duration(CheckRules& rules, const StudySize& size) {
  constexpr double kLeastCycle = 1e-3;   // [s] to compute a cycle
  constexpr double kLeastSample = 1e-6;  // [s] to record a sample
  constexpr double kDay = 86400.0;
  const double days = (kLeastCycle * size.n_cycles + kLeastSample * size.n_stages * size.n_samples) / kDay;
  if (days < 1.0) return;
  rules.diagnostics.warning(
      "W-STUDY-011", find_largest_count(rules.study),
      fmt::format(
          "study: {:.0f} stages of {} cycles, {} of them to warm up, are {:.3g} cycles and {:.3g} samples; at a "
          "millisecond a cycle and a microsecond a sample, which few mechanisms stay below, that takes {:.3g} days",
          size.n_stages, static_cast<long>(rules.study.cycles) + rules.study.warm_up_cycles, rules.study.warm_up_cycles,
          size.n_cycles, size.n_stages * size.n_samples, days),
      {"lower wear_stages, cycles, warm_up_cycles or outputs_per_cycle; wear_acceleration lets few cycles wear like "
       "many"});
}

void check_reference(CheckRules& rules) {
  static const std::vector<std::string> kMeasures{"peak", "wear_depth"};
  for (std::size_t i = 0; i < rules.study.reference.size(); ++i) {
    const ReferenceValue& reference = rules.study.reference[i];
    const std::string path = fmt::format("study.reference.{}", i);
    const std::string subject = fmt::format("reference value {}", i + 1);
    if (std::ranges::find(kMeasures, reference.measure) == kMeasures.end()) {
      rules.report_unknown("E-STUDY-007", path + ".measure",
                           fmt::format("{}: unknown measure '{}'", subject, reference.measure), reference.measure,
                           "measures", kMeasures);
    }
    if (reference.channel.empty()) {
      rules.diagnostics.error("E-STUDY-008", path + ".channel", fmt::format("{}: channel is empty", subject));
    }
  }
}

void check_ideal_friction(CheckRules& rules) {
  const int slot = find_bristled_slot(rules.mechanism);
  if (!rules.study.ideal_friction || slot < 0) return;
  rules.diagnostics.error(
      "E-MODEL-018", "study.ideal_friction",
      fmt::format(
          "joint '{}': the friction law of its contact bends bristles, and an ideal pin changes the wall of its "
          "slot that they are on",
          rules.mechanism.joints[slot].name),
      {"a law without bristles, as lugre_steady, can; or leave ideal_friction out"});
}

}  // namespace

void check_study(CheckRules& rules) {
  check_ideal_friction(rules);
  FieldCheck(rules, "study", "study").check(rules.study);
  check_cycle(rules);
  check_wear(rules);
  const StudySize size = find_size(rules.mechanism, rules.study);
  check_room(rules, size);
  check_duration(rules, size);
  check_reference(rules);
}

}  // namespace gudgeon
