// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The library as its users see it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "gudgeon/gudgeon.h"

namespace {

using gudgeon::Model;
using gudgeon::ModelError;
using gudgeon::Result;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string kSource = GUDGEON_SOURCE_DIR;

Model read_short_model(const std::string& case_name = {}) {
  Model model = gudgeon::read_model(kSource + "/tests/app/slider_crank.toml", case_name);
  model.set({{"study.cycles", "1"}, {"study.outputs_per_cycle", "50"}});
  return model;
}

template <class Failure, class Work>
std::string find_message(const Work& work) {
  try {
    work();
  } catch (const Failure& failure) {
    return failure.what();
  }
  return "nothing is thrown";
}

TEST(LibraryModel, IsReadInACase) {
  const Model model = gudgeon::read_model(kSource + "/tests/app/slider_crank.toml", "wide");
  EXPECT_EQ(model.name(), "slider_crank");
  EXPECT_THAT(model.case_names(), ElementsAre("wide", "slow"));
  EXPECT_THAT(model.resolved(), HasSubstr("radial_clearance = \"0.0002 m\""));
}

TEST(LibraryModel, TakesNumbersTextsAndUnits) {
  Model model = read_short_model();
  model.set("study.cycles", 3);
  model.set("joints.pin.radial_clearance", 0.3, "mm");
  model.set("study.compare_ideal", "false");
  EXPECT_THAT(model.resolved(), HasSubstr("cycles = 3"));
  EXPECT_THAT(model.resolved(), HasSubstr("radial_clearance = \"0.0003 m\""));
  EXPECT_THAT(model.resolved(), HasSubstr("compare_ideal = false"));
}

TEST(LibraryModel, TakesTheLastOfManyValues) {
  Model model = read_short_model();
  for (int k = 1; k <= 20; ++k) {
    model.set("study.cycles", k);
    model.set("joints.pin.radial_clearance", 0.01 * k, "mm");
  }
  Model direct = read_short_model();
  direct.set({{"study.cycles", "20"}, {"joints.pin.radial_clearance", "0.2 mm"}});
  EXPECT_EQ(model.resolved(), direct.resolved());
}

TEST(LibraryModel, KeepsAValueInsideATableThatIsReplacedAfterIt) {
  Model model = read_short_model();
  model.set("contacts.steel.friction", R"({ law = "coulomb_smooth", kinetic_coefficient = 0.2 })");
  model.set("contacts.steel.friction.kinetic_coefficient", 0.3);
  EXPECT_THAT(model.resolved(), HasSubstr("kinetic_coefficient = 0.3"));
  model.set("contacts.steel.friction", R"({ law = "coulomb_smooth", kinetic_coefficient = 0.4 })");
  EXPECT_THAT(model.resolved(), HasSubstr("kinetic_coefficient = 0.4"));
}

TEST(LibraryModel, StaysAsItWasWhenAChangeIsRefused) {
  Model model = read_short_model();
  const std::string before = model.resolved();
  const auto change = [&] { model.set({{"study.cycles", "-1"}, {"joints.pin.radial_clearance", "3 kg"}}); };
  const std::string message = find_message<ModelError>(change);
  EXPECT_THAT(message, HasSubstr("--set study.cycles=-1"));
  EXPECT_THAT(message, HasSubstr("--set joints.pin.radial_clearance=3 kg"));
  EXPECT_THAT(message, HasSubstr("2 errors"));
  EXPECT_EQ(model.resolved(), before);
}

TEST(LibraryModel, CopiesAreChangedForThemselves) {
  const Model model = read_short_model();
  Model other = model;
  other.set("study.cycles", 7);
  EXPECT_THAT(other.resolved(), HasSubstr("cycles = 7"));
  EXPECT_THAT(model.resolved(), HasSubstr("cycles = 1\n"));
}

TEST(LibraryModel, TellsEverythingThatIsWrongWithItsPlace) {
  const auto read = [] { gudgeon::read_model_text("press.toml", "name = 3\n[bodies.frame]\nmas = \"1 kg\"\n"); };
  const std::string message = find_message<ModelError>(read);
  EXPECT_THAT(message, HasSubstr("press.toml:1:8: error E-"));
  EXPECT_THAT(message, HasSubstr("press.toml:3:1: error E-"));
  try {
    read();
  } catch (const ModelError& error) {
    EXPECT_GE(error.diagnostics().items().size(), 2U);
  }
}

TEST(LibraryModel, TellsOfFilesAndCasesThatAreNotThere) {
  EXPECT_THROW(gudgeon::read_model("/nowhere/model.toml"), gudgeon::FileError);
  EXPECT_THAT(find_message<ModelError>([] { read_short_model("wider"); }), HasSubstr("unknown case 'wider'"));
}

TEST(LibraryRun, SaysWhichStagesJointsAndChannelsThereAre) {
  const Result result = gudgeon::run(read_short_model());
  EXPECT_THAT(result.stage_names(), ElementsAre("ideal", "no_wear", "wear_1"));
  EXPECT_EQ(result.last_stage().name(), "wear_1");
  EXPECT_THAT(result.stage("wear_1").joint_names(), ElementsAre("pin"));
  const auto ask_stage = [&] { (void)result.stage("wear_2"); };
  EXPECT_THAT(find_message<std::out_of_range>(ask_stage),
              HasSubstr("there is no stage 'wear_2'; there are: ideal, no_wear, wear_1. Did you mean 'wear_1'?"));
  EXPECT_THAT(find_message<std::out_of_range>([&] { (void)result.stage("wear_1").joint("A"); }),
              HasSubstr("there is no joint with clearance 'A' in stage 'wear_1'; there are: pin"));
  EXPECT_THAT(find_message<std::out_of_range>([&] { (void)result.stage("ideal").joint("pin"); }),
              HasSubstr("there is none"));
  EXPECT_THAT(find_message<std::out_of_range>([&] { (void)result.stage("ideal").values("slider.z"); }),
              HasSubstr("there is no channel 'slider.z' in stage 'ideal'; there are: "));
}

TEST(LibraryRun, DepthsAddUpFromStageToStage) {
  Model model = read_short_model();
  model.set("study.wear_stages", 2);
  const Result result = gudgeon::run(model);
  double deepest = 0.0;
  for (const char* stage : {"no_wear", "wear_1", "wear_2"}) {
    const auto joint = result.stage(stage).joint("pin");
    EXPECT_EQ(joint.bearing_depth().size(), 100U);
    EXPECT_GT(joint.bearing_depth().max(), deepest) << stage;
    EXPECT_NEAR(joint.bearing_depth_added().max(), std::ranges::max(joint.record().bearing_depth_added), 0.0);
    EXPECT_LE(joint.bearing_depth().mean(), joint.bearing_depth().max());
    deepest = joint.bearing_depth().max();
  }
  const gudgeon::DepthProfile before = result.stage("wear_1").joint("pin").journal_depth();
  EXPECT_EQ(result.stage("wear_2").joint("pin").record().journal_depth,
            std::vector<double>(before.begin(), before.end()));
}

TEST(LibraryRun, ChannelsHaveOneValueASample) {
  const Result result = gudgeon::run(read_short_model());
  const auto stage = result.stage("ideal");
  const auto values = stage.values("slider.x");
  ASSERT_EQ(values.size(), stage.time().size());
  EXPECT_GE(values.size(), 50U);
  EXPECT_EQ(stage.channel("slider.x").unit, "m");
  for (std::size_t k = 0; k < values.size(); ++k) {
    // crank 50 mm from 60 deg at 1 rev/s, rod 150 mm
    const double angle = std::numbers::pi * (1.0 / 3.0 + 2.0 * stage.time()[k]);
    EXPECT_NEAR(values[k], 0.05 * std::cos(angle) + std::sqrt(0.15 * 0.15 - std::pow(0.05 * std::sin(angle), 2)), 1e-9);
  }
  EXPECT_GE(stage.statistics("slider.x").maximum, std::ranges::max(values));
  EXPECT_LT(stage.energy_error(), 1e-3);
}

TEST(LibraryRun, ModelsSideBySideGiveTheSameAsOneByOne) {
  std::vector<Model> models(4, read_short_model());
  for (std::size_t k = 0; k < models.size(); ++k) {
    models[k].set("joints.pin.radial_clearance", 0.1 + 0.05 * static_cast<double>(k), "mm");
  }
  std::vector<std::atomic<double>> shares(models.size());
  const std::vector<Result> results =
      gudgeon::run(models, {.threads = 3, .progress = [&](std::size_t model, double share) { shares[model] = share; }});
  ASSERT_EQ(results.size(), models.size());
  for (std::size_t k = 0; k < models.size(); ++k) {
    const Result alone = gudgeon::run(models[k]);
    EXPECT_EQ(results[k].stage("wear_1").record().values, alone.stage("wear_1").record().values) << k;
    EXPECT_DOUBLE_EQ(shares[k], 1.0);
  }
}

TEST(LibraryRun, ThrowsWhatIsNotSoundUnlessAskedNotTo) {
  const Model model = gudgeon::read_model(kSource + "/tests/cases/law_end_johnson.toml");
  EXPECT_THAT(find_message<gudgeon::NumericalError>([&] { gudgeon::run(model); }), HasSubstr("stage no_wear: E-NUM-"));
  const Result result = gudgeon::run(model, {.require_sound = false});
  ASSERT_EQ(result.problems().size(), 1U);
  EXPECT_THAT(result.problems().front(), HasSubstr("stage no_wear: E-NUM-"));
}

TEST(LibraryRun, OneThatThrowsLeavesTheOthersAlone) {
  const Model bad = gudgeon::read_model(kSource + "/tests/cases/law_end_johnson.toml");
  const std::vector<Model> models{read_short_model(), bad, read_short_model()};
  std::vector<std::atomic<double>> shares(models.size());
  const auto run = [&] {
    gudgeon::run(models, {.progress = [&](std::size_t model, double share) { shares[model] = share; }});
  };
  EXPECT_THAT(find_message<gudgeon::NumericalError>(run), HasSubstr("E-NUM-"));
  EXPECT_DOUBLE_EQ(shares[0], 1.0);
  EXPECT_DOUBLE_EQ(shares[2], 1.0);
}

TEST(LibraryRun, StopsWhenAsked) {
  std::stop_source source;
  source.request_stop();
  const Result result = gudgeon::run(read_short_model(), {.require_sound = false, .stop = source.get_token()});
  ASSERT_EQ(result.problems().size(), 1U);
  EXPECT_THAT(result.problems().front(), HasSubstr("stopped on request"));
}

TEST(LibraryRun, AModelThatCannotBeAssembledIsToldWithItsPlace) {
  Model model = read_short_model();
  model.set("bodies.crank.points.A", R"(["500 mm", 0])");  // 433 mm beside the guide, and the rod is 150 mm long
  const std::string message = find_message<ModelError>([&] { gudgeon::run(model); });
  EXPECT_THAT(message, HasSubstr("slider_crank.toml:46:9: error E-MODEL-070"));
  EXPECT_THAT(message, HasSubstr("[joints.guide]"));
}

}  // namespace
