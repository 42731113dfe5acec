// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Every shipped example and every case of it reads without a complaint, and the nine-bar says what the paper says.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <numbers>
#include <span>
#include <tuple>

#include "gudgeon/io/model_reader.h"
#include "gudgeon/sim/run_study.h"

namespace gudgeon {
namespace {

const std::filesystem::path kExamples = GUDGEON_SOURCE_DIR "/examples";

TEST(Examples, EveryCaseReads) {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kExamples)) {
    if (entry.path().extension() != ".toml") continue;
    for (const Case& one : read_model(entry.path()).cases) {
      const ModelFile model = read_model(entry.path(), one.name);
      EXPECT_FALSE(model.diagnostics.has_errors()) << render(model.diagnostics, model.source);
    }
  }
}

TEST(Examples, NineBarHasThePapersNumbers) {
  const ModelFile model = read_model(kExamples / "nine_bar/nine_bar.toml");
  const Mechanism& mechanism = model.mechanism;
  EXPECT_EQ(mechanism.bodies.size(), 9U);   // eight moving
  EXPECT_EQ(mechanism.joints.size(), 11U);  // nine constraints of two rows, two clearance joints
  EXPECT_EQ(mechanism.drivers.size(), 2U);
  EXPECT_EQ(model.study.cycle_time, 1.0);
  EXPECT_EQ(model.study.reference.size(), 7U);
  EXPECT_EQ(model.cases.size(), 5U);
  const auto& pin = std::get<RevoluteClearance>(mechanism.joints[find_joint(mechanism, "A")].kind);
  EXPECT_EQ(std::get<Archard>(pin.contact.bearing_wear).coefficient, 4e-14);
}

// Placing each bar by its own guess must meet the printed start positions.
TEST(Examples, NineBarStartsWhereThePaperSays) {
  const Mechanism mechanism = read_model(kExamples / "nine_bar/nine_bar.toml").mechanism;
  const auto far_end = [&](const char* name, Vec2 from, const char* at, const char* point) {
    const Body& body = mechanism.bodies[find_body(mechanism, name)];
    const Vec2 arm = find_point(body, point)->position - find_point(body, at)->position;
    return from + make_rotation(body.start.angle.value()) * arm;
  };
  const auto expect_near = [](Vec2 found, Vec2 printed) {
    EXPECT_NEAR(found.x, printed.x, 2e-5);  // guesses are written to 0.001 deg, so bars of 0.5 m end within 10 um
    EXPECT_NEAR(found.y, printed.y, 2e-5);
  };
  const Vec2 a{0.0223093, 0.0390806};
  const Vec2 b{0.4873576, -0.0757304};
  const Vec2 d{0.1871338, 0.3203436};
  const Vec2 e{0.0065307, 0.4997974};
  const Vec2 f{0.2522438, 0.5664774};
  expect_near(far_end("crank_1", {}, "O1", "A"), a);
  expect_near(far_end("crank_4", {0.43, 0.0}, "O4", "B"), b);
  expect_near(far_end("rod_2", a, "A", "D"), d);
  expect_near(far_end("rod_3", b, "B", "D"), d);
  expect_near(far_end("rod_6", {-0.22, 0.46}, "P6", "E"), e);
  expect_near(far_end("panel_7", e, "E", "D"), d);
  expect_near(far_end("panel_7", e, "E", "F"), f);
  expect_near(far_end("rod_8", f, "F", "S"), {0.5698719, 0.46});
}

TEST(Examples, NineBarSpeedsComeWithTheSmallClearance) {
  const ModelFile model = read_model(kExamples / "nine_bar/nine_bar.toml", "speed_4_pi");
  const Mechanism& mechanism = model.mechanism;
  EXPECT_DOUBLE_EQ(mechanism.drivers[0].speed, -4.0 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(model.study.cycle_time, 0.5);
  EXPECT_EQ(std::get<RevoluteClearance>(mechanism.joints[find_joint(mechanism, "B")].kind).radial_clearance, 0.0003);
  EXPECT_EQ(model.study.reference.size(), 2U);
}

// In seconds: both sides of the slot touched and worn, the energy balance closed, and the ideal mechanism near.
TEST(Examples, SlotsRun) {
  for (const auto& [file, joint, surfaces, slider] : {std::tuple{"slider_crank_guide.toml", "guide", 4U, "slider.x"},
                                                      std::tuple{"scotch_yoke.toml", "pin", 1U, "yoke.x"}}) {
    const ModelFile model = read_model(kExamples / file);
    const auto stages = run_study(model.mechanism, model.study);
    ASSERT_EQ(stages.size(), 3U) << file;
    for (const StageRecord& stage : stages) {
      ASSERT_EQ(stage.status, StageStatus::finished) << file << ": " << stage.message;
      EXPECT_NEAR(stage.energy.residual() / stage.energy.exchanged, 0.0, 1e-6) << file;
    }
    const StageRecord& stage = stages[1];
    for (const char* side : {".left_force", ".right_force"}) {
      EXPECT_GT(std::ranges::max(*find_values(stage, joint + std::string{side})), 10.0) << file << side;
    }
    const JointWear& wear = stage.wear.at(0);
    EXPECT_EQ(wear.journal_depth_added.size(), surfaces * static_cast<std::size_t>(model.study.cells));
    EXPECT_NEAR(wear.removed_volume / wear.archard_volume, 1.0, 1e-9);
    const std::span<const double> depths = wear.bearing_depth_added;
    EXPECT_GT(std::ranges::max(depths.first(wear.n_cells())), 0.0) << file;
    EXPECT_GT(std::ranges::max(depths.subspan(wear.n_cells())), 0.0) << file;
    const auto& loose = *find_values(stage, slider);
    const auto& ideal = *find_values(stages[0], slider);
    for (std::size_t k = 0; k < loose.size(); ++k) ASSERT_NEAR(loose[k], ideal[k], 1.5e-4) << file;
  }
}

}  // namespace
}  // namespace gudgeon
