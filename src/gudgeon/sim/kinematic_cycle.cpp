// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Samples the motion at even times, and looks between samples for what lies there.
#include "gudgeon/sim/kinematic_cycle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "gudgeon/sim/kinematic_channels.h"
#include "gudgeon/system/characteristic_length.h"

namespace gudgeon {

namespace {

// A rate below this share of the mechanism's largest one, and a fold below this share of its own peak, is zero but for
// rounding.
constexpr double kNothing = 1e-11;
// What happens between samples is looked for at this many points a cycle at least: two dead centres that lie closer
// together than a degree of the driver are one halt.
constexpr int kLeastLooks = 720;

class CycleRun {
 public:
  CycleRun(const Mechanism& mechanism, const KinematicPlan& plan)
      : plan_(plan),
        looks_((kLeastLooks + plan.samples - 1) / plan.samples),
        solver_(mechanism),
        driver_(find_driver()),
        probe_(solver_, driver_),
        channels_(solver_, probe_),
        length_(find_characteristic_length(solver_.system().mechanism)),
        coordinates_(probe_.list_coordinates()) {
    rates_.resize(coordinates_.size());
    folds_.resize(solver_.folds().folds().size());
    transmissions_.resize(folds_.size());
  }

  KinematicRecord run() {
    sample_motion();
    channels_.finish(record_.motion);
    for (std::size_t k = 0; k < coordinates_.size(); ++k) find_dead_centres(k);
    std::ranges::stable_sort(record_.dead_centres, {}, [](const DeadCentre& centre) { return centre.at.time; });
    for (std::size_t f = 0; f < folds_.size(); ++f) {
      if (solver_.folds().folds()[f].is_dyad) find_transmission(f);
      find_branch_changes(f);
    }
    return std::move(record_);
  }

 private:
  [[nodiscard]] const Mechanism& mechanism() const { return solver_.system().mechanism; }

  int find_driver() {
    const auto& drivers = mechanism().drivers;
    if (drivers.empty()) return -1;
    const auto found = std::ranges::find(drivers, plan_.driver, &Driver::name);
    const auto& driver = found == drivers.end() ? drivers.front() : *found;
    record_.driver = driver.name;
    record_.driver_unit = std::holds_alternative<DrivenAngle>(driver.target) ? "rad" : "m";
    return static_cast<int>(&driver - drivers.data());
  }

  void sample_motion() {
    StageRecord& stage = record_.motion;
    stage.name = "kinematics";
    stage.cycle_time = plan_.cycle_time;
    if (solver_.failure()) return fail();
    const int n = plan_.cycles * plan_.samples * looks_;
    for (int i = 0; i <= n; ++i) {
      if (!solver_.move_to(find_look_time(i))) return fail();
      look();
      if (i % looks_ != 0) continue;
      channels_.sample();
      stage.end_time = solver_.point().time;
    }
    stage.cycles = plan_.cycles;
    // A dead centre at the very end shows only beyond it; where that cannot be reached there is none.
    const MotionPoint end = solver_.point();
    if (solver_.move_to(find_look_time(n + 1))) look();
    solver_.return_to(end);
  }

  [[nodiscard]] double find_look_time(int i) const { return plan_.cycle_time * i / (plan_.samples * looks_); }

  void look() {
    probe_.update();
    points_.push_back(solver_.point());
    for (std::size_t k = 0; k < coordinates_.size(); ++k) {
      rates_[k].push_back(probe_.find_rate(coordinates_[k]));
      largest_rate_ = std::max(largest_rate_, std::abs(rates_[k].back()) / find_unit(coordinates_[k]));
    }
    const CoordinateCounts& counts = solver_.system().tables.counts;
    const std::vector<DrivenValue>& driven = solver_.workspace().coordinates.driven;
    for (int d = 0; d < static_cast<int>(driven.size()); ++d) {
      const bool slides = d >= counts.n_driven_turns && d < counts.n_driven();
      largest_rate_ = std::max(largest_rate_, std::abs(driven[d].rate) / (slides ? length_ : 1.0));
    }
    for (std::size_t f = 0; f < folds_.size(); ++f) {
      const LoopFold& fold = solver_.folds().folds()[f];
      folds_[f].push_back(probe_.find_fold(fold));
      if (fold.is_dyad) transmissions_[f].push_back(probe_.find_transmission(fold));
    }
  }

  // What a coordinate is measured in: 1 rad, or the characteristic length [m].
  [[nodiscard]] double find_unit(MotionProbe::Coordinate coordinate) const {
    return coordinate.body >= 0 ? 1.0 : length_;
  }

  void fail() {
    const MotionFailure& failure = *solver_.failure();
    record_.motion.status = StageStatus::failed;
    record_.failure_time = failure.time;
    probe_.update();
    std::string where = failure.where.empty() ? std::string() : ", " + failure.where;
    if (driver_ >= 0) {
      const double value = probe_.find_driver_value(driver_);
      where += record_.driver_unit == "rad"
                   ? fmt::format(", driver '{}' at {:.6g} deg", record_.driver, 180.0 / std::numbers::pi * value)
                   : fmt::format(", driver '{}' at {:.6g} mm", record_.driver, 1e3 * value);
    }
    record_.motion.message = fmt::format("E-NUM-010: the motion cannot be followed beyond t = {:.9g} s{}: {}",
                                         failure.time, where, explain_failure(failure.kind));
  }

  static const char* explain_failure(MotionFailure::Kind kind) {
    switch (kind) {
      case MotionFailure::Kind::out_of_reach:
        return "the drivers ask for more than the joints permit, a loop is stretched or folded to its limit";
      case MotionFailure::Kind::lost_load:
        return "it has no finite value there (a formula outside its range, a spring whose points meet)";
      case MotionFailure::Kind::jammed:
        return "the joint jams: no force of the drivers overcomes its friction";
      case MotionFailure::Kind::singular:
        break;
    }
    return "a singular position, where two branches meet and the drivers do not say which way it goes on";
  }

  void find_dead_centres(std::size_t k) {
    const MotionProbe::Coordinate coordinate = coordinates_[k];
    const double nothing = kNothing * largest_rate_ * find_unit(coordinate);
    for (const SignChange& change : list_sign_changes(rates_[k], rates_[k].size(), nothing)) {
      const auto rate = [&] { return probe_.find_rate(coordinate); };
      if (!probe_.move_to_zero(rate, points_[change.before], points_[change.after].time)) continue;
      // Just beyond the end is the beginning of the next cycle.
      const double interval = plan_.cycle_time / (plan_.samples * looks_);
      if (probe_.find_time().time > record_.motion.end_time + 1e-6 * interval) continue;
      const bool is_body = coordinate.body >= 0;
      record_.dead_centres.push_back(
          {is_body ? mechanism().bodies[coordinate.body].name : mechanism().joints[coordinate.joint].name,
           is_body ? "rad" : "m", probe_.find_time(), probe_.find_value(coordinate), change.falls});
    }
  }

  /// Two points between which a quantity changes its sign.
  struct SignChange {
    std::size_t before;
    std::size_t after;
    bool falls;
  };

  // Of values that are more than nothing.
  static std::vector<SignChange> list_sign_changes(const std::vector<double>& values, std::size_t n, double nothing) {
    std::vector<SignChange> changes;
    std::size_t last = n;  // point of the last sign
    for (std::size_t i = 0; i < n; ++i) {
      if (std::abs(values[i]) <= nothing) continue;
      if (last < n && (values[i] > 0.0) != (values[last] > 0.0)) changes.push_back({last, i, values[last] > 0.0});
      last = i;
    }
    return changes;
  }

  // The extremes of the points looked at, and of the motion around them.
  void find_transmission(std::size_t f) {
    const LoopFold& fold = solver_.folds().folds()[f];
    if (points_.empty()) return;
    const auto values = std::span(transmissions_[f]).first(count_points());
    TransmissionRange range{find_joint_name(fold), solver_.folds().has_guide(fold), 0.0, {}, 0.0, {}};
    const auto [least, greatest] = std::ranges::minmax_element(values);
    move_to_extreme(fold, 1.0, static_cast<std::size_t>(least - values.begin()), values.size());
    range.least = probe_.find_transmission(fold), range.least_at = probe_.find_time();
    move_to_extreme(fold, -1.0, static_cast<std::size_t>(greatest - values.begin()), values.size());
    range.greatest = probe_.find_transmission(fold), range.greatest_at = probe_.find_time();
    record_.transmissions.push_back(std::move(range));
  }

  void move_to_extreme(const LoopFold& fold, double sign, std::size_t at, std::size_t n) {
    solver_.return_to(points_[at]);
    probe_.update();
    const double value = sign * probe_.find_transmission(fold);
    const std::size_t low = at > 0 ? at - 1 : 0;
    const std::size_t high = std::min(at + 1, n - 1);
    const bool found = low < high && probe_.move_to_least_transmission(fold, sign, points_[low], points_[high].time);
    // The point stays where nothing near it goes further: at an end, at a kink, on a plateau.
    if (found && sign * probe_.find_transmission(fold) < value) return;
    solver_.return_to(points_[at]);
    probe_.update();
  }

  // Where loops imply each other, one may pass its straight fold while the others lead it on: no branch ends there.
  void find_branch_changes(std::size_t f) {
    if (has_free_rows(solver_.system().tables)) return;
    const LoopFold& fold = solver_.folds().folds()[f];
    const auto side = [&] { return probe_.find_fold(fold); };
    if (points_.empty()) return;
    double peak = 0.0;
    for (const double value : folds_[f]) peak = std::max(peak, std::abs(value));
    for (const SignChange& change : list_sign_changes(folds_[f], count_points(), kNothing * peak)) {
      if (!probe_.move_to_zero(side, points_[change.before], points_[change.after].time)) continue;
      record_.branch_changes.push_back({find_joint_name(fold), probe_.find_time(), !change.falls});
    }
  }

  // Without the one beyond the end, which is no part of the motion asked for.
  [[nodiscard]] std::size_t count_points() const {
    const bool finished = record_.motion.status == StageStatus::finished;
    const bool beyond = finished && points_.back().time > record_.motion.end_time;
    return points_.size() - (beyond ? 1 : 0);
  }

  [[nodiscard]] const std::string& find_joint_name(const LoopFold& fold) const {
    return mechanism().joints[solver_.system().tables.closures[fold.closure].joint].name;
  }

  const KinematicPlan& plan_;
  int looks_;  // a sample
  KinematicRecord record_;
  KinematicSolver solver_;
  int driver_;
  MotionProbe probe_;
  KinematicChannels channels_;
  double length_;              // [m] characteristic
  double largest_rate_ = 0.0;  // [rad/s] of any coordinate or driver, displacements as shares of the length
  std::vector<MotionProbe::Coordinate> coordinates_;
  std::vector<MotionPoint> points_;                 // looked at: samples, points between them, and one beyond the end
  std::vector<std::vector<double>> rates_;          // one a coordinate and point
  std::vector<std::vector<double>> folds_;          // sines, one a fold and point
  std::vector<std::vector<double>> transmissions_;  // one a fold that is a dyad, and point
};

}  // namespace

KinematicRecord run_kinematics(const Mechanism& mechanism, const KinematicPlan& plan) {
  return CycleRun(mechanism, plan).run();
}

}  // namespace gudgeon
