// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Snapshots of states, read channel by channel.
#include "gudgeon/sim/stage_recorder.h"

#include <algorithm>
#include <utility>

namespace gudgeon {

namespace {

constexpr std::size_t kLargestBlock = 96u << 20;  // [bytes] each block of a channel costs as much as its first
constexpr std::size_t kFewestSamples = 256;       // fewer would be mostly the disk's and compression's overhead

std::vector<std::string> select_names(const std::vector<RecordedChannel>& table, bool watched) {
  std::vector<std::string> names;
  for (const RecordedChannel& entry : table) {
    if (entry.watched == watched) names.push_back(entry.channel.name);
  }
  return names;
}

}  // namespace

StageRecorder::StageRecorder(const System& system)
    : system_(&system),
      motion_(system),
      reaction_(system),
      table_(make_channel_table(system)),
      penetrations_(system.tables.contacts.size()),
      values_(table_.size()),
      step_statistics_(select_names(table_, true)),
      sample_statistics_(select_names(table_, false)) {
  for (std::size_t k = 0; k < table_.size(); ++k) {
    channels_.push_back(table_[k].channel);
    if (table_[k].watched) watched_.push_back(k);
  }
  const std::size_t n_groups = system.tables.contact_groups.size();
  for (std::size_t g = 0; g < n_groups; ++g) readers_.emplace_back(system, g);
  snapshot_.clearances.resize(n_groups);
  watched_row_.resize(watched_.size());
  sampled_row_.resize(table_.size() - watched_.size());
}

void StageRecorder::stream(std::size_t block_size, std::function<void(const SampleBlock&)> take) {
  block_size_ = std::min(block_size, std::max(kFewestSamples, kLargestBlock / (sizeof(double) * table_.size())));
  take_ = std::move(take);
}

void StageRecorder::reserve(std::size_t n_samples) {
  if (block_size_ > 0) n_samples = std::min(n_samples, block_size_);
  time_.reserve(n_samples);
  for (std::vector<double>& values : values_) values.reserve(n_samples);
}

void StageRecorder::hand_over() {
  take_({"", channels_, time_, values_});
  n_handed_over_ += static_cast<std::int64_t>(time_.size());
  time_.clear();
  for (std::vector<double>& values : values_) values.clear();
}

StageRecorder::Energies StageRecorder::find_energies(const Workspace& workspace) {
  motion_.update(workspace);
  return {find_kinetic_energy(system_->mechanism, motion_.motions()), find_potential_energy(system_->tables, workspace),
          find_elastic_energy(workspace)};
}

void StageRecorder::sample(double time, Workspace& workspace, std::span<const ContactMode> contact_modes,
                           double initial_energy, const double* integrals) {
  find_penetrations(workspace);
  motion_.update(workspace);
  reaction_.update(workspace, motion_.motions());
  for (std::size_t g = 0; g < readers_.size(); ++g) {
    readers_[g].read_motion(workspace, motion_.motions(), snapshot_.clearances[g]);
  }
  read_clearances(workspace);
  const Energies energies = find_energies(workspace);
  snapshot_.kinetic = energies.kinetic;
  snapshot_.potential = energies.potential;
  snapshot_.elastic = energies.elastic;
  snapshot_.initial_energy = initial_energy;
  snapshot_.contact_modes = contact_modes;
  snapshot_.reactions = &reaction_.reactions();
  snapshot_.integrals = integrals;

  time_.push_back(time);
  std::size_t n_sampled = 0;
  for (std::size_t k = 0; k < table_.size(); ++k) {
    const double value = table_[k].read(snapshot_);
    values_[k].push_back(value);
    if (!table_[k].watched) sampled_row_[n_sampled++] = value;
  }
  sample_statistics_.update(time, sampled_row_);
  if (time_.size() == block_size_) hand_over();
}

void StageRecorder::watch(double time, const Workspace& workspace, std::span<const GapState> gaps) {
  for (std::size_t k = 0; k < gaps.size(); ++k) penetrations_[k] = gaps[k].penetration;
  read_watched(workspace);
  step_statistics_.update(time, watched_row_);
}

void StageRecorder::watch(double time, Workspace& workspace) {
  find_penetrations(workspace);
  read_watched(workspace);
  step_statistics_.update(time, watched_row_);
}

void StageRecorder::watch_between(double time, Workspace& workspace) {
  find_penetrations(workspace);
  read_watched(workspace);
  step_statistics_.note_extremes(time, watched_row_);
}

void StageRecorder::find_penetrations(Workspace& workspace) {
  update_point_motions(system_->tables, workspace);
  for (std::size_t k = 0; k < penetrations_.size(); ++k) {
    const Contact& contact = system_->tables.contacts[k];
    penetrations_[k] = find_gap(contact.surfaces, find_contact_motion(contact, workspace)).penetration;
  }
}

void StageRecorder::read_watched(const Workspace& workspace) {
  motion_.update(workspace);
  read_clearances(workspace);
  for (std::size_t k = 0; k < watched_.size(); ++k) watched_row_[k] = table_[watched_[k]].read(snapshot_);
}

void StageRecorder::read_clearances(const Workspace& workspace) {
  snapshot_.workspace = &workspace;
  snapshot_.motions = &motion_.motions();
  for (std::size_t g = 0; g < readers_.size(); ++g) {
    readers_[g].read_forces(workspace, penetrations_, snapshot_.clearances[g]);
  }
}

void StageRecorder::transfer(StateArchive& archive) {
  archive(n_handed_over_, snapshot_.clearances, penetrations_, watched_row_, sampled_row_);
  archive(step_statistics_, sample_statistics_);
  archive.list(time_);
  for (std::vector<double>& values : values_) archive.list(values);
}

void StageRecorder::finish(StageRecord& stage) {
  stage.channels = channels_;
  stage.time = std::move(time_);
  stage.values = std::move(values_);
  // Back into the order of the channels.
  const auto watched = step_statistics_.summarize();
  const auto sampled = sample_statistics_.summarize();
  std::size_t next_watched = 0;
  std::size_t next_sampled = 0;
  for (const RecordedChannel& entry : table_) {
    stage.statistics.push_back(entry.watched ? watched[next_watched++] : sampled[next_sampled++]);
  }
}

}  // namespace gudgeon
