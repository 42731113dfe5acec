// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// "A.normal_force" is the dataset normal_force of the group A. Small groups are found quickly, and each has what a
// table of its own needs.
#include "gudgeon/io/stage_channels.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/hdf5_dataset.h"
#include "gudgeon/io/hdf5_node.h"

namespace gudgeon {

namespace {

const std::string kChannels = "channels";
const std::string kTime = "time";

/// Where a channel lies; one without a point in its name beside the groups.
struct Place {
  std::string owner;
  std::string quantity;
};

Place find_place(const std::string& name) {
  const std::size_t point = name.find('.');
  if (point == std::string::npos) return {"", name};
  return {name.substr(0, point), name.substr(point + 1)};
}

void check_size(const SampleBlock& block) {
  if (block.values.size() != block.channels.size()) {
    throw FileError(fmt::format("stage has {} channels but values of {}", block.channels.size(), block.values.size()));
  }
  for (std::size_t k = 0; k < block.values.size(); ++k) {
    if (block.values[k].size() == block.time.size()) continue;
    throw FileError(fmt::format("channel '{}' has {} samples where time has {}", block.channels[k].name,
                                block.values[k].size(), block.time.size()));
  }
}

/// Groups of the owners, each opened once.
class OwnerGroups {
 public:
  explicit OwnerGroups(const Hdf5Handle& channels) : channels_(channels) {}

  const Hdf5Handle& open(const std::string& owner) { return find(owner, open_group); }
  /// Made when it is not there yet, with the time in it, too.
  const Hdf5Handle& make(const std::string& owner) {
    return find(owner, [](const Hdf5Handle& channels, const std::string& name) {
      Hdf5Handle group = make_group(channels, name, 16, 16);
      make_hard_link(channels, kTime, group);
      return group;
    });
  }

 private:
  template <class Make>
  const Hdf5Handle& find(const std::string& owner, Make make_it) {
    if (owner.empty()) return channels_;
    const auto known = groups_.find(owner);
    return known != groups_.end() ? known->second : groups_.emplace(owner, make_it(channels_, owner)).first->second;
  }

  const Hdf5Handle& channels_;
  std::map<std::string, Hdf5Handle> groups_;
};

void write_description(const Hdf5Handle& dataset, const std::string& description, TextAttributes& attributes) {
  attributes.write(dataset, "description", description);
  attributes.write(dataset, "long_name", description);
}

/// With room for all of its members at once: HDF5 adds more by going through those that are there.
Hdf5Handle make_channel_group(const Hdf5Handle& stage, const SampleBlock& block) {
  std::set<std::string> members{kTime};
  std::size_t longest = 0;
  for (const Channel& channel : block.channels) {
    const Place place = find_place(channel.name);
    const auto member = members.insert(place.owner.empty() ? place.quantity : place.owner).first;
    longest = std::max(longest, member->size());
  }
  return make_group(stage, kChannels, static_cast<unsigned>(members.size()), static_cast<unsigned>(longest));
}

/// time and channels.
void make_channels(const Hdf5Handle& stage, const SampleBlock& block, const SeriesMaker& series) {
  check_size(block);
  TextAttributes attributes;
  const Hdf5Handle channels = make_channel_group(stage, block);
  {
    const Hdf5Handle time = series.make(channels, kTime, block.time);
    write_unit(time, "s", attributes);
    write_description(time, "time of each recorded sample", attributes);
    make_scale(time, kTime);
  }
  const ScaleReference scale(channels, kTime);
  OwnerGroups owners(channels);
  for (std::size_t k = 0; k < block.channels.size(); ++k) {
    const Channel& channel = block.channels[k];
    const Place place = find_place(channel.name);
    const Hdf5Handle dataset = series.make(owners.make(place.owner), place.quantity, block.values[k]);
    write_unit(dataset, channel.unit, attributes);
    attributes.write(dataset, "symbol", channel.symbol);
    write_description(dataset, channel.description, attributes);
    scale.attach_to(dataset);
  }
}

Channel read_description(const Hdf5Handle& group, const std::string& member, const std::string& name) {
  const Hdf5Handle dataset = open_dataset(group, member);
  // Channels without a dimension have no unit.
  return {name, read_text_attribute(dataset, "symbol"),
          has_attribute(dataset, "unit") ? read_text_attribute(dataset, "unit") : std::string(),
          read_text_attribute(dataset, "description")};
}

/// Calls visit(group, name in it, name of the channel).
template <class Visit>
void for_each_channel(const Hdf5Handle& channels, Visit visit) {
  for (const std::string& owner : find_children(channels)) {
    if (owner == kTime) continue;
    if (!is_group(channels, owner)) {
      visit(channels, owner, owner);
      continue;
    }
    const Hdf5Handle group = open_group(channels, owner);
    for (const std::string& quantity : find_children(group)) {
      if (quantity != kTime) visit(group, quantity, owner + "." + quantity);
    }
  }
}

}  // namespace

void write_channels(const Hdf5Handle& stage, const SampleBlock& samples) {
  make_channels(stage, samples, SeriesMaker(samples.time.size()));
}

void begin_channels(const Hdf5Handle& stage, const SampleBlock& block) {
  make_channels(stage, block, SeriesMaker::growing(block.time.size()));
  extend_channels(stage, block);
}

void extend_channels(const Hdf5Handle& stage, const SampleBlock& block) {
  check_size(block);
  const Hdf5Handle channels = open_group(stage, kChannels);
  extend_series(channels, kTime, block.time);
  OwnerGroups owners(channels);
  for (std::size_t k = 0; k < block.channels.size(); ++k) {
    const Place place = find_place(block.channels[k].name);
    extend_series(owners.open(place.owner), place.quantity, block.values[k]);
  }
}

void cut_channels(const Hdf5Handle& stage, std::size_t n_samples) {
  const Hdf5Handle channels = open_group(stage, kChannels);
  cut_series(channels, kTime, n_samples);
  for_each_channel(channels, [&](const Hdf5Handle& group, const std::string& member, const std::string&) {
    cut_series(group, member, n_samples);
  });
}

std::vector<Channel> read_channel_list(const Hdf5Handle& stage) {
  std::vector<Channel> list;
  for_each_channel(open_group(stage, kChannels),
                   [&](const Hdf5Handle& group, const std::string& member, const std::string& name) {
                     list.push_back(read_description(group, member, name));
                   });
  return list;
}

std::vector<double> read_times(const Hdf5Handle& stage) {
  // Format 1 has it beside the channels.
  return has_link(stage, kTime) ? read_series(stage, kTime) : read_series(open_group(stage, kChannels), kTime);
}

ChannelReader::ChannelReader(const Hdf5Handle& stage) : channels_(open_group(stage, kChannels)) {}

std::vector<double> ChannelReader::read(const std::string& name) const {
  const Place place = find_place(name);
  // Format 1 has no groups.
  if (place.owner.empty() || has_link(channels_, name)) return read_series(channels_, name);
  if (place.owner != owner_name_) {
    owner_ = open_group(channels_, place.owner);
    owner_name_ = place.owner;
  }
  return read_series(*owner_, place.quantity);
}

}  // namespace gudgeon
