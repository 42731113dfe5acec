// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Channels of a stage in a run file: a group for each body, joint or load, with what is recorded of it and the time.
// Under an Hdf5Session.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "gudgeon/io/hdf5_handle.h"
#include "gudgeon/results/channel.h"
#include "gudgeon/results/sample_block.h"

namespace gudgeon {

/// All samples at once, in the stage's group.
void write_channels(const Hdf5Handle& stage, const SampleBlock& samples);
/// Channels that grow by blocks, this one the first.
void begin_channels(const Hdf5Handle& stage, const SampleBlock& block);
void extend_channels(const Hdf5Handle& stage, const SampleBlock& block);
/// Forgets all samples but the first ones; FileError when there are fewer.
void cut_channels(const Hdf5Handle& stage, std::size_t n_samples);

/// In the order of their groups; of format 1, as they were recorded.
std::vector<Channel> read_channel_list(const Hdf5Handle& stage);
std::vector<double> read_times(const Hdf5Handle& stage);

/// Reads channels of one stage; those of one owner in a row open its group once.
class ChannelReader {
 public:
  explicit ChannelReader(const Hdf5Handle& stage);
  std::vector<double> read(const std::string& name) const;

 private:
  Hdf5Handle channels_;
  mutable std::string owner_name_;
  mutable std::optional<Hdf5Handle> owner_;
};

}  // namespace gudgeon
