// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A frame that goes by another name.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "gudgeon/io/model_reader.h"

namespace gudgeon {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr const char* kHint = "the body that stands still is called 'frame' and has points only";

/// What reading says of a pendulum on a body of that name, with other bodies beside it.
std::string read_on(const std::string& name, const std::string& more = "") {
  const ModelFile model =
      read_model_text("m.toml", "name = \"pendulum\"\nbodies." + name +
                                    ".points = { O = [0, 0] }\n"
                                    "bodies.bar = { mass = 1, inertia = 1, points = { O = [0, 0] } }\n"
                                    "joints.O = { type = \"revolute\", between = [\"" +
                                    name + ".O\", \"bar.O\"] }\n" + more);
  return render(model.diagnostics, model.source);
}

TEST(ReadBodies, SayHowTheFrameIsCalled) {
  for (const char* name : {"ground", "Base", "fixed", "world", "chassis", "ground_1"}) {
    const std::string told = read_on(name, "bodies.frame.points = { P = [0, 0] }\n");
    EXPECT_THAT(told, HasSubstr("E-FILE-002: body '" + std::string(name) + "': mass and inertia are missing")) << name;
    EXPECT_THAT(told, HasSubstr(kHint)) << name;
  }
  // Whatever the only body without mass is called where there is no frame.
  EXPECT_THAT(read_on("rahmen"), HasSubstr(kHint));
}

TEST(ReadBodies, OtherBodiesWithoutMassAreToldWhatIsMissing) {
  EXPECT_EQ(read_on("frame"), "");
  for (const std::string& told : {read_on("rod", "bodies.frame.points = { P = [0, 0] }\n"),
                                  read_on("rod", "bodies.lever = { points = { P = [0, 0] } }\n"),
                                  read_on("ground", "bodies.ground.mass = 1\n")}) {
    EXPECT_THAT(told, HasSubstr("inertia is missing"));
    EXPECT_THAT(told, Not(HasSubstr(kHint)));
  }
}

}  // namespace
}  // namespace gudgeon
