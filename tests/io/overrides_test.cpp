// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Cases and overrides: what they may replace, their order, and how their errors say where they come from.
#include "gudgeon/io/overrides.h"

#include <gtest/gtest.h>

#include "gudgeon/io/model_reader.h"
#include "tests/io/pendulum_model.h"

namespace gudgeon {
namespace {

const std::string kPendulumModel = test::make_pendulum_model(R"([cases.heavy]
description = "twice the mass"
set = { "bodies.bar.mass" = "2 kg", "study.cycles" = 7, bodies.bar.inertia = 3 }
[cases.broken]
set = { "bodies.bar.mass" = "-2 kg" }
[cases.lost]
[cases.lost.set]
"bodies.baar.mass" = 1
)");

ModelFile read_with(std::string_view case_name, std::vector<Override> overrides) {
  return read_model_text("m.toml", kPendulumModel, case_name, overrides);
}

std::string render_all(const ModelFile& model) { return render(model.diagnostics, model.source); }

const Body& bar(const ModelFile& model) { return model.mechanism.bodies[1]; }

TEST(Overrides, CasesAreListedWithTheirTexts) {
  const ModelFile model = read_with("", {});
  EXPECT_EQ(render_all(model), "");
  ASSERT_EQ(model.cases.size(), 3U);
  EXPECT_EQ(model.cases[0].description, "twice the mass");
  const std::vector<std::pair<std::string, std::string>> expected{
      {"bodies.bar.mass", "2 kg"}, {"study.cycles", "7"}, {"bodies.bar.inertia", "3"}};
  EXPECT_EQ(model.cases[0].overrides, expected);
}

TEST(Overrides, ApplyACaseThenTheCommandLine) {
  const ModelFile model = read_with("heavy", {{"bodies.bar.mass", "5 kg"}, {"bodies.bar.points.tip.0", "3 m"}});
  EXPECT_EQ(render_all(model), "");
  EXPECT_EQ(bar(model).mass, 5.0);
  EXPECT_EQ(bar(model).inertia, 3.0);
  EXPECT_EQ(bar(model).points[1].position.x, 3.0);
  EXPECT_EQ(model.study.cycles, 7);
  EXPECT_EQ(model.case_name, "heavy");
  EXPECT_EQ(model.overrides.size(), 2U);
}

TEST(Overrides, MaySetWhatTheFileLeavesOut) {
  const ModelFile model = read_with("", {{"study.cycles", "3"},
                                         {"bodies.bar.start.angle", "90 deg"},
                                         {"gravity", "[0, \"-9.81 m/s^2\"]"},
                                         {"study.compare_ideal", "false"},
                                         {"loads.push", "3"}});
  EXPECT_EQ(model.study.cycles, 3);
  EXPECT_EQ(model.mechanism.gravity.y, -9.81);
  EXPECT_FALSE(model.study.compare_ideal);
  EXPECT_TRUE(bar(model).start.angle.has_value());
  EXPECT_NE(render_all(model).find("the model has nothing at 'loads.push'"), std::string::npos);
}

TEST(Overrides, TakeTomlValuesAndUnquotedTexts) {
  EXPECT_EQ(std::get<double>(parse_value("3").value), 3.0);
  EXPECT_EQ(std::get<bool>(parse_value("true").value), true);
  EXPECT_EQ(std::get<std::string>(parse_value("0.3 mm").value), "0.3 mm");
  EXPECT_EQ(std::get<std::string>(parse_value("'0.3 mm'").value), "0.3 mm");
  EXPECT_EQ(std::get<std::string>(parse_value("point").value), "point");
  EXPECT_EQ(std::get<std::string>(parse_value("1979-05-27").value), "1979-05-27");
  EXPECT_EQ(std::get<std::string>(parse_value("1\nw = 2").value), "1\nw = 2");
  EXPECT_EQ(std::get<std::string>(parse_value("").value), "");
  EXPECT_EQ(std::get<DocumentNode::Array>(parse_value("[1, \"2 m\"]").value).size(), 2U);
  EXPECT_NE(parse_value("{ law = \"hertz\" }").table(), nullptr);
}

TEST(Overrides, ErrorsNameTheCommandLine) {
  const ModelFile model = read_with("", {{"bodies.bar.mass", "-3 kg"}, {"study.cycels", "3"}, {"bodies.br.mass", "1"}});
  const std::string text = render_all(model);
  for (const char* expected :
       {"--set bodies.bar.mass=-3 kg: error E-MODEL-003: body 'bar': mass is \"-3 kg\" (-3 kg); it must be positive",
        "--set study.cycels=3: error E-FILE-001: study has no key 'cycels'", "Did you mean 'cycles'?",
        "--set bodies.br.mass=1: error E-FILE-010: the model has nothing at 'bodies.br.mass'",
        "Did you mean 'bodies.bar.mass'?", "3 errors"}) {
    EXPECT_NE(text.find(expected), std::string::npos) << expected << "\nin\n" << text;
  }
}

TEST(Overrides, ErrorsNameTheCase) {
  const std::string broken = render_all(read_with("broken", {}));
  EXPECT_TRUE(broken.starts_with("m.toml:15:29: error E-MODEL-003: ")) << broken;
  EXPECT_NE(broken.find("   set by case 'broken'\n"), std::string::npos) << broken;
  const std::string lost = render_all(read_with("lost", {}));
  EXPECT_TRUE(lost.starts_with("m.toml:18:22: error E-FILE-010: ")) << lost;
  EXPECT_NE(lost.find("Did you mean 'bodies.bar.mass'?"), std::string::npos) << lost;
}

TEST(Overrides, AnUnknownCaseListsTheCases) {
  const std::string text = render_all(read_with("hevy", {}));
  EXPECT_NE(text.find("E-FILE-009: unknown case 'hevy'"), std::string::npos) << text;
  EXPECT_NE(text.find("possible: heavy, broken, lost   Did you mean 'heavy'?"), std::string::npos) << text;
}

TEST(Overrides, OddPathsAreErrors) {
  for (const char* path : {"", ".", "bodies.", "bodies.bar.mass.x", "bodies.bar.points.tip.7", "..mass"}) {
    EXPECT_TRUE(read_with("", {{path, "1"}}).diagnostics.has_errors()) << path;
  }
}

TEST(Overrides, MayNotNestDeepOrHoldControls) {
  std::string deep = "1";
  for (int k = 0; k < 100000; ++k) deep = "[" + deep;
  const std::string errors = render_all(read_with("", {{"bodies.bar.mass", deep}}));
  EXPECT_NE(errors.find("E-TOML-002: the value given to 'bodies.bar.mass' nests deeper"), std::string::npos) << errors;
  EXPECT_LT(errors.size(), 3000U);
  const std::string controls = render_all(read_with("", {{"bodies.bar.mass", "1\x1b[2J kg"}}));
  EXPECT_NE(controls.find("E-FILE-015"), std::string::npos) << controls;
  EXPECT_EQ(controls.find('\x1b'), std::string::npos);
}

TEST(ModelDocument, MakesTheModelOfEachCase) {
  const ModelDocument document("m.toml", kPendulumModel);
  for (const std::string_view name : {"", "heavy", "broken", "lost", "light"}) {
    const std::vector<Override> overrides{{"bodies.bar.inertia", "2"}};
    const ModelFile one = document.read(name, overrides);
    const ModelFile whole = read_with(name, overrides);
    EXPECT_EQ(render_all(one), render_all(whole)) << name;
    EXPECT_EQ(bar(one).mass, bar(whole).mass);
    EXPECT_LE(one.cases.size(), 1U);
  }
  EXPECT_EQ(document.cases().size(), 3U);
  EXPECT_EQ(document.find_name("", {}), "pendulum");
  EXPECT_EQ(document.find_name("heavy", std::vector<Override>{{"name", "swing"}}), "swing");
  EXPECT_EQ(ModelDocument("m.toml", "name = 3").find_name("", {}), "");
  EXPECT_EQ(ModelDocument("m.toml", "name = ").find_name("", {}), "");
}

TEST(ModelDocument, TellsWhatIsWrongWithCasesInEveryOne) {
  const ModelDocument document("m.toml", kPendulumModel + "[cases.odd]\nsat = { a = 1 }\n");
  for (const std::string_view name : {"", "heavy"}) {
    EXPECT_NE(render_all(document.read(name, {})).find("m.toml:19:8: error E-FILE-002: case 'odd': set is missing"),
              std::string::npos)
        << render_all(document.read(name, {}));
  }
}

}  // namespace
}  // namespace gudgeon
