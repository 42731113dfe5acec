// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What is said of a stage that a load, or steps without end, do not let go on, or that they make costly.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gudgeon/sim/jammed_joint.h"
#include "gudgeon/sim/stage_run.h"
#include "gudgeon/system/body_motion.h"
#include "gudgeon/system/start_check.h"

namespace gudgeon {

// Why a step could not be taken.
void StageRun::fail_step() {
  if (!motion_.stall()) {
    if (!fail_at_law_end() && !fail_jammed())
      fail("E-NUM-003", fmt::format("step below {:.2g} s", motion_.find_smallest_step()));
    return;
  }
  constexpr std::size_t kFew = 4;
  const auto& places = motion_.stall()->places;
  std::string listed;
  for (std::size_t k = 0; k < std::min(places.size(), kFew); ++k) {
    const char* before = k == 0 ? "" : k + 1 == places.size() ? " and " : ", ";
    listed += fmt::format("{}{} at \"{}\"", before, places[k].owner, places[k].text);
  }
  if (places.size() > kFew) listed += fmt::format(" and {} more", places.size() - kFew);
  stop("E-NUM-006",
       fmt::format(
           "{} {} back and forth: on each side the mechanism is pushed to "
           "the other one, and no force between both holds it; let the load change gradually there, or give joints the "
           "friction that is meant{}",
           listed, places.size() == 1 ? "jumps" : "jump",
           places.size() == 1 ? "" : "; jumps at different places need a formula each"));
}

// Friction that grows without bound, or begins to, is told as such.
bool StageRun::fail_jammed() {
  const int joint = find_jammed_joint(motion_.time(), motion_.find_smallest_step(), motion_.y(), motion_.equations());
  if (joint < 0) return false;
  stop("E-NUM-013", fmt::format("joint '{}' jams: no acceleration, or more than one, agrees with its friction; {}",
                                system_.mechanism.joints[joint].name, kJamAdvice));
  return true;
}

// What a mechanism does that goes on in ever shorter steps.
void StageRun::stop_without_end() {
  motion_.evaluate_again();
  const Workspace& workspace = motion_.equations().workspace;
  BodyMotionFinder finder(system_);
  finder.update(workspace);
  std::string cause;
  const auto& effects = workspace.loads.effects;
  const auto size = [](const LoadEffect& effect) { return std::max(norm(effect.force), std::abs(effect.torque)); };
  if (const auto largest = std::ranges::max_element(effects, {}, size);
      largest != effects.end() && size(*largest) > 0) {
    cause +=
        fmt::format("; largest load: '{}', {:.3g} N or N m",
                    system_.mechanism.loads[static_cast<std::size_t>(largest - effects.begin())].name, size(*largest));
  }
  const auto& motions = finder.motions();
  const auto speed = [](const BodyMotion& motion) {
    return std::max(norm(motion.velocity), std::abs(motion.angle_rate));
  };
  if (const auto fastest = std::ranges::max_element(motions, {}, speed); fastest != motions.end()) {
    cause += fmt::format("; fastest body: '{}', {:.3g} m/s and {:.3g} rad/s",
                         system_.mechanism.bodies[static_cast<std::size_t>(fastest - motions.begin())].name,
                         norm(fastest->velocity), fastest->angle_rate);
  }
  if (const std::int64_t changes = motion_.n_piece_changes(); changes > motion_.statistics().accepted_steps / 10) {
    cause += fmt::format("; formulas and curves of loads changed their piece {} times", changes);
  }
  stop("E-NUM-008", fmt::format("at this pace the run would not end: the last {} evaluations, in "
                                "steps of {:.2g} s, brought the motion on by {:.2g} s, and a cycle is {:.4g} s{}; look "
                                "at what makes it so fast: "
                                "a load that grows without bound, a stiffness too large for its mass",
                                RunPace::kWindow, pace_.last_step(), pace_.last_advance(), record_.cycle_time, cause));
}

// Why a stage that did finish took as long as it did.
std::string StageRun::explain_cost() const {
  constexpr double kMany = 1e6;  // evaluations a cycle: ten times what the costliest of usual mechanisms take
  const SolverStatistics& solver = record_.solver;
  const double per_cycle = static_cast<double>(solver.evaluations) / (record_.end_time / record_.cycle_time);
  if (!(per_cycle > kMany)) return "";
  const FastestRates& rates = motion_.rates();
  std::string text = fmt::format("{:.2g} evaluations a cycle, in steps of {:.2g} s", per_cycle,
                                 record_.end_time / static_cast<double>(solver.accepted_steps));
  const bool by_contact = rates.in_contact() > rates.in_flight();
  if (const double fastest = std::max(rates.in_contact(), rates.in_flight()); fastest > 0.0) {
    text += fmt::format(": what moves fastest has a rate of {:.2g} 1/s", fastest);
  }
  const auto longest = std::ranges::max_element(record_.wear, {}, &JointWear::contact_time);
  if (by_contact && longest != record_.wear.end()) {
    text += fmt::format(
        " while contacts press, {:.2g} 1/s while none does; joint '{}' presses for {:.0f} % of the time: the bodies it "
        "moves are light for its stiffness, look at their masses and inertias",
        rates.in_flight(), longest->joint, 100.0 * longest->contact_time / (record_.end_time - record_.start_time));
  }
  if (study_.integrator == Integrator::explicit_pair) {
    text += "; integrator = \"explicit\" cannot step over such rates, \"automatic\" may";
  }
  return text;
}

}  // namespace gudgeon
