// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Rules of loads, formulas, curves and motions, each broken alone.
#include "tests/model/broken_model.h"

namespace gudgeon::broken {
namespace {

class CheckFunctionsFinds : public testing::TestWithParam<Broken> {};

TEST_P(CheckFunctionsFinds, TheBrokenRule) { expect_found(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Loads, CheckFunctionsFinds,
    testing::Values(
        Broken{"E-MODEL-050", "loads.x.axes", "Did you mean 'slider'?",
               with_load(VariableForce{{"slider", "S"}, 0.0, 0.0, "slidr"})},
        Broken{"E-MODEL-050", "loads.x.against", "unknown body", with_load(VariableTorque{"crank", "nobody", 1.0})},
        Broken{"E-MODEL-051", "loads.x.against", "against it", with_load(VariableTorque{"crank", "crank", 1.0})},
        Broken{"E-MODEL-005", "loads.x.force.1", "y of force is nan",
               with_load(VariableForce{{"slider", "S"}, 0.0, kNan, "frame"})},
        Broken{"E-MODEL-051", "loads.x.between", "with itself",
               with_load(Spring{{"crank", "O"}, {"crank", "A"}, 1.0, 0.0, 0.1})},
        Broken{"E-MODEL-022", "loads.x.between.1", "no point 'Q'",
               with_load(Spring{{"crank", "O"}, {"rod", "Q"}, 1.0, 0.0, 0.1})},
        Broken{"E-MODEL-052", "loads.x.stiffness", "stiffness is -1 N/m; it must be not negative",
               with_load(Spring{{"crank", "O"}, {"rod", "S"}, -1.0, 0.0, 0.1})},
        Broken{"E-MODEL-052", "loads.x.damping", "N s/m",
               with_load(Spring{{"crank", "O"}, {"rod", "S"}, 1.0, -1.0, 0.1})},
        Broken{"E-MODEL-052", "loads.x.free_length", "free_length is -0.1 m",
               with_load(Spring{{"crank", "O"}, {"rod", "S"}, 1.0, 0.0, -0.1})},
        Broken{"R-MODEL-109", "loads.x", "neither stiffness nor damping",
               with_load(Spring{{"crank", "O"}, {"rod", "S"}, 0.0, 0.0, 0.1})},
        Broken{"E-MODEL-050", "loads.x.between.1", "unknown body",
               with_load(TorsionSpring{"crank", "r", 1.0, 0.0, 0.0})},
        Broken{"E-MODEL-051", "loads.x.between", "against it", with_load(TorsionSpring{"rod", "rod", 1.0, 0.0, 0.0})},
        Broken{"E-MODEL-052", "loads.x.stiffness", "N m/rad", with_load(TorsionSpring{"rod", "crank", -1.0, 0.0, 0.0})},
        Broken{"E-MODEL-005", "loads.x.free_angle", "finite", with_load(TorsionSpring{"rod", "crank", 1.0, 0.0, kNan})},
        Broken{"E-MODEL-052", "loads.x.stiffness.1", "stiffness: y is -2 N/m",
               with_load(Bushing{{"crank", "O"}, {"rod", "S"}, {1.0, -2.0}, {}, 0.0, 0.0, 0.0})},
        Broken{"E-MODEL-052", "loads.x.angular_damping", "N m s/rad",
               with_load(Bushing{{"crank", "O"}, {"rod", "S"}, {1.0, 2.0}, {}, 0.0, -1.0, 0.0})},
        Broken{"R-MODEL-108", "loads.x.point", "the frame alone", with_load(ConstantForce{{"frame", "O"}, {1.0, 0.0}})},
        Broken{"R-MODEL-108", "loads.x.body", "the frame alone", with_load(ConstantTorque{"frame", 1.0})}));

INSTANTIATE_TEST_SUITE_P(
    Functions, CheckFunctionsFinds,
    testing::Values(Broken{"E-MODEL-082", "loads.x.torque", "uses unknown name 'slider.S.xvelocity'",
                           with_load(torque_of(Expression{"-slider.S.xvelocity", {}}))},
                    Broken{"E-MODEL-082", "loads.x.torque", "channels of 'slider' are: slider.x, slider.y",
                           with_load(torque_of(Expression{"slider.S.xvelocity", {}}))},
                    Broken{"E-MODEL-082", "loads.x.torque", "Did you mean 'sqrt'?",
                           with_load(torque_of(Expression{"sqr(t)", {}}))},
                    Broken{"E-MODEL-083", "loads.x.torque", "forces, accelerations and contacts depend on the loads",
                           with_load(torque_of(Expression{"A.normal_force", {}}))},
                    Broken{"E-MODEL-083", "loads.x.torque", "uses 'guide.left_force', which is a result",
                           with_load(torque_of(Expression{"guide.left_force", {}}))},
                    Broken{"E-MODEL-083", "loads.x.torque", "uses 'guide.n_contacts', which is a result",
                           with_load(torque_of(Expression{"guide.n_contacts", {}}))},
                    Broken{"E-MODEL-083", "loads.x.torque", "uses 'A.bristle', which is a result",
                           with_load(torque_of(Expression{"A.bristle", {}}))},
                    Broken{"E-MODEL-083", "loads.x.torque", "uses 'push.power', which is a result",
                           with_load(torque_of(Expression{"push.power", {}}))},
                    Broken{"E-MODEL-083", "loads.x.torque", "uses 'brake.torque', which is a result",
                           with_load(torque_of(Expression{"brake.torque", {}}))},
                    Broken{"E-MODEL-083", "loads.x.torque", "uses 'energy.friction', which is a result",
                           with_load(torque_of(Expression{"energy.friction", {}}))},
                    Broken{"E-MODEL-081", "loads.x.torque", "a closing ')' is missing",
                           with_load(torque_of(Expression{"2*(t", {}}))},
                    Broken{"E-MODEL-081", "loads.x.torque", "it is empty", with_load(torque_of(Expression{"", {}}))},
                    Broken{"E-MODEL-080", "loads.x.constants.t", "name of the time",
                           with_load(torque_of(Expression{"t", {{"t", 1.0}}}))},
                    Broken{"E-MODEL-080", "loads.x.constants.pi", "name of π",
                           with_load(torque_of(Expression{"pi", {{"pi", 3.0}}}))},
                    Broken{"E-MODEL-080", "loads.x.constants.sin", "name of a function",
                           with_load(torque_of(Expression{"1", {{"sin", 1.0}}}))},
                    Broken{"E-MODEL-080", "loads.x.constants.2k", "does not begin with a digit",
                           with_load(torque_of(Expression{"1", {{"2k", 1.0}}}))},
                    Broken{"E-MODEL-080", "loads.x.constants.k", "given twice",
                           with_load(torque_of(Expression{"k", {{"k", 1.0}, {"k", 2.0}}}))},
                    Broken{"E-MODEL-080", "loads.x.constants.k", "not finite",
                           with_load(torque_of(Expression{"k", {{"k", kNan}}}))},
                    Broken{"E-MODEL-082", "loads.x.torque.over", "Did you mean 'crank.angle'?",
                           with_load(torque_of(SampledCurve{"crank.angel", {0, 1}, {0, 1}, false}))},
                    Broken{"E-MODEL-084", "loads.x.torque.values", "2 arguments and 3 values",
                           with_load(torque_of(SampledCurve{"t", {0, 1}, {0, 1, 2}, false}))},
                    Broken{"E-MODEL-084", "loads.x.torque.arguments", "has 1 points",
                           with_load(torque_of(SampledCurve{"t", {0}, {0}, false}))},
                    Broken{"E-MODEL-084", "loads.x.torque.arguments", "needs at least 3",
                           with_load(torque_of(SampledCurve{"t", {0, 1}, {0, 0}, true}))},
                    Broken{"E-MODEL-085", "loads.x.torque.arguments.2", "entry 2 is 1 and entry 3 is 1",
                           with_load(torque_of(SampledCurve{"t", {0, 1, 1}, {0, 0, 0}, false}))},
                    Broken{"E-MODEL-005", "loads.x.torque.values.1", "entry 2 of values is nan",
                           with_load(torque_of(SampledCurve{"t", {0, 1}, {0, kNan}, false}))},
                    Broken{"E-MODEL-086", "loads.x.torque.values.2", "begins with 0 and ends with 1",
                           with_load(torque_of(SampledCurve{"t", {0, 1, 2}, {0, 2, 1}, true}))}));

INSTANTIATE_TEST_SUITE_P(
    Motions, CheckFunctionsFinds,
    testing::Values(Broken{"E-MODEL-083", "drivers.crank.motion", "a motion may depend on the time t only",
                           with_motion(Expression{"rod.angle", {}})},
                    Broken{"E-MODEL-082", "drivers.crank.motion", "possible: t, pi, k",
                           with_motion(Expression{"k*tt", {{"k", 1.0}}})},
                    Broken{"E-MODEL-083", "drivers.crank.motion.over", "time t only",
                           with_motion(SampledCurve{"rod.angle", {0, 10}, {0, 1}, false})},
                    Broken{"E-MODEL-087", "drivers.crank.motion.arguments",
                           "from 0 s to 9.5 s, and the study runs from 0 s to 10 s",
                           with_motion(SampledCurve{"t", {0, 9.5}, {0, 1}, false})},
                    Broken{"E-MODEL-087", "drivers.crank.motion.arguments", "periodic",
                           with_motion(SampledCurve{"t", {0.1, 11}, {0, 1}, false})},
                    Broken{"E-MODEL-088", "drivers.crank.motion", "no value at t = 8.01 s",
                           with_motion(Expression{"sqrt(8 - t)", {}})},
                    Broken{"R-MODEL-107", "drivers.crank.motion", "starts at 0.5 rad, body 'crank' at 1 rad",
                           [](Model& m) {
                             with_motion(Expression{"0.5 + t", {}})(m);
                             m.mechanism.bodies[1].start.angle = 1.0;
                           }},
                    Broken{"E-MODEL-040", "drivers.crank.against", "against unknown body 'rood'",
                           [](Model& m) {
                             m.mechanism.drivers[0].target = DrivenAngle{"crank", "rood"};
                           }},
                    Broken{"E-MODEL-044", "drivers.crank.against", "against itself",
                           [](Model& m) {
                             m.mechanism.drivers[0].target = DrivenAngle{"crank", "crank"};
                           }},
                    Broken{"E-MODEL-041", "drivers.crank.body", "drive body 'crank' instead",
                           [](Model& m) {
                             m.mechanism.drivers[0].target = DrivenAngle{"frame", "crank"};
                           }},
                    Broken{"E-MODEL-042", "drivers.two",
                           "the angle between bodies 'crank' and 'rod' has more than one driver",
                           [](Model& m) {
                             m.mechanism.drivers[0].target = DrivenAngle{"rod", "crank"};
                             m.mechanism.drivers.push_back({"two", DrivenAngle{"crank", "rod"}, 0.0, 1.0});
                           }},
                    Broken{"E-MODEL-043", "drivers.crank.slide", "a joint with clearance cannot be driven",
                           [](Model& m) { m.mechanism.drivers[0].target = DrivenSlide{"A"}; }},
                    Broken{"E-STUDY-012", "study.cycle_driver", "motion",
                           [](Model& m) {
                             m.mechanism.drivers[0].motion = Expression{"t", {}};
                           }},
                    Broken{"E-STUDY-013", "study", "cycle_time is missing", [](Model& m) {
                             m.mechanism.drivers[0].motion = Expression{"t", {}};
                             m.study.cycle_driver = "";
                           }}));

}  // namespace
}  // namespace gudgeon::broken
