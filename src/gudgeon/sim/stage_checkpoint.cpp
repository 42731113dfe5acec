// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A stage taken out between two steps, and put back.
#include <utility>

#include "gudgeon/base/state_archive.h"
#include "gudgeon/sim/stage_run.h"

namespace gudgeon {

namespace {

// A checksum of what the surfaces of all contacts look like.
std::uint32_t find_surface_checksum(const Tables& tables) {
  const auto add = [](std::uint32_t sum, const std::vector<double>& depths) {
    const std::string_view bytes(reinterpret_cast<const char*>(depths.data()), depths.size() * sizeof(double));
    return 31 * sum + find_checksum(bytes);
  };
  std::uint32_t sum = 0;
  for (const Contact& contact : tables.contacts) {
    std::visit(
        [&](const auto& surfaces) {
          sum = add(sum, surfaces.bearing_wear.cell_depths());
          sum = add(sum, surfaces.journal_wear.cell_depths());
        },
        contact.surfaces);
    sum = add(sum, {contact.sliding_distance});
  }
  return sum;
}

}  // namespace

void StageRun::save(std::atomic<bool>* wanted, std::function<void(Checkpoint)> take) {
  checkpoint_wanted_ = wanted;
  take_checkpoint_ = std::move(take);
}

void StageRun::resume(const Checkpoint& checkpoint) {
  StateArchive archive(checkpoint.state);
  transfer(archive);
  archive.expect_end();
  if (recorder_.n_handed_over() != checkpoint.n_samples_handed_over) StateArchive::refuse();
  is_resumed_ = true;
}

// Where the motion can be saved; one that cannot yet is saved later.
void StageRun::take_checkpoint() {
  if (!take_checkpoint_ || !motion_.can_be_saved() || (!is_sampled_ && !motion_.saves_last_step())) return;
  if (checkpoint_wanted_ != nullptr) checkpoint_wanted_->store(false, std::memory_order_relaxed);
  std::string state = StateArchive::pack([&](StateArchive& archive) { transfer(archive); });
  take_checkpoint_({record_.name, motion_.time(), recorder_.n_handed_over(), std::move(state)});
}

void StageRun::transfer(StateArchive& archive) {
  // What it belongs to.
  archive.require_text(record_.name);
  archive.require(record_.cycle_time);
  archive.require(warm_up_end_);
  archive.require(end_);
  archive.require(n_all_samples_);
  archive.require(recorder_.channels().size());
  archive.require(find_surface_checksum(system_.tables));
  // What it is.
  double wall_time = archive.is_loading() ? 0.0 : find_wall_time();
  archive(wall_time, motion_, recorder_, history_, peaks_, wear_);
  scratch_.fit(system_.tables);
  archive(scratch_, pace_, reach_, n_samples_, initial_energies_);
  earlier_wall_time_ = archive.is_loading() ? wall_time : earlier_wall_time_;
}

}  // namespace gudgeon
