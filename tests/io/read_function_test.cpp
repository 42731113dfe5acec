// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What a formula's constants are when they cannot be read.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gudgeon/io/model_reader.h"

namespace gudgeon {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string find_complaint(const std::string& load) {
  const ModelFile model = read_model_text("m.toml", R"toml(name = "arm"
[bodies.frame]
points.O = [0, 0]
[bodies.arm]
mass = 1
inertia = 1
points.O = [0, 0]
[joints.O]
type = "revolute"
between = ["frame.O", "arm.O"]
[study]
cycle_time = 1
[loads.motor]
body = "arm"
)toml" + load);
  return render(model.diagnostics, model.source);
}

TEST(ReadFunction, ABadConstantIsTheOnlyError) {
  const std::string text = find_complaint("torque = \"t0*t\"\nconstants = { t0 = \"3 N q\" }\n");
  EXPECT_THAT(text, HasSubstr("constant 't0'"));
  EXPECT_THAT(text, HasSubstr("\n1 error\n"));
  EXPECT_THAT(text, Not(HasSubstr("E-MODEL-08")));
}

TEST(ReadFunction, AnotherFaultOfTheFormulaIsStillTold) {
  const std::string text = find_complaint("torque = \"t0*t1\"\nconstants = { t0 = \"3 N q\" }\n");
  EXPECT_THAT(text, HasSubstr("uses unknown name 't1'"));
  EXPECT_THAT(text, HasSubstr("\n2 errors\n"));
}

}  // namespace
}  // namespace gudgeon
