// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Root of a run file, and the one place where errors inside a file meet its path.
#include "gudgeon/io/run_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <stdexcept>
#include <string_view>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/base/shown_text.h"
#include "gudgeon/io/hdf5_dataset.h"
#include "gudgeon/io/hdf5_file.h"
#include "gudgeon/io/hdf5_node.h"
#include "gudgeon/io/old_keys.h"
#include "gudgeon/io/record_fields.h"
#include "gudgeon/io/run_tables.h"
#include "gudgeon/io/safe_file.h"
#include "gudgeon/io/stage_checks.h"
#include "gudgeon/io/stage_reader.h"

namespace gudgeon {

namespace {

/// What names of a file put into it commands no terminal, is one line, and is not endless.
std::string show_error(std::string_view why) {
  constexpr std::size_t kLongest = 1000;
  return shorten(show_line(why), kLongest);
}

/// Runs a reading function and adds path and next step to whatever goes wrong in it.
template <class Read>
auto read_inside(const std::filesystem::path& file, Read read) {
  check_source(file);
  std::string why;
  try {
    const Hdf5Session session;
    const Hdf5Source source(file);
    return read(source.root());
  } catch (const FileError& error) {
    why = error.what();
  } catch (const std::bad_alloc&) {
    why = "it does not fit into memory";
  } catch (const std::length_error&) {
    why = "it does not fit into memory";
  }
  throw FileError(fmt::format("{}: cannot be read as a run file: {}; give a file that 'gudgeon run' wrote",
                              file.string(), show_error(why)));
}

/// Adds the stage's name to errors inside it.
template <class Read>
auto read_in_stage(const std::string& name, Read read) {
  try {
    return read();
  } catch (const FileError& error) {
    throw FileError(fmt::format("stage '{}': {}", name, error.what()));
  }
}

/// The version of the format; FileError when this program cannot read it.
std::int64_t check_format(const Hdf5Handle& root) {
  if (!has_attribute(root, "format") || read_text_attribute(root, "format") != kRunFormat) {
    throw FileError("it is an HDF5 file of another program");
  }
  const std::int64_t version = read_count_attribute(root, "format_version");
  if (version < 1 || version > kRunFormatVersion) {
    throw FileError(fmt::format("its format version is {}, this program reads 1 to {}", version, kRunFormatVersion));
  }
  return version;
}

RunRecord read_header(const Hdf5Handle& root) {
  const std::int64_t version = check_format(root);
  RunRecord run;
  run.program_version = read_text_attribute(root, "program_version");
  run.model_file = read_text_attribute(root, "model_file");
  run.case_name = read_text_attribute(root, "case_name");
  run.model_text = read_text(root, "model_text");
  run.resolved_model = read_text(root, version == 1 ? "explained" : "resolved_model");
  read_table(root, "overrides", kOverrideShape, [&](const void* bytes) {
    const auto& row = *static_cast<const OverrideRow*>(bytes);
    run.overrides.emplace_back(find_present_path(row.path == nullptr ? "" : row.path),
                               row.text == nullptr ? "" : row.text);
  });
  return run;
}

RunRecord read_outline(const Hdf5Handle& root) {
  RunRecord run = read_header(root);
  const Hdf5Handle stages = open_group(root, "stages");
  for (const std::string& name : find_children(stages)) {
    check_stage_name(name);
    run.stages.push_back(read_in_stage(name, [&] { return read_stage_outline(stages, name); }));
  }
  return run;
}

void read_all_values(const Hdf5Handle& stages, StageRecord& stage) {
  const StageSamples samples(stages, stage.name);
  samples.read_time(stage);
  for (std::size_t k = 0; k < stage.channels.size(); ++k) samples.read_values(stage, k);
}

void read_some_values(const Hdf5Handle& stages, StageRecord& stage, std::span<const std::string> channels) {
  const StageSamples samples(stages, stage.name);
  samples.read_time(stage);
  stage.values.resize(stage.channels.size());
  for (const std::string& name : channels) {
    const auto found = std::ranges::find(stage.channels, name, &Channel::name);
    if (found == stage.channels.end()) throw FileError(fmt::format("channel '{}' was not recorded", name));
    samples.read_values(stage, static_cast<std::size_t>(found - stage.channels.begin()));
  }
}

}  // namespace

RunRecord read_run(const std::filesystem::path& file) {
  return read_inside(file, [](const Hdf5Handle& root) {
    RunRecord run = read_outline(root);
    const Hdf5Handle stages = open_group(root, "stages");
    for (StageRecord& stage : run.stages) read_in_stage(stage.name, [&] { read_all_values(stages, stage); });
    return run;
  });
}

RunRecord read_run_header(const std::filesystem::path& file) { return read_inside(file, read_header); }

RunRecord read_run_outline(const std::filesystem::path& file) { return read_inside(file, read_outline); }

void read_channels(const std::filesystem::path& file, std::span<StageRecord> stages, const ChooseChannels& choose) {
  read_inside(file, [&](const Hdf5Handle& root) {
    check_format(root);
    const Hdf5Handle group = open_group(root, "stages");
    for (StageRecord& stage : stages) {
      read_in_stage(stage.name, [&] { read_some_values(group, stage, choose(stage)); });
    }
  });
}

}  // namespace gudgeon
