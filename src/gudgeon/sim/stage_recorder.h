// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The channels of a stage: what is sampled at even times, and whose peaks are watched at every step.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "gudgeon/base/state_archive.h"
#include "gudgeon/results/sample_block.h"
#include "gudgeon/results/statistics.h"
#include "gudgeon/sim/channel_table.h"

namespace gudgeon {

/// Samples of a block: enough that compression does not notice its ends, some 20 MB of a hundred channels.
inline constexpr std::size_t kSamplesPerBlock = 16384;

class StageRecorder {
 public:
  /// Keeps a reference.
  explicit StageRecorder(const System& system);
  explicit StageRecorder(const System&&) = delete;

  [[nodiscard]] const std::vector<Channel>& channels() const { return channels_; }

  /// Energies at the state the workspace was last evaluated for.
  struct Energies {
    double kinetic = 0.0;
    double potential = 0.0;
    double elastic = 0.0;
    [[nodiscard]] double total() const { return kinetic + potential + elastic; }
  };
  Energies find_energies(const Workspace& workspace);

  /// Hands over every so many samples as soon as they are there, instead of keeping them until the end; fewer where a
  /// block would take more than some 100 MB. Nothing is allocated between two blocks.
  void stream(std::size_t block_size, std::function<void(const SampleBlock&)> take);

  /// Makes room for so many samples.
  void reserve(std::size_t n_samples);
  /// Appends one sample of all channels; initial_energy [J] is that of the stage's start, integrals those carried
  /// along.
  void sample(double time, Workspace& workspace, std::span<const ContactMode> contact_modes, double initial_energy,
              const double* integrals);
  /// Takes one accepted step into the statistics of contacts, efforts and accelerations.
  void watch(double time, const Workspace& workspace, std::span<const GapState> gaps);
  /// The same of a state whose gaps are not known.
  void watch(double time, Workspace& workspace);
  /// Takes a state between two steps into their extremes.
  void watch_between(double time, Workspace& workspace);
  /// The values last watched, one a channel that is.
  [[nodiscard]] const std::vector<double>& watched_row() const { return watched_row_; }

  /// How many samples were handed over.
  [[nodiscard]] std::int64_t n_handed_over() const { return n_handed_over_; }
  /// With the samples that were not handed over.
  void transfer(StateArchive& archive);

  /// Moves what was recorded, and not handed over, into the stage.
  void finish(StageRecord& stage);

 private:
  void find_penetrations(Workspace& workspace);
  void read_watched(const Workspace& workspace);
  void read_clearances(const Workspace& workspace);
  void hand_over();

  const System* system_;
  BodyMotionFinder motion_;
  ReactionFinder reaction_;
  std::vector<RecordedChannel> table_;
  std::vector<Channel> channels_;
  std::vector<ClearanceReader> readers_;  // one a clearance joint
  Snapshot snapshot_;
  std::vector<double> penetrations_;  // one a contact
  std::vector<std::size_t> watched_;  // channels whose statistics are taken at every step
  std::vector<double> watched_row_;
  std::vector<double> sampled_row_;
  std::vector<double> time_;
  std::vector<std::vector<double>> values_;
  std::int64_t n_handed_over_ = 0;
  std::size_t block_size_ = 0;  // 0: all is kept
  std::function<void(const SampleBlock&)> take_;
  StatisticsAccumulator step_statistics_;
  StatisticsAccumulator sample_statistics_;
};

}  // namespace gudgeon
