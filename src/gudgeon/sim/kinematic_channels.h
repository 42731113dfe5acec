// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The channels of a kinematic analysis: those of a run, and motions of guides, values of drivers, transmission angles.
#pragma once

#include "gudgeon/sim/motion_probe.h"
#include "gudgeon/sim/stage_recorder.h"

namespace gudgeon {

/// "JOINT.pressure_angle" where a guide is part of the loop, else "JOINT.transmission_angle".
std::string name_transmission(const KinematicSolver& solver, const LoopFold& fold);

class KinematicChannels {
 public:
  /// Keeps references to both.
  KinematicChannels(KinematicSolver& solver, MotionProbe& probe);

  /// Appends one sample of the solver's point, which the probe has taken over.
  void sample();
  /// Moves what was recorded into the stage, with statistics of the samples.
  void finish(StageRecord& stage);

 private:
  KinematicSolver* solver_;
  MotionProbe* probe_;
  StageRecorder recorder_;
  std::vector<Channel> channels_;            // beside the recorder's
  std::vector<std::vector<double>> values_;  // one a channel
};

}  // namespace gudgeon
