// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One stage from the groups of a run file. Under an Hdf5Session.
#pragma once

#include <string>

#include "gudgeon/io/hdf5_handle.h"
#include "gudgeon/io/stage_channels.h"
#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// The stage without time and values.
StageRecord read_stage_outline(const Hdf5Handle& stages, const std::string& name);

/// The samples of one stage; its groups are opened once.
class StageSamples {
 public:
  StageSamples(const Hdf5Handle& stages, const std::string& name);

  void read_time(StageRecord& stage) const;
  /// Of channel k.
  void read_values(StageRecord& stage, std::size_t k) const;

 private:
  Hdf5Handle stage_;
  ChannelReader channels_;
};

}  // namespace gudgeon
