// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Stages as comma-separated text.
#include "gudgeon/io/csv_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/record_fields.h"
#include "gudgeon/io/safe_file.h"
#include "gudgeon/results/energy_balance.h"
#include "gudgeon/results/regions.h"

namespace gudgeon {

namespace {

/// Grows a CSV text cell by cell.
class CsvText {
 public:
  void add(std::string_view cell) {
    start_cell();
    if (cell.find_first_of(",\"\n\r") == std::string_view::npos) {
      text_ += cell;
      return;
    }
    text_ += '"';
    for (const char c : cell) text_ += c == '"' ? std::string("\"\"") : std::string(1, c);
    text_ += '"';
  }
  void add(double value) {
    start_cell();
    fmt::format_to(std::back_inserter(text_), "{}", value);
  }
  /// Value i of a series, or nothing where the series is shorter.
  void add(const std::vector<double>& series, std::size_t i) {
    if (i < series.size()) {
      add(series[i]);
    } else {
      start_cell();
    }
  }
  void end_row() {
    text_ += '\n';
    row_is_empty_ = true;
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void start_cell() {
    if (!row_is_empty_) text_ += ',';
    row_is_empty_ = false;
  }
  std::string text_;
  bool row_is_empty_ = true;
};

std::string name_column(std::string_view name, std::string_view unit) {
  return unit.empty() ? std::string(name) : fmt::format("{} [{}]", name, unit);
}

CsvText make_header(std::initializer_list<std::string_view> columns) {
  CsvText csv;
  for (const std::string_view column : columns) csv.add(column);
  csv.end_row();
  return csv;
}

std::string make_channels(const StageRecord& stage) {
  CsvText csv;
  csv.add("time [s]");
  std::vector<const std::vector<double>*> columns;
  for (std::size_t k = 0; k < stage.channels.size(); ++k) {
    if (k >= stage.values.size() || stage.values[k].empty()) continue;
    csv.add(name_column(stage.channels[k].name, stage.channels[k].unit));
    columns.push_back(&stage.values[k]);
  }
  csv.end_row();
  for (std::size_t i = 0; i < stage.time.size(); ++i) {
    csv.add(stage.time[i]);
    for (const auto* column : columns) csv.add(*column, i);
    csv.end_row();
  }
  return csv.text();
}

std::string make_statistics(const StageRecord& stage) {
  CsvText csv =
      make_header({"channel", "unit", "minimum", "minimum_time [s]", "maximum", "maximum_time [s]", "mean", "rms"});
  for (const ChannelStatistics& s : stage.statistics) {
    const auto channel = std::ranges::find(stage.channels, s.channel, &Channel::name);
    csv.add(s.channel);
    csv.add(channel == stage.channels.end() ? std::string_view() : channel->unit);
    for (const double value : {s.minimum, s.minimum_time, s.maximum, s.maximum_time, s.mean, s.rms}) csv.add(value);
    csv.end_row();
  }
  return csv.text();
}

std::size_t find_row_count(const JointWear& wear) {
  std::size_t n = 0;
  for (const auto& field : kWearSeries) n = std::max(n, (wear.*field.member).size());
  return n;
}

// How many surfaces the longest series tells of.
std::size_t find_surface_count(const JointWear& wear, std::size_t n_rows) {
  const std::size_t n = wear.slot_length > 0.0 ? wear.n_regions() : n_rows;
  return n == 0 ? 1 : n_rows / n;
}

std::string make_wear(const StageRecord& stage) {
  CsvText csv;
  csv.add("joint");
  csv.add("surface");
  csv.add("angle [rad]");
  csv.add("position [m]");
  for (const auto& field : kWearSeries) csv.add(name_column(field.name, field.unit));
  csv.end_row();
  for (const JointWear& wear : stage.wear) {
    // One row a region; the corners of a block have more surfaces than the sides of its slot.
    const std::size_t n_rows = find_row_count(wear);
    const std::size_t n = std::max<std::size_t>(1, n_rows / find_surface_count(wear, n_rows));
    for (std::size_t k = 0; k < n_rows; ++k) {
      csv.add(wear.joint);
      csv.add(static_cast<double>(k / n));
      csv.add(find_region_angle(k % n, n));
      if (wear.slot_length > 0.0) {
        csv.add(find_region_position(k % n, n, wear.slot_length));
      } else {
        csv.add(std::string_view());
      }
      for (const auto& field : kWearSeries) csv.add(wear.*field.member, k);
      csv.end_row();
    }
  }
  return csv.text();
}

std::string make_events(const StageRecord& stage) {
  CsvText csv = make_header({"joint", "onset_time [s]", "duration [s]", "onset_speed [m/s]", "angle [rad]",
                             "peak_force [N]", "position [m]", "contact"});
  for (const ContactEvent& e : stage.events) {
    csv.add(stage.wear.at(static_cast<std::size_t>(e.joint)).joint);
    for (const double value :
         {e.onset_time, e.duration, e.onset_speed, e.angle, e.peak_force, e.position, double(e.contact)}) {
      csv.add(value);
    }
    csv.end_row();
  }
  return csv.text();
}

std::string make_energy(const StageRecord& stage) {
  CsvText csv = make_header({"term", "value [J]"});
  for (const auto& field : kEnergyReals) {
    csv.add(field.name);
    csv.add(stage.ledger.*field.member);
    csv.end_row();
  }
  csv.add("residual");
  csv.add(stage.ledger.residual());
  csv.end_row();
  csv.add("allowed_residual");
  csv.add(find_allowed_residual(stage.ledger));
  csv.end_row();
  return csv.text();
}

struct CsvFile {
  const char* ending;
  std::string (*make)(const StageRecord&);
  bool needs_joints;
};

constexpr CsvFile kCsvFiles[] = {
    {"_channels.csv", make_channels, false}, {"_statistics.csv", make_statistics, false},
    {"_wear.csv", make_wear, true},          {"_events.csv", make_events, true},
    {"_energy.csv", make_energy, false},
};

/// Calls visit(path, stage, file) for each file to write.
template <class Visit>
void for_each_file(const RunRecord& run, const std::filesystem::path& directory, Visit visit) {
  for (const StageRecord& stage : run.stages) {
    for (const CsvFile& file : kCsvFiles) {
      if (!file.needs_joints || !stage.wear.empty()) visit(directory / (stage.name + file.ending), stage, file);
    }
  }
}

void make_directory(const std::filesystem::path& directory) {
  std::error_code why;
  std::filesystem::create_directories(directory, why);
  if (why) {
    throw FileError(
        fmt::format("{}: directory cannot be made: {}; choose another one", directory.string(), why.message()));
  }
}

}  // namespace

std::vector<std::filesystem::path> export_csv(const RunRecord& run, const std::filesystem::path& directory,
                                              bool overwrite) {
  make_directory(directory);
  std::vector<std::filesystem::path> written;
  for_each_file(run, directory, [&](const std::filesystem::path& path, const StageRecord&, const CsvFile&) {
    check_target(path, overwrite);
  });
  for_each_file(run, directory, [&](const std::filesystem::path& path, const StageRecord& stage, const CsvFile& file) {
    write_whole(path, file.make(stage));
    written.push_back(path);
  });
  return written;
}

std::vector<std::filesystem::path> export_motion(const StageRecord& stage, const std::filesystem::path& directory,
                                                 bool overwrite) {
  make_directory(directory);
  const std::vector<std::filesystem::path> paths{directory / (stage.name + "_channels.csv"),
                                                 directory / (stage.name + "_statistics.csv")};
  for (const std::filesystem::path& path : paths) check_target(path, overwrite);
  write_whole(paths[0], make_channels(stage));
  write_whole(paths[1], make_statistics(stage));
  return paths;
}

}  // namespace gudgeon
