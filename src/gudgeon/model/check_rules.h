// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What the parts of check() share: the model under check, and the wording of a broken rule. Used by check*.cpp only.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/base/parameter_table.h"
#include "gudgeon/base/vec2.h"
#include "gudgeon/model/channel_names.h"
#include "gudgeon/model/mechanism.h"
#include "gudgeon/model/name_index.h"
#include "gudgeon/model/study.h"

namespace gudgeon {

class CheckRules {
 public:
  CheckRules(const Mechanism& model, const Study& plan, const SourceMap* source, bool read_with_errors)
      : mechanism(model), names(model), study(plan), source_(source), read_with_errors_(read_with_errors) {}

  /// One value of the model: the subject and key name it for the user, the path finds its place.
  struct Value {
    std::string subject;  ///< "joint 'A'"
    std::string path;     ///< "joints.A.radial_clearance"
    double value;
    Dimension dimension;
  };

  /// Demands a finite value within the range.
  void check_range(std::string_view code, const Value& value, const ParameterRange& range);
  void check_finite(const std::string& subject, const std::string& path, Vec2 value);
  /// Demands a non-empty name of letters, digits and '_'.
  void check_name(const std::string& what, const std::string& path, const std::string& name);
  /// Says that a name is none of the known ones.
  void report_unknown(std::string_view code, const std::string& path, const std::string& message, std::string_view name,
                      std::string_view kind, const std::vector<std::string>& known);
  /// "\"-0.5 mm\" (-0.0005 m)", or only the SI value when it is not known how it was written.
  [[nodiscard]] std::string describe(const Value& value) const;
  /// Made when first asked for.
  const ChannelIndex& channels() {
    if (!channels_) channels_.emplace(mechanism);
    return *channels_;
  }

  const Mechanism& mechanism;
  const NameIndex names;
  const Study& study;
  Diagnostics diagnostics;

 private:
  const SourceMap* source_;
  std::optional<ChannelIndex> channels_;
  bool read_with_errors_;  // what is no number could not be read, and has been reported
};

/// "0.25 mm" in SI, "0.00025 m"; the number alone without a dimension.
std::string with_unit(double value, Dimension dimension);

/// "positive", "not negative", "above 0 and at most 1" …
std::string describe_range(const ParameterRange& range, Dimension dimension);

template <class Named>
std::vector<std::string> list_names(const std::vector<Named>& items) {
  std::vector<std::string> names;
  for (const Named& item : items) names.push_back(item.name);
  return names;
}

void check_bodies(CheckRules& rules);
void check_joints(CheckRules& rules);
void check_contacts(CheckRules& rules);
/// Law and sizes of an ideal joint's friction; none at all is right.
void check_joint_friction(CheckRules& rules, const Joint& joint);
void check_drivers(CheckRules& rules);
void check_loads(CheckRules& rules);
void check_study(CheckRules& rules);
void check_plausibility(CheckRules& rules);

/// Whose a function is: where it stands, and what it may depend on.
struct FunctionUse {
  std::string subject;        ///< "load 'push': x of force"
  std::string owner;          ///< "loads.push", the path of the table that may have constants for it
  std::string key;            ///< "force.0"
  Dimension dimension;        ///< of its value
  bool of_time_only = false;  ///< true for motions
  [[nodiscard]] std::string path() const { return owner + "." + key; }
};

/// Demands that a function can be evaluated.
void check_function(CheckRules& rules, const FunctionUse& use, const Function& function);
/// The same; true when it can.
bool check_expression(CheckRules& rules, const FunctionUse& use, const Expression& expression);
bool check_curve(CheckRules& rules, const FunctionUse& use, const SampledCurve& curve);
/// Demands a smoothing that leaves a curve; warns of noise in a motion without one.
bool check_smoothing(CheckRules& rules, const FunctionUse& use, const SampledCurve& curve);
/// Says what a sound curve does between its points.
void remark_curve(CheckRules& rules, const FunctionUse& use, const SampledCurve& curve);

/// Where a motion is not smooth enough to be followed.
struct MotionJump {
  double time = 0.0;  ///< [s]
  int order = 0;      ///< what jumps: 0 the value, 1 the speed, 2 the acceleration
  double size = 0.0;  ///< [rad or m, over s to the order]
};

/// A jump of a sound formula of the time, between t = 0 and the end of the study; both durations in s.
std::optional<MotionJump> find_motion_jump(const Expression& motion, double cycle_time, double duration);

/// Demands that body and point exist.
void check_anchor(CheckRules& rules, const std::string& subject, const std::string& path, const Anchor& anchor);

}  // namespace gudgeon
