// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Run files that lack a piece or have another in its place.
#include "gudgeon/io/stage_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/hdf5_dataset.h"
#include "gudgeon/io/record_fields.h"
#include "gudgeon/io/run_reader.h"
#include "gudgeon/io/run_tables.h"
#include "tests/io/image_file.h"
#include "tests/io/scratch_directory.h"

namespace gudgeon {
namespace {

using test::find_message;
using test::ScratchDirectory;
using testing::HasSubstr;

/// One piece of a run file, and what reading says while it is the next one missing.
struct Piece {
  const char* complaint;
  std::function<void(const Hdf5Handle& root)> write;
};

Hdf5Handle open_stage(const Hdf5Handle& root) { return open_group(open_group(root, "stages"), "no_wear"); }

/// The pieces of a run file with one stage without joints, in the order they are read.
std::vector<Piece> list_pieces() {
  const auto text = [](const char* name, const char* value) {
    return [=](const Hdf5Handle& root) { write_text_attribute(root, name, value); };
  };
  return {
      {"an HDF5 file of another program", text("format", kRunFormat)},
      {"attribute 'format_version' is missing", [](auto& root) { write_count_attribute(root, "format_version", 2); }},
      {"attribute 'program_version' is missing", text("program_version", "0.1.0")},
      {"attribute 'model_file' is missing", text("model_file", "m.toml")},
      {"attribute 'case_name' is missing", text("case_name", "base")},
      {"dataset 'model_text' is missing", [](auto& root) { write_text(root, "model_text", ""); }},
      {"dataset 'resolved_model' is missing", [](auto& root) { write_text(root, "resolved_model", ""); }},
      {"table 'overrides' is missing", [](auto& root) { write_table(root, "overrides", kOverrideShape, nullptr, 0); }},
      {"group 'stages' is missing", [](auto& root) { make_group(make_group(root, "stages"), "no_wear"); }},
      {"dataset 'status' is missing", [](auto& root) { write_text(open_stage(root), "status", "stopped"); }},
      {"dataset 'message' is missing", [](auto& root) { write_text(open_stage(root), "message", ""); }},
      {"dataset 'cycles' is missing", [](auto& root) { write_count(open_stage(root), "cycles", 3); }},
      {"dataset 'start_time' is missing",
       [](auto& root) {
         for (const auto& field : kStageReals) write_real(open_stage(root), field.name, 0.0, field.unit);
       }},
      {"group 'channels' is missing", [](auto& root) { make_group(open_stage(root), "channels"); }},
      {"table 'statistics' is missing",
       [](auto& root) { write_table(open_stage(root), "statistics", kStatisticsShape, nullptr, 0); }},
      {"group 'wear' is missing", [](auto& root) { make_group(open_stage(root), "wear"); }},
      {"table 'events' is missing",
       [](auto& root) { write_table(open_stage(root), "events", kEventShape, nullptr, 0); }},
      {"group 'energy' is missing",
       [](auto& root) {
         const Hdf5Handle energy = make_group(open_stage(root), "energy");
         for (const auto& field : kEnergyReals) write_real(energy, field.name, 0.0, field.unit);
       }},
      {"group 'solver' is missing", [](auto& root) { make_group(open_stage(root), "solver"); }},
      {"dataset 'evaluations' is missing",
       [](auto& root) {
         const Hdf5Handle solver = open_group(open_stage(root), "solver");
         for (const auto& field : kSolverCounts) write_count(solver, field.name, 0);
         for (const auto& field : kSolverReals) write_real(solver, field.name, 0.0, field.unit);
       }},
      {"stage 'no_wear': dataset 'time' is missing",
       [](auto& root) { write_series(open_group(open_stage(root), "channels"), "time", {}); }},
  };
}

TEST(StageReader, NamesTheFirstPieceThatIsMissing) {
  const ScratchDirectory scratch;
  const std::vector<Piece> pieces = list_pieces();
  for (std::size_t n = 0; n <= pieces.size(); ++n) {
    test::write_image(scratch / "x.h5", [&](const Hdf5Handle& root) {
      for (std::size_t k = 0; k < n; ++k) pieces[k].write(root);
    });
    if (n == pieces.size()) break;
    EXPECT_THAT(find_message<FileError>([&] { read_run(scratch / "x.h5"); }), HasSubstr(pieces[n].complaint));
  }
  EXPECT_EQ(read_run(scratch / "x.h5").stages[0].cycles, 3);
}

TEST(StageReader, TakesFilesOfBeforeLoadsDidWork) {
  const ScratchDirectory scratch;
  test::write_image(scratch / "x.h5", [&](const Hdf5Handle& root) {
    for (const Piece& piece : list_pieces()) {
      if (std::string_view(piece.complaint) != "group 'energy' is missing") {
        piece.write(root);
        continue;
      }
      const Hdf5Handle energy = make_group(open_stage(root), "energy");
      for (const auto& field : kEnergyReals) {
        const std::string name = field.name;
        if (name != "load_work" && name != "damper_loss") write_real(energy, name, 2.5, "J");
      }
    }
  });
  const EnergyBalance balance = read_run(scratch / "x.h5").stages[0].energy;
  EXPECT_EQ(balance.driver_work, 2.5);
  EXPECT_EQ(balance.load_work, 0.0);
  EXPECT_EQ(balance.damper_loss, 0.0);
}

/// What reading says when the piece with that complaint is written otherwise.
std::string read_misshapen(std::string_view complaint, const std::function<void(const Hdf5Handle& root)>& write) {
  const ScratchDirectory scratch;
  test::write_image(scratch / "x.h5", [&](const Hdf5Handle& root) {
    for (const Piece& piece : list_pieces()) (piece.complaint == complaint ? write : piece.write)(root);
  });
  return find_message<FileError>([&] { read_run(scratch / "x.h5"); });
}

TEST(StageReader, NamesWhatIsMisshapen) {
  EXPECT_THAT(read_misshapen("attribute 'format_version' is missing",
                             [](auto& root) { write_count_attribute(root, "format_version", 7); }),
              HasSubstr("its format version is 7, this program reads 1 to 2"));
  EXPECT_THAT(
      read_misshapen("dataset 'cycles' is missing", [](auto& root) { write_text(open_stage(root), "cycles", "3"); }),
      HasSubstr("dataset 'cycles' has an unexpected type"));
  EXPECT_THAT(
      read_misshapen("dataset 'status' is missing", [](auto& root) { write_text(open_stage(root), "status", "lost"); }),
      HasSubstr("stage 'no_wear': status 'lost' is not known"));
  EXPECT_THAT(read_misshapen("dataset 'model_text' is missing",
                             [](auto& root) { write_series(root, "model_text", std::array{1.0}); }),
              HasSubstr("dataset 'model_text' has an unexpected type"));
  EXPECT_THAT(
      read_misshapen("table 'events' is missing", [](auto& root) { write_series(open_stage(root), "events", {}); }),
      HasSubstr("dataset 'events' is not a table"));
  EXPECT_THAT(read_misshapen("table 'events' is missing",
                             [](auto& root) { write_table(open_stage(root), "events", kOverrideShape, nullptr, 0); }),
              HasSubstr("table 'events' lacks the column 'joint'"));
  const ContactEvent stray{4, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0};
  EXPECT_THAT(read_misshapen("table 'events' is missing",
                             [&](auto& root) { write_table(open_stage(root), "events", kEventShape, &stray, 1); }),
              HasSubstr("an event names joint 4 of 0"));
  EXPECT_THAT(read_misshapen("table 'events' is missing",
                             [](auto& root) {
                               const Hdf5Handle stage = open_stage(root);
                               write_table(stage, "events", kEventShape, nullptr, 0);
                               const Hdf5Handle events = open_group(stage, "events");
                               remove_link(events, "angle");
                               write_series(events, "angle", std::array{1.0, 2.0});
                             }),
              HasSubstr("column 'angle' of table 'events' has 2 rows where 'joint' has 0"));
  EXPECT_THAT(read_misshapen("stage 'no_wear': dataset 'time' is missing",
                             [](auto& root) { write_text(open_group(open_stage(root), "channels"), "time", "noon"); }),
              HasSubstr("dataset 'time' is not of numbers"));
}

}  // namespace
}  // namespace gudgeon
