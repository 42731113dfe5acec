// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Every rule of the check, each broken alone in a mechanism that is otherwise good.
#include "gudgeon/model/check.h"

#include "tests/model/broken_model.h"

namespace gudgeon::broken {
namespace {

TEST(Check, FindsNothingInAGoodModel) {
  const Model model = make_good();
  EXPECT_EQ(render(check(model.mechanism, model.study), {}), "");
}

Liu make_liu(const AnyDamping& damping) {
  Liu law;
  law.damping = damping;
  return law;
}

TEST(Check, RemarksNoRestitutionThatIsDelivered) {
  Model model = make_good();
  for (const double e : {1e-3, 0.1, 0.5, 1.0}) {
    model.pin().contact.normal_force = DampedHertz<ExactRestitutionDamping>{e};
    EXPECT_EQ(render(check(model.mechanism, model.study), {}), "") << e;
    model.pin().contact.normal_force = make_liu(ExactRestitutionDamping{e});
    EXPECT_EQ(render(check(model.mechanism, model.study), {}), "") << e;
  }
}

class CheckFinds : public testing::TestWithParam<Broken> {};

TEST_P(CheckFinds, TheBrokenRule) { expect_found(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Bodies, CheckFinds,
    testing::Values(
        Broken{"E-MODEL-001", "bodies.a b", "'a b'", [](Model& m) { m.mechanism.bodies[2].name = "a b"; }},
        Broken{"E-MODEL-001", "name", "the mechanism", [](Model& m) { m.mechanism.name = ""; }},
        Broken{"E-MODEL-002", "bodies.crank", "another body", [](Model& m) { m.mechanism.bodies[2].name = "crank"; }},
        Broken{"E-MODEL-003", "bodies.rod.mass", "mass is 0 kg; it must be positive",
               [](Model& m) { m.mechanism.bodies[2].mass = 0.0; }},
        Broken{"E-MODEL-003", "bodies.rod.mass", "nan kg", [](Model& m) { m.mechanism.bodies[2].mass = kNan; }},
        Broken{"E-MODEL-004", "bodies.rod.inertia", "not negative",
               [](Model& m) { m.mechanism.bodies[2].inertia = -1.0; }},
        Broken{"E-MODEL-005", "bodies.rod.points.A", "finite",
               [](Model& m) { m.mechanism.bodies[2].points[0].position.x = kNan; }},
        Broken{"E-MODEL-005", "bodies.rod.start.angle", "finite",
               [](Model& m) { m.mechanism.bodies[2].start.angle = kNan; }},
        Broken{"E-MODEL-005", "gravity", "finite", [](Model& m) { m.mechanism.gravity.y = kNan; }},
        Broken{"E-MODEL-006", "bodies.rod.inertia", "point mass",
               [](Model& m) {
                 m.mechanism.bodies[2].inertia = 0.0;
                 m.mechanism.joints.erase(m.mechanism.joints.begin() + 2);
               }},
        Broken{"E-MODEL-007", "bodies", "frame", [](Model& m) { m.mechanism.bodies.clear(); }},
        Broken{"E-MODEL-008", "bodies", "no moving body", [](Model& m) { m.mechanism.bodies.resize(1); }},
        Broken{"R-MODEL-105", "bodies.stone", "moves freely",
               [](Model& m) {
                 m.mechanism.bodies.push_back({"stone", 1.0, 1.0, {}, {}, {}});
               }},
        Broken{"R-MODEL-106", "bodies.crank", "bodies crank, rod hang together", [](Model& m) {
                 auto& joints = m.mechanism.joints;
                 joints.erase(joints.begin() + 2);
                 joints.erase(joints.begin());
               }}));

INSTANTIATE_TEST_SUITE_P(
    Joints, CheckFinds,
    testing::Values(
        Broken{"E-MODEL-012", "joints.A.radial_clearance",
               "joint 'A': radial_clearance is -0.0005 m; it must be positive",
               [](Model& m) { m.pin().radial_clearance = -0.0005; }},
        Broken{"E-MODEL-012", "joints.A.bearing_radius", "positive", [](Model& m) { m.pin().bearing_radius = 0.0; }},
        Broken{"E-MODEL-012", "joints.A.width", "positive", [](Model& m) { m.pin().width = kNan; }},
        Broken{"E-MODEL-013", "joints.A.radial_clearance", "below the bearing_radius",
               [](Model& m) { m.pin().radial_clearance = 0.01; }},
        Broken{"R-MODEL-103", "joints.A.radial_clearance", "20 %", [](Model& m) { m.pin().radial_clearance = 0.002; }},
        Broken{"E-MODEL-021", "joints.A.journal", "Did you mean 'rod'?",
               [](Model& m) { m.pin().journal.body = "rood"; }},
        Broken{"E-MODEL-022", "joints.O.between.1", "points of 'crank' are: O, A",
               [](Model& m) { std::get<Revolute>(m.mechanism.joints[0].kind).second.point = "Q"; }},
        Broken{"E-MODEL-023", "joints.O.between", "with itself",
               [](Model& m) {
                 std::get<Revolute>(m.mechanism.joints[0].kind).first = {"crank", "A"};
               }},
        Broken{"E-MODEL-005", "joints.guide.direction", "finite",
               [](Model& m) { std::get<Prismatic>(m.mechanism.joints[3].kind).direction = kNan; }},
        Broken{"E-MODEL-030", "contacts.pin.normal_force.restitution", "above 0 and at most 1",
               [](Model& m) { m.pin().contact.normal_force = LankaraniNikravesh{.restitution = 1.5}; }},
        Broken{"E-MODEL-030", "contacts.pin.friction.kinetic_coefficient", "nan",
               [](Model& m) { m.pin().contact.friction = CoulombSmooth{}; }},
        Broken{"E-MODEL-030", "contacts.pin.bearing_wear.coefficient", "1/Pa",
               [](Model& m) { m.pin().contact.bearing_wear = Archard{-1.0}; }},
        Broken{"E-MODEL-031", "materials.steel.young_modulus", "positive",
               [](Model& m) { m.pin().contact.bearing_material.young_modulus = 0.0; }},
        Broken{"E-MODEL-031", "materials.steel.poisson_ratio", "below 0.5",
               [](Model& m) { m.pin().contact.bearing_material.poisson_ratio = 0.5; }},
        Broken{"E-MODEL-032", "joints.A.contact", "no contact", [](Model& m) { m.pin().contact.name = ""; }},
        Broken{"E-MODEL-033", "contacts.pin.onset_speed_floor", "positive",
               [](Model& m) { m.pin().contact.onset_speed_floor = 0.0; }},
        Broken{"E-MODEL-034", "contacts.pin.journal_material", "no material",
               [](Model& m) { m.pin().contact.journal_material = {}; }},
        Broken{"R-MODEL-101", "contacts.pin.normal_force.restitution", "delivers 0.725",
               [](Model& m) { m.pin().contact.normal_force = LankaraniNikravesh{.restitution = 0.5}; }},
        Broken{"R-MODEL-101", "contacts.pin.normal_force.restitution", "lankarani_nikravesh delivers 0.684",
               [](Model& m) { m.pin().contact.normal_force = LankaraniNikravesh{.restitution = 0.3}; }},
        Broken{"R-MODEL-104", "contacts.pin.friction", "(μ_s - μ_k)/μ_k = 158 s/m; σ₂ is 157",
               [](Model& m) { m.pin().contact.friction = Lugre{0.15, 0.1, 1e-3, 2.0, 1e5, 316.0, 157.0}; }},
        Broken{"R-MODEL-101", "contacts.pin.normal_force.restitution", "anagnostopoulos delivers 0.397",
               [](Model& m) {
                 m.pin().contact.normal_force = Anagnostopoulos{1e8, 1.0, 0.3};
               }},
        Broken{"R-MODEL-101", "contacts.pin.normal_force.restitution", "bai_zhao delivers 0.217",
               [](Model& m) { m.pin().contact.normal_force = BaiZhao{0.1}; }},
        Broken{"R-MODEL-101", "contacts.pin.normal_force.damping.restitution", "lee_wang delivers 0.799",
               [](Model& m) { m.pin().contact.normal_force = make_liu(LeeWangDamping{0.5}); }},
        Broken{"E-MODEL-030", "contacts.pin.normal_force.damping.restitution", "above 0 and at most 1",
               [](Model& m) { m.pin().contact.normal_force = make_liu(GonthierDamping{0.0}); }},
        Broken{"E-MODEL-030", "contacts.pin.normal_force.stiffness", "positive",
               [](Model& m) {
                 m.pin().contact.normal_force = KelvinVoigt{0.0, 1.0};
               }},
        Broken{"E-MODEL-036", "contacts.pin.normal_force", "joint 'A': liu is a law of a round bearing",
               [](Model& m) {
                 const ContactProperties contact = m.pin().contact;
                 m.mechanism.joints[1].kind =
                     PinInSlotClearance{{"crank", "A"}, {"rod", "A"}, 0.0, 0.1, 0.01, 0.0005, 0.02, contact};
                 std::get<PinInSlotClearance>(m.mechanism.joints[1].kind).contact.normal_force = Liu{};
               }},
        Broken{"R-MODEL-120", "contacts.pin.normal_force",
               "radial_clearance is 0.004 mm, and pereira was fitted from 0.005",
               [](Model& m) {
                 m.pin().radial_clearance = 4e-6;
                 m.pin().contact.normal_force = Pereira{};
               }},
        Broken{"R-MODEL-102", "contacts.pin.friction.static_coefficient", "below the kinetic", [](Model& m) {
                 m.pin().contact.friction = LugreSteady{.static_coefficient = 0.1, .kinetic_coefficient = 0.2};
               }}));

INSTANTIATE_TEST_SUITE_P(
    DriversLoadsStudy, CheckFinds,
    testing::Values(
        Broken{"E-MODEL-040", "drivers.crank.body", "Did you mean 'crank'?",
               [](Model& m) { m.mechanism.drivers[0].target = DrivenAngle{"crnk"}; }},
        Broken{"E-MODEL-040", "drivers.crank.slide", "joints are: O, A, S, guide",
               [](Model& m) { m.mechanism.drivers[0].target = DrivenSlide{"rail"}; }},
        Broken{"E-MODEL-041", "drivers.crank.body", "frame",
               [](Model& m) { m.mechanism.drivers[0].target = DrivenAngle{"frame"}; }},
        Broken{"E-MODEL-042", "drivers.two", "more than one driver",
               [](Model& m) {
                 m.mechanism.drivers.push_back({"two", DrivenAngle{"crank"}, 0.0, 1.0});
               }},
        Broken{"E-MODEL-043", "drivers.crank.slide", "not prismatic",
               [](Model& m) { m.mechanism.drivers[0].target = DrivenSlide{"O"}; }},
        Broken{"E-MODEL-005", "drivers.crank.speed", "finite", [](Model& m) { m.mechanism.drivers[0].speed = kNan; }},
        Broken{"R-MODEL-107", "drivers.crank.start", "the driver's holds",
               [](Model& m) { m.mechanism.bodies[1].start.angle = 1.0; }},
        Broken{"E-MODEL-050", "loads.brake.body", "unknown body",
               [](Model& m) {
                 m.mechanism.loads[1].kind = ConstantTorque{"x", 1.0};
               }},
        Broken{"E-MODEL-022", "loads.push.point", "no point 'T'",
               [](Model& m) {
                 m.mechanism.loads[0].kind = ConstantForce{{"slider", "T"}, {}};
               }},
        Broken{"E-STUDY-001", "study.cycle_driver", "drivers are: crank", [](Model& m) { m.study.cycle_driver = "x"; }},
        Broken{"E-STUDY-002", "study.cycle_driver", "no turns",
               [](Model& m) { m.mechanism.drivers[0].target = DrivenSlide{"guide"}; }},
        Broken{"E-STUDY-003", "study.cycle_driver", "stands still",
               [](Model& m) { m.mechanism.drivers[0].speed = 0.0; }},
        Broken{"E-STUDY-004", "study.cycle_time", "positive",
               [](Model& m) {
                 m.study.cycle_driver = "";
                 m.study.cycle_time = -1.0;
               }},
        Broken{"E-STUDY-005", "study.cycles", "at least 1", [](Model& m) { m.study.cycles = 0; }},
        Broken{"E-STUDY-005", "study.warm_up_cycles", "not negative", [](Model& m) { m.study.warm_up_cycles = -1; }},
        Broken{"E-STUDY-005", "study.wear_stages", "not negative", [](Model& m) { m.study.wear_stages = -1; }},
        Broken{"E-STUDY-005", "study.cells", "at least 10 and at most 1e+06", [](Model& m) { m.study.cells = 9; }},
        Broken{"E-STUDY-005", "study.outputs_per_cycle", "at least 1", [](Model& m) { m.study.outputs_per_cycle = 0; }},
        Broken{"E-STUDY-006", "study.wear_acceleration", "positive", [](Model& m) { m.study.wear_acceleration = 0.0; }},
        Broken{"E-STUDY-006", "study.relative_tolerance", "at least 1e-15 and at most 0.01",
               [](Model& m) { m.study.relative_tolerance = 0.1; }},
        Broken{"E-STUDY-006", "study.max_step", "not negative", [](Model& m) { m.study.max_step = -1.0; }},
        Broken{"E-STUDY-007", "study.reference.0.measure", "Did you mean 'peak'?",
               [](Model& m) {
                 m.study.reference = {{"q", "c", "peek", {}}};
               }},
        Broken{"E-STUDY-008", "study.reference.0.channel", "empty",
               [](Model& m) {
                 m.study.reference = {{"q", "", "peak", {}}};
               }},
        Broken{"E-STUDY-009", "study.cycle_time", "one turn", [](Model& m) { m.study.cycle_time = 1.0; }},
        Broken{"W-STUDY-001", "study.wear_stages", "no contact of a joint wears",
               [](Model& m) { m.pin().contact.bearing_wear = m.pin().contact.journal_wear = NoWear{}; }},
        Broken{"W-STUDY-010", "study.outputs_per_cycle", "GB of the run file a stage",
               [](Model& m) { m.study.outputs_per_cycle = 1000000; }},
        Broken{"W-STUDY-010", "study.wear_stages", "GB of the run file",
               [](Model& m) { m.study.wear_stages = 100000; }},
        Broken{"W-STUDY-011", "study.wear_stages", "days", [](Model& m) { m.study.wear_stages = 1000000000; }},
        Broken{"W-STUDY-011", "study.warm_up_cycles", "days", [](Model& m) { m.study.warm_up_cycles = 1000000000; }},
        Broken{"W-STUDY-011", "study.cycles", "days", [](Model& m) { m.study.cycles = 1000000000; }},
        Broken{"W-STUDY-011", "study.outputs_per_cycle", "days",
               [](Model& m) { m.study.cycles = 100, m.study.outputs_per_cycle = 1000000000; }},
        Broken{"R-STUDY-002", "study.wear_distribution", "conserve",
               [](Model& m) { m.study.wear_distribution = WearDistribution::point; }}));

TEST(Check, CountsWhatALargeStudyAsksFor) {
  Model model = make_good();
  model.study.cycles = 20;
  model.study.warm_up_cycles = 30;
  model.study.wear_stages = 1000000;
  const Diagnostics found = check(model.mechanism, model.study);
  // 1 000 002 stages of 50 cycles at 1 ms, and 20 * 500 samples of each at 1 µs: 60 000 s.
  EXPECT_EQ(render(found, {}).find("W-STUDY-011"), std::string::npos) << render(found, {});
  model.study.warm_up_cycles = 80;
  EXPECT_NE(render(check(model.mechanism, model.study), {})
                .find("1000002 stages of 100 cycles, 80 of them to warm up, are 1e+08 cycles and 1e+10 samples"),
            std::string::npos);
}

/// A load on the good model's bodies, under the name "x".
TEST(Check, AcceptsWhatIsRight) {
  Model model = make_good();
  with_guide(0.2, 0.03, 0.01, 0.0001)(model);
  std::get<PrismaticClearance>(model.mechanism.joints[3].kind).contact.normal_force = Hertz{};
  with_motion(Expression{"a*sin(2*pi*t)", {{"a", 0.3}}})(model);
  with_load(torque_of(Expression{"slider.S.x > 0 ? -guide.speed : max(crank.angle, frame.O.x)", {}}))(model);
  with_load(Spring{{"crank", "O"}, {"rod", "S"}, 1.0, 0.0, 0.1})(model);
  model.mechanism.loads.back().name = "y";
  const Diagnostics found = check(model.mechanism, model.study);
  EXPECT_FALSE(found.has_errors()) << render(found, {});
  model.mechanism.drivers[0].motion = SampledCurve{"t", {0.0, 0.5, 1.0}, {0.0, 1.0, 0.0}, true};
  EXPECT_FALSE(check(model.mechanism, model.study).has_errors());
}

TEST(Check, ReportsEverythingAtOnce) {
  Model model = make_good();
  model.mechanism.bodies[1].mass = 0.0;
  model.pin().width = 0.0;
  model.study.cycles = 0;
  EXPECT_EQ(check(model.mechanism, model.study).items().size(), 3U);
}

TEST(Check, IsSilentOnBristlesThatDissipate) {
  Model model = make_good();
  model.pin().contact.friction = Lugre{0.15, 0.1, 1e-3, 2.0, 1e5, 316.0, 158.1};
  EXPECT_TRUE(check(model.mechanism, model.study).items().empty());
}

TEST(Check, ShowsHowAValueWasWritten) {
  Model model = make_good();
  model.pin().radial_clearance = -0.0005;
  SourceMap source;
  source.written["joints.A.radial_clearance"] = "\"-0.5 mm\"";
  EXPECT_EQ(check(model.mechanism, model.study, &source).items()[0].message,
            "joint 'A': radial_clearance is \"-0.5 mm\" (-0.0005 m); it must be positive");
}

}  // namespace
}  // namespace gudgeon::broken
