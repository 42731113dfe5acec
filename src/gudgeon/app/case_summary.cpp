// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Of the samples only those of channels that are set beside the ideal ones are read.
#include "gudgeon/app/case_summary.h"

#include <string_view>
#include <unordered_set>

#include "gudgeon/analysis/reference_values.h"
#include "gudgeon/app/text_output.h"
#include "gudgeon/io/run_reader.h"
#include "gudgeon/report/comparison_section.h"
#include "gudgeon/report/run_summary.h"

namespace gudgeon {
namespace {

std::vector<ReferenceRow> make_reference(const std::vector<ReferenceValue>& reference) {
  std::vector<ReferenceRow> rows;
  for (const ReferenceValue& value : reference) {
    rows.push_back({value.quantity, value.channel, value.measure, value.values, {}});
  }
  return rows;
}

}  // namespace

std::string summarize_case(const std::filesystem::path& file, RunRecord run,
                           const std::vector<ReferenceValue>& reference) {
  const std::vector<std::string> ideal = find_ideal_channels(run);
  const std::unordered_set<std::string_view> wanted(ideal.begin(), ideal.end());
  read_channels(file, run.stages, [&](const StageRecord& stage) {
    std::vector<std::string> channels;
    for (const Channel& channel : stage.channels) {
      if (wanted.contains(channel.name)) channels.push_back(channel.name);
    }
    return channels;
  });
  return render_summary(run, make_reference(reference), find_color_wanted());
}

}  // namespace gudgeon
