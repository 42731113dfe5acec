// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Stages as comma-separated text.
#include "gudgeon/io/csv_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/record_fields.h"
#include "gudgeon/io/safe_file.h"
#include "gudgeon/results/cells.h"
#include "gudgeon/results/energy_balance.h"

namespace gudgeon {

namespace {

/// Grows a CSV text cell by cell.
class CsvText {
 public:
  explicit CsvText(const CsvOptions& options) : options_(options) {}

  void add(std::string_view cell) {
    start_cell();
    if (cell.find_first_of(",;\"\n\r") == std::string_view::npos) {
      text_ += cell;
      return;
    }
    text_ += '"';
    for (const char c : cell) text_ += c == '"' ? std::string("\"\"") : std::string(1, c);
    text_ += '"';
  }
  /// A value in SI, and its unit there.
  void add(double value, std::string_view unit) {
    const CsvUnit* other = find_unit(unit);
    add_number(other == nullptr ? value : value / other->in_si);
  }
  void add_number(double value) {
    start_cell();
    const std::size_t start = text_.size();
    fmt::format_to(std::back_inserter(text_), "{}", value);
    if (options_.decimal_comma) std::replace(text_.begin() + static_cast<std::ptrdiff_t>(start), text_.end(), '.', ',');
  }
  void add_empty() { start_cell(); }
  /// Value i of a series, or nothing where the series is shorter.
  void add(const std::vector<double>& series, std::size_t i, std::string_view unit) {
    if (i < series.size()) {
      add(series[i], unit);
    } else {
      add_empty();
    }
  }
  /// "bearing_depth [m]"
  void add_heading(std::string_view name, std::string_view unit) {
    const std::string_view told = name_unit(unit);
    add(told.empty() ? std::string(name) : fmt::format("{} [{}]", name, told));
  }
  [[nodiscard]] std::string_view name_unit(std::string_view unit) const {
    const CsvUnit* other = find_unit(unit);
    return other == nullptr ? unit : std::string_view(other->text);
  }
  void end_row() {
    text_ += '\n';
    row_is_empty_ = true;
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  [[nodiscard]] const CsvUnit* find_unit(std::string_view si) const {
    const auto found = std::ranges::find(options_.units, si, &CsvUnit::si);
    return found == options_.units.end() ? nullptr : &*found;
  }
  void start_cell() {
    if (!row_is_empty_) text_ += options_.decimal_comma ? ';' : ',';
    row_is_empty_ = false;
  }

  const CsvOptions& options_;
  std::string text_;
  bool row_is_empty_ = true;
};

struct Heading {
  std::string_view name;
  std::string_view unit;
};

CsvText make_header(const CsvOptions& options, std::initializer_list<Heading> columns) {
  CsvText csv(options);
  for (const Heading& column : columns) csv.add_heading(column.name, column.unit);
  csv.end_row();
  return csv;
}

std::string make_channels(const StageRecord& stage, const CsvOptions& options) {
  CsvText csv(options);
  csv.add_heading("time", "s");
  std::vector<std::size_t> columns;
  for (std::size_t k = 0; k < stage.channels.size(); ++k) {
    if (k >= stage.values.size() || stage.values[k].empty()) continue;
    csv.add_heading(stage.channels[k].name, stage.channels[k].unit);
    columns.push_back(k);
  }
  csv.end_row();
  for (std::size_t i = 0; i < stage.time.size(); i += options.every) {
    csv.add(stage.time[i], "s");
    for (const std::size_t k : columns) csv.add(stage.values[k], i, stage.channels[k].unit);
    csv.end_row();
  }
  return csv.text();
}

std::string make_statistics(const StageRecord& stage, const CsvOptions& options) {
  CsvText csv = make_header(options, {{"minimum", ""},
                                      {"minimum_time", "s"},
                                      {"maximum", ""},
                                      {"maximum_time", "s"},
                                      {"mean", ""},
                                      {"rms", ""},
                                      {"channel", ""},
                                      {"unit", ""}});
  for (const ChannelStatistics& s : stage.statistics) {
    const auto channel = std::ranges::find(stage.channels, s.channel, &Channel::name);
    const std::string_view unit = channel == stage.channels.end() ? std::string_view() : channel->unit;
    csv.add(s.minimum, unit);
    csv.add(s.minimum_time, "s");
    csv.add(s.maximum, unit);
    csv.add(s.maximum_time, "s");
    csv.add(s.mean, unit);
    csv.add(s.rms, unit);
    csv.add(s.channel);
    csv.add(csv.name_unit(unit));
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
  const std::size_t n = wear.slot_length > 0.0 ? wear.n_cells() : n_rows;
  return n == 0 ? 1 : n_rows / n;
}

std::string make_wear(const StageRecord& stage, const CsvOptions& options) {
  CsvText csv(options);
  csv.add("surface");
  csv.add_heading("angle", "rad");
  csv.add_heading("position", "m");
  for (const auto& field : kWearSeries) csv.add_heading(field.name, field.unit);
  csv.add("joint");
  csv.end_row();
  for (const JointWear& wear : stage.wear) {
    // One row a cell; the corners of a block have more surfaces than the sides of its slot.
    const std::size_t n_rows = find_row_count(wear);
    const std::size_t n = std::max<std::size_t>(1, n_rows / find_surface_count(wear, n_rows));
    for (std::size_t k = 0; k < n_rows; ++k) {
      csv.add_number(static_cast<double>(k / n));
      csv.add(find_cell_angle(k % n, n), "rad");
      if (wear.slot_length > 0.0) {
        csv.add(find_cell_position(k % n, n, wear.slot_length), "m");
      } else {
        csv.add_empty();
      }
      for (const auto& field : kWearSeries) csv.add(wear.*field.member, k, field.unit);
      csv.add(wear.joint);
      csv.end_row();
    }
  }
  return csv.text();
}

std::string make_events(const StageRecord& stage, const CsvOptions& options) {
  CsvText csv = make_header(options, {{"onset_time", "s"},
                                      {"duration", "s"},
                                      {"onset_speed", "m/s"},
                                      {"angle", "rad"},
                                      {"peak_force", "N"},
                                      {"position", "m"},
                                      {"contact", ""},
                                      {"joint", ""}});
  for (const ContactEvent& e : stage.events) {
    csv.add(e.onset_time, "s");
    csv.add(e.duration, "s");
    csv.add(e.onset_speed, "m/s");
    csv.add(e.angle, "rad");
    csv.add(e.peak_force, "N");
    csv.add(e.position, "m");
    csv.add_number(e.contact);
    csv.add(stage.wear.at(static_cast<std::size_t>(e.joint)).joint);
    csv.end_row();
  }
  return csv.text();
}

std::string make_energy(const StageRecord& stage, const CsvOptions& options) {
  CsvText csv = make_header(options, {{"value", "J"}, {"term", ""}});
  const auto add = [&](std::string_view term, double value) {
    csv.add(value, "J");
    csv.add(term);
    csv.end_row();
  };
  for (const auto& field : kEnergyReals) add(field.name, stage.energy.*field.member);
  add("residual", stage.energy.residual());
  add("allowed_residual", find_allowed_residual(stage.energy));
  return csv.text();
}

struct CsvFile {
  const char* ending;
  std::string (*make)(const StageRecord&, const CsvOptions&);
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

std::set<std::string> list_csv_units(const RunRecord& run) {
  std::set<std::string> units;
  for (const StageRecord& stage : run.stages) {
    units.insert({"s", "J"});
    if (!stage.wear.empty()) units.insert({"m", "m/s", "rad", "N"});
    for (std::size_t k = 0; k < stage.channels.size(); ++k) {
      if (k < stage.values.size() && !stage.values[k].empty()) units.insert(stage.channels[k].unit);
    }
  }
  units.erase("");
  return units;
}

std::vector<std::filesystem::path> export_csv(const RunRecord& run, const std::filesystem::path& directory,
                                              bool overwrite, const CsvOptions& options) {
  make_directory(directory);
  std::vector<std::filesystem::path> written;
  for_each_file(run, directory, [&](const std::filesystem::path& path, const StageRecord&, const CsvFile&) {
    check_target(path, overwrite);
  });
  for_each_file(run, directory, [&](const std::filesystem::path& path, const StageRecord& stage, const CsvFile& file) {
    write_whole(path, file.make(stage, options));
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
  write_whole(paths[0], make_channels(stage, {}));
  write_whole(paths[1], make_statistics(stage, {}));
  return paths;
}

}  // namespace gudgeon
