// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The methods.
#include <cmath>
#include <limits>
#include <memory>

#include "bench/cpu_clock.h"
#include "bench/hand_written/slider_crank.h"
#include "bench/integrators/bdf_run.h"
#include "bench/integrators/pair_run.h"
#include "bench/run_cases.h"
#include "gudgeon/sim/motion_integrator.h"
#include "tests/oracle/same_state.h"

namespace gudgeon::bench {

namespace {

constexpr double kLongestStepShare = 0.02;         // of a cycle, the engine's own
constexpr Feedback kStrongFeedback{100.0, 100.0};  // [1/s] gaps fade within a few hundredths of a second

// Relative and absolute tolerance in the ratio that a study has them by default.
Study make_study(double tolerance) {
  Study study;
  study.relative_tolerance = tolerance;
  study.absolute_tolerance = 0.01 * tolerance;
  return study;
}

// Advances any run from milestone to milestone; look() reads it there.
template <class Advance, class Look>
void run_to_end(double horizon, Outcome& outcome, Advance&& advance, Look&& look) {
  const double start = read_cpu_clock();
  for (int k = 1; k <= kMilestones; ++k) {
    if (!advance(horizon * k / kMilestones)) return;
    look();
  }
  outcome.seconds = read_cpu_clock() - start;
  outcome.finished = true;
}

void note_residual(Outcome& outcome, double residual) {
  outcome.residual = std::max(outcome.residual.value_or(0.0), std::abs(residual));
}

Outcome run_engine(const RunCase& at, Integrator integrator, Stabilization stabilization, double tolerance,
                   double horizon) {
  const Assembly assembly = assemble(at.mechanism);
  const System system = compile(at.mechanism, assembly);
  Study study = make_study(tolerance);
  study.integrator = integrator;
  study.stabilization = stabilization;
  MotionIntegrator motion(system, study, at.cycle_time);
  Outcome outcome;
  if (!motion.begin(make_state(system, assembly))) return outcome;
  run_to_end(
      horizon, outcome,
      [&](double milestone) {
        while (motion.time() < milestone) {
          if (!motion.advance(milestone)) return false;
        }
        return true;
      },
      [&] {
        motion.evaluate_again();
        note_residual(outcome, motion.equations().find_residual(motion.y().data()));
        const auto poses = find_poses(system.mechanism, system.topology, motion.equations().workspace.coordinates);
        for (const Probe& probe : at.probes) {
          const int body = find_body(at.mechanism, probe.body);
          const Vec2 center = poses[body].find_point(at.mechanism.bodies[body].center_of_mass);
          outcome.samples.push_back(probe.component == 0   ? center.x
                                    : probe.component == 1 ? center.y
                                                           : poses[body].angle);
        }
      });
  outcome.evaluations = static_cast<long>(motion.statistics().evaluations);
  return outcome;
}

template <template <class> class Run>
Outcome run_textbook(const RunCase& at, textbook::SaddleSolver::Kind kind, double tolerance, double horizon) {
  using textbook::MaximalForm;
  MaximalForm form(at.mechanism, kStrongFeedback, kind);
  const std::vector<double> start = form.make_state(assemble(at.mechanism).poses);
  Run<MaximalForm> run(form, make_study(tolerance), kLongestStepShare * at.cycle_time);
  Outcome outcome;
  run.begin(start);
  const double energy = form.find_energy(0.0, start.data());
  run_to_end(
      horizon, outcome, [&](double milestone) { return run.advance_to(milestone); },
      [&] {
        const double* y = run.y().data();
        note_residual(outcome, form.find_energy(run.time(), y) - energy - y[form.n_states()]);
        for (const Probe& probe : at.probes) {
          outcome.samples.push_back(y[3 * (find_body(at.mechanism, probe.body) - 1) + probe.component]);
        }
      });
  outcome.evaluations = run.evaluations();
  return outcome;
}

Outcome run_hand_written(const RunCase& at, double friction, double tolerance, double horizon) {
  hand_written::SliderCrank equations(friction);
  PairRun<hand_written::SliderCrank> run(equations, make_study(tolerance), kLongestStepShare * at.cycle_time);
  const auto poses = assemble(at.mechanism).poses;
  const BodyPose& rod = poses[find_body(at.mechanism, "rod")];
  const BodyPose& slider = poses[find_body(at.mechanism, "slider")];
  Outcome outcome;
  run.begin({rod.angle, slider.position.x, rod.angle_rate, slider.velocity.x});
  run_to_end(
      horizon, outcome, [&](double milestone) { return run.advance_to(milestone); },
      [&] {
        outcome.samples.insert(outcome.samples.end(), {run.y()[0], run.y()[1]});
      });
  outcome.evaluations = run.evaluations();
  return outcome;
}

}  // namespace

std::vector<Method> make_methods(const RunCase& at) {
  const auto engine = [&](Integrator integrator, Stabilization stabilization) {
    return [at, integrator, stabilization](double tolerance, double horizon) {
      return run_engine(at, integrator, stabilization, tolerance, horizon);
    };
  };
  std::vector<Method> methods{{"gudgeon", engine(Integrator::automatic, Stabilization::projection)}};
  const std::size_t n_bodies = at.mechanism.bodies.size();
  constexpr std::size_t kMostForDense = 25;  // bodies; beyond them one evaluation takes too long
  if (n_bodies <= kMostForDense) {
    methods.push_back({"gudgeon_stiff", engine(Integrator::stiff, Stabilization::projection)});
  }

  using Kind = textbook::SaddleSolver::Kind;
  if (n_bodies <= kMostForDense) {
    methods.push_back({"textbook_pair", [at](double tolerance, double horizon) {
                         return run_textbook<PairRun>(at, Kind::dense, tolerance, horizon);
                       }});
    methods.push_back({"textbook_cvode", [at](double tolerance, double horizon) {
                         return run_textbook<BdfRun>(at, Kind::dense, tolerance, horizon);
                       }});
  }
  if (at.name.starts_with("n_four_bar")) {
    methods.push_back({"sparse_pair", [at](double tolerance, double horizon) {
                         return run_textbook<PairRun>(at, Kind::sparse, tolerance, horizon);
                       }});
  }
  if (at.name.starts_with("slider_crank")) {
    const double friction = at.name.ends_with("friction") ? 0.1 : 0.0;
    methods.push_back({"hand_written_pair", [at, friction](double tolerance, double horizon) {
                         return run_hand_written(at, friction, tolerance, horizon);
                       }});
  }
  return methods;
}

double find_error(const Outcome& outcome, const Outcome& reference) {
  if (!outcome.finished || outcome.samples.size() != reference.samples.size()) {
    return std::numeric_limits<double>::infinity();
  }
  double error = 0.0;
  for (std::size_t k = 0; k < outcome.samples.size(); ++k) {
    error = std::max(error, std::abs(outcome.samples[k] - reference.samples[k]));
  }
  return std::isfinite(error) ? error : std::numeric_limits<double>::infinity();
}

}  // namespace gudgeon::bench
