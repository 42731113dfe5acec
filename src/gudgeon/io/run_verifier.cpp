// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// From group to group, then as a run.
#include "gudgeon/io/run_verifier.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/base/shown_text.h"
#include "gudgeon/io/hdf5_dataset.h"
#include "gudgeon/io/hdf5_file.h"
#include "gudgeon/io/hdf5_node.h"
#include "gudgeon/io/page_journal.h"
#include "gudgeon/io/run_reader.h"

namespace gudgeon {

namespace {

/// By address, the first name that leads there.
using Places = std::map<std::uint64_t, std::string>;

void note(RunVerification& found, std::string_view place, std::string_view error) {
  constexpr std::size_t kLongest = 1000;
  found.errors.push_back(shorten(show_line(fmt::format("{}: {}", place.empty() ? "/" : place, error)), kLongest));
}

/// "/stages/ideal/channels/time" of "/stages/ideal/channels/slider/time".
std::string find_time_above(const std::string& place) {
  const std::size_t owner = place.rfind('/', place.rfind('/') - 1);
  return place.substr(0, owner) + "/time";
}

/// One thing has one name, but for the time, which is in the group of each owner of channels, too.
void check_single(const Hdf5Handle& group, const std::string& name, const std::string& place, Places& places) {
  const auto [first, is_new] = places.emplace(find_address(group, name), place);
  if (is_new || (name == "time" && first->second == find_time_above(place))) return;
  throw FileError(fmt::format("it is {} under another name, too", first->second));
}

/// Reads what is below a group, which is none of those seen; a member that cannot be read does not keep the others from
/// it.
void verify_group(const Hdf5Handle& group, const std::string& path, Places& places, RunVerification& found) {
  std::vector<std::string> names;
  try {
    names = find_members(group);
  } catch (const FileError& error) {
    note(found, path, error.what());
  }
  for (const std::string& name : names) {
    const std::string place = path + "/" + name;
    try {
      check_single(group, name, place, places);
      if (is_group(group, name)) {
        verify_group(open_group(group, name), place, places, found);
      } else {
        check_values(open_dataset(group, name), name);
        ++found.n_datasets;
      }
    } catch (const FileError& error) {
      note(found, place, error.what());
    }
  }
}

/// The group of each owner of channels has their time, and channels.
void verify_owners(const Hdf5Handle& root, const RunRecord& run, RunVerification& found) {
  for (const StageRecord& stage : run.stages) {
    const Hdf5Handle channels = open_group(open_group(open_group(root, "stages"), stage.name), "channels");
    for (const std::string& owner : find_members(channels)) {
      if (!is_group(channels, owner)) continue;
      const Hdf5Handle group = open_group(channels, owner);
      const std::string place = fmt::format("/stages/{}/channels/{}", stage.name, owner);
      const bool has_time = has_link(group, "time") && find_address(group, "time") == find_address(channels, "time");
      if (!has_time) note(found, place, "its 'time' is missing, or is not that of the stage");
      if (find_members(group).size() < 2) note(found, place, "it has no channel");
    }
  }
}

/// Every channel has its row of statistics, and no row is without its channel.
void verify_statistics(const StageRecord& stage, RunVerification& found) {
  const std::string place = fmt::format("/stages/{}/statistics", stage.name);
  std::set<std::string_view> channels;
  for (const Channel& channel : stage.channels) channels.insert(channel.name);
  std::set<std::string_view> rows;
  for (const ChannelStatistics& row : stage.statistics) {
    if (!rows.insert(row.channel).second) note(found, place, fmt::format("two rows are of '{}'", row.channel));
    if (!channels.contains(row.channel)) note(found, place, fmt::format("its channel '{}' is missing", row.channel));
  }
  // A file of another hand, or a stage that was stopped before anything was counted, may have none.
  if (rows.empty()) return;
  for (const std::string_view channel : channels) {
    if (!rows.contains(channel)) note(found, place, fmt::format("it has no row of channel '{}'", channel));
  }
}

/// "wear_3" follows "wear_2", the first one "no_wear".
void verify_order(const RunRecord& run, RunVerification& found) {
  std::size_t n_wear = 0;
  for (const StageRecord& stage : run.stages) {
    if (stage.name == "ideal") continue;
    const std::string expected = n_wear == 0 ? "no_wear" : fmt::format("wear_{}", n_wear);
    ++n_wear;
    if (stage.name == expected) continue;
    note(found, "/stages", fmt::format("stage '{}' stands where '{}' belongs", stage.name, expected));
    return;
  }
}

/// What failed is named at the root, and only that.
void verify_failure(const Hdf5Handle& root, const RunRecord& run, RunVerification& found) {
  const auto failed = std::ranges::find(run.stages, StageStatus::failed, &StageRecord::status);
  const bool is_told = has_link(root, "failure");
  if (is_told != (failed != run.stages.end())) {
    note(found, "/failure",
         is_told ? "no stage failed" : fmt::format("it is missing: stage '{}' failed", failed->name));
  } else if (is_told && read_text(open_group(root, "failure"), "stage_name") != failed->name) {
    note(found, "/failure", fmt::format("it names another stage than '{}', which failed", failed->name));
  }
}

/// What the parts of a run have to do with each other.
void verify_whole(const std::filesystem::path& file, const RunRecord& run, RunVerification& found) {
  for (const StageRecord& stage : run.stages) verify_statistics(stage, found);
  verify_order(run, found);
  if (found.format_version < 2) return;
  const Hdf5Session session;
  const Hdf5Source source(file);
  verify_owners(source.root(), run, found);
  verify_failure(source.root(), run, found);
}

}  // namespace

RunVerification verify_run(const std::filesystem::path& file) {
  RunVerification found;
  if (has_foreign_journal(file)) {
    found.remarks.push_back(
        fmt::format("{}: belongs to another run file, and is not used; remove it", find_journal(file).string()));
  }
  {
    // Whatever is wrong with the header is told with the file's name; what lies behind it, with its place.
    [[maybe_unused]] const RunRecord header = read_run_header(file);
    const Hdf5Session session;
    const Hdf5Source source(file);
    found.format_version = read_count_attribute(source.root(), "format_version");
    found.has_checksums = found.format_version > 1;
    Places places{{find_address(source.root(), "."), "/"}};
    verify_group(source.root(), "", places, found);
  }
  try {
    const RunRecord run = read_run(file);
    found.n_stages = run.stages.size();
    verify_whole(file, run, found);
  } catch (const FileError& error) {
    if (found.errors.empty()) found.errors.emplace_back(error.what());
  }
  return found;
}

RunVerification require_sound(const std::filesystem::path& file) {
  RunVerification found = verify_run(file);
  if (found.errors.empty()) return found;
  throw FileError(fmt::format("{}: is damaged:\n  {}", file.string(), fmt::join(found.errors, "\n  ")));
}

}  // namespace gudgeon
