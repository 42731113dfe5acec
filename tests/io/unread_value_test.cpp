// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A value that cannot be read is reported once: no rule is broken by what is not there.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>

#include "gudgeon/io/model_reader.h"

namespace gudgeon {
namespace {

/// Numbers and quantities, "12" or "\"0.5 mm\""; names and formulas are not.
bool is_quantity(const std::string& written) {
  const std::size_t quotes = written.find_first_not_of("\"'");
  if (quotes == std::string::npos) return false;
  const std::string text = written.substr(quotes, written.find_last_not_of("\"'") - quotes + 1);
  const auto* digits = "0123456789";
  if (text.find_first_of(digits) > 1 || text.find_first_of("-+.0123456789") != 0) return false;
  return quotes == 0 || text.find_first_of("*()") == std::string::npos;
}

/// Every quantity of the file in turn is no quantity.
int check_each_value(const std::filesystem::path& file) {
  const ModelFile good = gudgeon::read_model(file);
  EXPECT_FALSE(good.diagnostics.has_errors()) << render(good.diagnostics, good.source);
  int n_checked = 0;
  for (const auto& [path, written] : good.source.written) {
    if (path.starts_with("cases.") || path.starts_with("study.reference") || !is_quantity(written)) continue;
    for (const char* wrong : {"\"12 zonks\"", "\"abc\"", "true", "nan"}) {
      const Override change{path, wrong};
      const ModelFile model = gudgeon::read_model(file, "", {&change, 1});
      int n_errors = 0;
      for (const Diagnostic& item : model.diagnostics.items()) n_errors += item.severity == Severity::error ? 1 : 0;
      EXPECT_EQ(n_errors, 1) << path << " = " << wrong << "\n" << render(model.diagnostics, model.source);
      ++n_checked;
    }
  }
  return n_checked;
}

class UnreadValue : public testing::TestWithParam<const char*> {};

TEST_P(UnreadValue, IsReportedOnce) {
  EXPECT_GT(check_each_value(std::filesystem::path(GUDGEON_SOURCE_DIR) / GetParam()), 50);
}

INSTANTIATE_TEST_SUITE_P(Examples, UnreadValue,
                         testing::Values("tests/app/slider_crank.toml", "examples/slider_crank_guide.toml",
                                         "examples/scotch_yoke.toml", "examples/quick_return.toml",
                                         "examples/motor_press/motor_press.toml"));

// What the reader makes of one value for two, and of two for one, and every kind of load.
TEST(UnreadValue, IsReportedOnceInLoadsAndShares) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "gudgeon_unread_value.toml";
  FILE* out = std::fopen(file.c_str(), "w");
  ASSERT_NE(out, nullptr);
  std::fputs(R"(
name = "many_values"
bodies.frame.points = { O = [0, 0], S = [0.3, 0.1] }
bodies.bar = { mass = 1, inertia = 1e-2, points = { A = [0, 0], B = ["200 mm", 0] }, start = { angle = 0.3 } }
bodies.bob = { mass = 1, inertia = 1e-2, points = { B = [0, 0] }, start = { angle_rate = 1, angle = 0.1 } }
joints.O = { type = "revolute", between = ["frame.O", "bar.A"] }
joints.B = { type = "revolute_clearance", bearing = "bar.B", journal = "bob.B", bearing_radius = 0.01, radial_clearance = 1e-4, width = 0.02, contact = "c" }
materials.m = { young_modulus = "200 GPa", poisson_ratio = 0.3 }
[contacts.c]
bearing_material = "m"
journal_material = "m"
onset_speed_floor = 1e-3
normal_force = { law = "liu", damping = { law = "lankarani_nikravesh", restitution = 0.9 } }
friction = { law = "lugre", kinetic_coefficient = 0.1, static_coefficient = 0.15 }
wear = { law = "archard", coefficient = "8e-14 1/Pa", bearing_share = 0.4 }
[loads]
f = { type = "force", point = "bar.B", force = [1, 2] }
m = { type = "torque", body = "bar", torque = 0.5 }
s = { type = "spring", between = ["bar.B", "frame.S"], stiffness = 100, damping = 1, free_length = 0.2 }
t = { type = "torsion_spring", between = ["bar", "frame"], stiffness = 1, damping = 0.1, free_angle = 0.2 }
b = { type = "bushing", between = ["bar.B", "bob.B"], stiffness = [1, 1], damping = [1, 1], angular_stiffness = 1, angular_damping = 1, free_angle = 0 }
[study]
cycle_time = 0.1
cycles = 2
warm_up_cycles = 1
wear_stages = 1
wear_acceleration = 2
cells = 100
outputs_per_cycle = 50
relative_tolerance = 1e-6
absolute_tolerance = 1e-9
max_step = 1e-3
)",
             out);
  std::fclose(out);
  EXPECT_GT(check_each_value(file), 150);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace gudgeon
