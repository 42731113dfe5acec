// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What a driver may drive is what no constraint holds: its row is independent of all others.
#include "tests/random/random_drivers.h"

#include <cmath>
#include <utility>
#include <vector>

#include "tests/oracle/driver_motion.h"

namespace gudgeon::random {

namespace {

constexpr double kIndependent = 1e-6;  // of the largest row: nearer than that to a singular start nothing is tried

// Where there is play, without it.
bool can_move(const Mechanism& mechanism, const oracle::TextbookState& pose) {
  const oracle::TextbookRows rows = oracle::Textbook(make_ideal(mechanism)).eval_rows(pose, 0.0);
  const Eigen::MatrixXd all = rows.jacobian.rightCols(rows.jacobian.cols() - 3);  // without the frame's
  const auto find_rank = [](const Eigen::MatrixXd& matrix) {
    if (matrix.rows() == 0) return Eigen::Index{0};
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(matrix.transpose());
    factors.setThreshold(kIndependent);
    return factors.rank();
  };
  return find_rank(all) > find_rank(all.topRows(all.rows() - 1));
}

// Points of a wave at uneven times, from before the study to behind it; one of them at its start.
SampledCurve draw_points(Draw& draw, double start, double speed, double swing) {
  const double w = draw.between(3.0, 15.0);
  const double p = draw.angle();
  SampledCurve curve;
  for (const double t : {-0.02, 0.0, 0.017, 0.03, 0.052, 0.064, 0.085, 0.1, 0.12}) {
    curve.arguments.push_back(t == 0.0 ? 0.0 : t + draw.between(-5e-3, 5e-3));
    const double at = curve.arguments.back();
    curve.values.push_back(start + speed * at + swing * (std::sin(w * at + p) - std::sin(p)));
  }
  return curve;
}

void choose_motion(Driver& driver, double start, double speed, double swing, Draw& draw) {
  driver.start = start;
  driver.speed = speed;
  const int kind = draw.below(3);
  if (kind == 0) return;
  driver.start = driver.speed = 0.0;
  if (kind == 1) {
    driver.motion = draw_points(draw, start, speed, swing);
    return;
  }
  const double w = draw.between(3.0, 15.0);
  const double p = draw.angle();
  driver.motion = oracle::make_wave({start - swing * std::sin(p), draw.between(-1.0, 1.0) * speed, swing, w, p});
}

// Against the first body of a pin, along the line of a guide.
Driver draw_driver(const Mechanism& mechanism, const Joint& joint, const oracle::TextbookState& pose, Draw& draw) {
  Driver driver{"motor", DrivenSlide{joint.name}};
  if (const auto* slide = std::get_if<Prismatic>(&joint.kind)) {
    choose_motion(driver, *slide->start.displacement, draw.between(0.2, 1.0), draw.between(0.01, 0.04), draw);
    return driver;
  }
  const auto& pin = std::get<Revolute>(joint.kind);
  driver.target = DrivenAngle{pin.second.body, pin.first.body};
  const auto angle = [&](const std::string& body) {
    return pose.bodies[static_cast<std::size_t>(find_body(mechanism, body))].angle;
  };
  choose_motion(driver, angle(pin.second.body) - angle(pin.first.body), draw.between(1.0, 6.0), draw.between(0.05, 0.3),
                draw);
  return driver;
}

// A start value beside the driver's would only repeat it.
void leave_start_to_driver(Mechanism& mechanism, Joint& joint) {
  if (auto* slide = std::get_if<Prismatic>(&joint.kind)) {
    slide->start.displacement.reset();
    slide->start.speed.reset();
    return;
  }
  const auto& pin = std::get<Revolute>(joint.kind);
  Body& driven = mechanism.bodies[static_cast<std::size_t>(find_body(mechanism, pin.second.body))];
  driven.start.angle.reset();
  driven.start.angle_rate.reset();
}

}  // namespace

bool add_driver(Mechanism& mechanism, const oracle::TextbookState& pose, Draw& draw) {
  std::vector<std::size_t> candidates;
  for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
    const AnyJoint& kind = mechanism.joints[j].kind;
    const auto* slide = std::get_if<Prismatic>(&kind);
    if (std::holds_alternative<Revolute>(kind) || (slide != nullptr && slide->start.displacement)) {
      candidates.push_back(j);
    }
  }
  const int shift = draw.below(static_cast<int>(candidates.size()) + 1);
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    Joint& joint = mechanism.joints[candidates[(k + static_cast<std::size_t>(shift)) % candidates.size()]];
    mechanism.drivers.push_back(draw_driver(mechanism, joint, pose, draw));
    const bool moves = can_move(mechanism, pose);
    if (moves || k + 1 == candidates.size()) {
      leave_start_to_driver(mechanism, joint);
      return moves;
    }
    mechanism.drivers.pop_back();
  }
  return true;
}

}  // namespace gudgeon::random
