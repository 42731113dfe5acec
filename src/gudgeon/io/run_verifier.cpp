// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// From group to group, then as a run.
#include "gudgeon/io/run_verifier.h"

#include <fmt/format.h>

#include <set>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/hdf5_dataset.h"
#include "gudgeon/io/hdf5_file.h"
#include "gudgeon/io/hdf5_node.h"
#include "gudgeon/io/run_reader.h"

namespace gudgeon {

namespace {

using Addresses = std::set<std::uint64_t>;

/// Reads what is below a group, which is none of those seen; a member that cannot be read does not keep the others from
/// it.
void verify_group(const Hdf5Handle& group, const std::string& path, Addresses& seen, RunVerification& found) {
  std::vector<std::string> names;
  try {
    names = find_members(group);
  } catch (const FileError& error) {
    found.troubles.push_back(fmt::format("{}: {}", path.empty() ? "/" : path, error.what()));
  }
  for (const std::string& name : names) {
    const std::string place = path + "/" + name;
    try {
      if (is_group(group, name)) {
        if (!seen.insert(find_address(group, name)).second) throw FileError("the group has another name, too");
        verify_group(open_group(group, name), place, seen, found);
      } else {
        check_values(open_dataset(group, name), name);
        ++found.n_datasets;
      }
    } catch (const FileError& error) {
      found.troubles.push_back(fmt::format("{}: {}", place, error.what()));
    }
  }
}

}  // namespace

RunVerification verify_run(const std::filesystem::path& file) {
  RunVerification found;
  {
    // Whatever is wrong with the header is told with the file's name; what lies behind it, with its place.
    [[maybe_unused]] const RunRecord header = read_run_header(file);
    const Hdf5Session session;
    const Hdf5Source source(file);
    found.format_version = read_count_attribute(source.root(), "format_version");
    found.has_checksums = found.format_version > 1;
    Addresses seen{find_address(source.root(), ".")};
    verify_group(source.root(), "", seen, found);
  }
  try {
    const RunRecord run = read_run(file);
    found.n_stages = run.stages.size();
  } catch (const FileError& error) {
    if (found.troubles.empty()) found.troubles.emplace_back(error.what());
  }
  return found;
}

void require_sound(const std::filesystem::path& file) {
  const RunVerification found = verify_run(file);
  if (found.troubles.empty()) return;
  throw FileError(fmt::format("{}: is damaged:\n  {}", file.string(), fmt::join(found.troubles, "\n  ")));
}

}  // namespace gudgeon
