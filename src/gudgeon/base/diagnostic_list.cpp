// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A code once given keeps its meaning for good; those that are no longer needed are not used again.
#include "gudgeon/base/diagnostic_list.h"

#include <array>

namespace gudgeon {

namespace {

constexpr std::array<DiagnosticEntry, 131> kDiagnostics{{
    {"E-TOML-001", "the file is not valid TOML"},
    {"E-TOML-002", "tables and arrays nest deeper than 32 levels"},
    {"E-FILE-001", "a key that this table does not have"},
    {"E-FILE-002",
     "a key that must be given is missing; of a body that may be the frame under another name, with how that is "
     "called"},
    {"E-FILE-003", "a value of the wrong kind: text for number, array for table …"},
    {"E-FILE-004", "a text that is not a quantity, or a number that is not finite"},
    {"E-FILE-005", "a quantity of the wrong dimension"},
    {"E-FILE-006", "a choice, type or law that does not exist"},
    {"E-FILE-007", "not a whole number from -1 000 000 000 to 1 000 000 000"},
    {"E-FILE-008", "a point not written as \"body.point\""},
    {"E-FILE-009", "the case asked for does not exist"},
    {"E-FILE-010", "an override of something that the model does not have"},
    {"E-FILE-011", "a contact names an unknown material"},
    {"E-FILE-012", "a joint names an unknown contact"},
    {"E-FILE-013", "two keys that exclude each other"},
    {"E-FILE-014", "bearing_share is not from 0 to 1"},
    {"E-FILE-015", "a name or text holds a control character"},
    {"E-FILE-016",
     "a value too large or too small to be computed with: in SI it is 0 or from 1e-100 to 1e100 in size; values of "
     "curves may be smaller"},
    {"E-FILE-017", "a key is given under its present and under its old name"},
    {"R-FILE-001", "a contact that no joint uses; its values are not checked"},
    {"R-FILE-002", "an old name of a key; it is read as the present one"},
    {"E-MODEL-001", "a name that is empty or has other letters than A-Z, a-z, 0-9, _"},
    {"E-MODEL-002", "a name given twice"},
    {"E-MODEL-003", "a mass that is not positive"},
    {"E-MODEL-004", "an inertia that is negative"},
    {"E-MODEL-005", "a value that is not finite"},
    {"E-MODEL-006", "a point mass (inertia 0) that no ideal joint holds"},
    {"E-MODEL-007", "the first body is not the frame"},
    {"E-MODEL-008", "no moving body"},
    {"E-MODEL-012", "a radius, length, clearance or width of a clearance joint is not positive"},
    {"E-MODEL-013", "radial_clearance is not below bearing_radius"},
    {"E-MODEL-014", "a block that is not shorter than its slot"},
    {"E-MODEL-015", "corner_radius above half the block's length or height"},
    {"E-MODEL-016", "a pin too thick for the length of its slot"},
    {"E-MODEL-017", "a block that could turn over in its slot"},
    {"E-MODEL-018", "a friction law with bristles for an ideal pin in a slot"},
    {"E-MODEL-021", "an unknown body"},
    {"E-MODEL-022", "an unknown point of a body"},
    {"E-MODEL-023", "a joint connects a body with itself"},
    {"E-MODEL-030", "a law's parameter is out of its range"},
    {"E-MODEL-031", "a material's Young's modulus is not positive, or its Poisson's ratio not in [0, 0.5)"},
    {"E-MODEL-032", "a clearance joint without contact"},
    {"E-MODEL-033", "onset_speed_floor is not positive"},
    {"E-MODEL-034", "a contact without material"},
    {"E-MODEL-035", "two parameters of a law that do not fit each other"},
    {"E-MODEL-036", "a law of a round bearing in a guide or a slot, whose bearing is flat"},
    {"E-MODEL-040", "a driver of an unknown body or joint"},
    {"E-MODEL-041", "a driver of the frame"},
    {"E-MODEL-042", "two drivers of one angle, against the frame or between two bodies, or of one joint"},
    {"E-MODEL-043", "a slide driver of a joint that is not prismatic, or that has clearance"},
    {"E-MODEL-044", "a driver of a body against itself"},
    {"E-MODEL-045",
     "more drivers than degrees of freedom, and they ask for positions that exclude each other; without drivers the "
     "joints close"},
    {"E-MODEL-050", "a load that names an unknown body"},
    {"E-MODEL-051", "a load of a body against itself"},
    {"E-MODEL-052", "a negative stiffness, damping or free_length"},
    {"E-MODEL-060", "guides or rigid joints ask for two different relative angles"},
    {"E-MODEL-061", "a driver of an angle that is held or driven already"},
    {"E-MODEL-062",
     "a driver's motion that cannot be read, has no value somewhere in the first cycle, or is not smooth: its value, "
     "speed or acceleration jumps at some time of the study"},
    {"E-MODEL-070", "a joint that cannot be closed, with its gap; a driver between two bodies that cannot be followed"},
    {"E-MODEL-071", "start rates that contradict each other, the joints or the drivers"},
    {"E-MODEL-072", "drivers that ask for speeds the joints do not permit"},
    {"E-MODEL-073", "a singular start"},
    {"E-MODEL-074", "a journal that starts beyond its bearing's surface or past the end of its slot"},
    {"E-MODEL-075", "a spring whose two points coincide at the start"},
    {"E-MODEL-076", "a body without inertia about the point it turns about, on whose angle something acts"},
    {"E-MODEL-077", "a branch that none of all assemblies has"},
    {"E-MODEL-078", "a branch of a joint that closes no loop"},
    {"E-MODEL-079", "kinematics of a mechanism that drivers do not move completely"},
    {"E-MODEL-080",
     "a constant of a formula: its name is not plain, is taken by t, pi or a function, or its value is not finite"},
    {"E-MODEL-081", "not a valid expression"},
    {"E-MODEL-082", "a formula or curve names something that does not exist"},
    {"E-MODEL-083",
     "a formula or curve names something that it may not depend on: a result, or in a motion anything but t"},
    {"E-MODEL-084", "a curve with too few points, or with another number of values than of arguments"},
    {"E-MODEL-085", "a curve's arguments do not increase"},
    {"E-MODEL-086", "a periodic curve that ends with another value than it begins with"},
    {"E-MODEL-087", "a driver's curve that does not cover the study"},
    {"E-MODEL-088", "a driver's formula that has no value at some time of the study"},
    {"E-MODEL-089", "a load's formula that has no finite value at the start"},
    {"E-MODEL-090", "a motion's curve with an interpolation that lets its speed or acceleration jump"},
    {"E-MODEL-091",
     "smoothing of a curve that leaves nothing or everything of its points, or that no smooth curve meets"},
    {"E-MODEL-092",
     "a joint with friction whose reaction is not determined, because constraints imply each other: the joints that "
     "share it are listed"},
    {"E-MODEL-093", "friction of a joint that jams at the start"},
    {"W-MODEL-115",
     "a load's curve without `interpolation` that would run quite otherwise as a spline: by more than 1 % of its "
     "range"},
    {"W-MODEL-117", "noise in a motion's points makes its acceleration; tells the ratio, and a smoothing"},
    {"R-MODEL-101", "the contact law delivers another restitution than it was asked for"},
    {"R-MODEL-102", "static friction below kinetic friction"},
    {"R-MODEL-103", "radial_clearance above 10 % of bearing_radius"},
    {"R-MODEL-104", "bristle friction that is not certain to dissipate: σ₂ < σ₁ (μ_s − μ_k)/μ_k"},
    {"R-MODEL-105", "a body that no joint touches; it moves freely"},
    {"R-MODEL-106", "bodies that no joint ties to the frame"},
    {"R-MODEL-107",
     "a driver and its body or guide start at different angles, displacements or rates; the driver's holds"},
    {"R-MODEL-108", "a load on the frame alone"},
    {"R-MODEL-109", "a spring or bushing without stiffness and damping"},
    {"R-MODEL-110",
     "a start angle that the run does not start with: the body's joints, or a body tied to it, give it another"},
    {"R-MODEL-111",
     "guesses that the mechanism does not start with: start angles, displacements and places that closed loops "
     "determine, the farthest named"},
    {"R-MODEL-112", "a journal that starts off the middle of its bearing"},
    {"R-MODEL-113", "no ideal stage: the mechanism closes, or starts as asked, only thanks to its clearance"},
    {"R-MODEL-116", "a spline that leaves the range of its neighbouring points by more than 1 % of the curve's range"},
    {"R-MODEL-118", "a chain of powers or comparisons in a formula, and how it is read"},
    {"R-MODEL-120", "radial_clearance outside the 0.005 to 10 mm that pereira was fitted to"},
    {"R-MODEL-130",
     "an inertia whose radius of gyration is far beyond the body: more than five times the distance from its centre of "
     "mass to its farthest point, and more than twice the longest body"},
    {"R-MODEL-131",
     "a length a hundred times the usual one of the model: of a body, start displacement, free length or driven slide"},
    {"R-MODEL-140", "two revolute joints that hold two bodies as one rigid body"},
    {"E-STUDY-001", "cycle_driver is no driver"},
    {"E-STUDY-002", "cycle_driver drives a slide"},
    {"E-STUDY-003", "cycle_driver stands still"},
    {"E-STUDY-004", "cycle_time is not positive"},
    {"E-STUDY-005", "a count is out of its range"},
    {"E-STUDY-006", "wear_acceleration, a tolerance, max_step or a Baumgarte coefficient is out of its range"},
    {"E-STUDY-007", "an unknown measure of a reference value"},
    {"E-STUDY-008", "a reference value without channel"},
    {"E-STUDY-009", "cycle_time disagrees with cycle_driver"},
    {"E-STUDY-012", "cycle_driver has a motion of its own, which need not make turns"},
    {"E-STUDY-013", "cycle_time is missing, and no driver turns uniformly"},
    {"W-STUDY-001", "wear_stages without any wear law"},
    {"W-STUDY-010", "the samples take much room in the run file: more than 4 GB a stage, or 100 GB in all"},
    {"W-STUDY-011", "stages, cycles and samples that take days on any computer, with their numbers"},
    {"R-STUDY-002", "wear_distribution \"point\" does not conserve the worn volume"},
    {"E-NUM-001",
     "the start position does not determine the accelerations: it is singular, or a load has no finite value there"},
    {"E-NUM-002", "a journal starts inside the surface of its bearing"},
    {"E-NUM-003",
     "the step fell below what time can be told apart by (sixteen roundings of the time or of the longest step): a "
     "contact too stiff, a loop that a driver asks beyond its reach, or a load without a finite value (a formula "
     "outside its range, a spring whose points meet)"},
    {"E-NUM-004", "a journal is worn through"},
    {"E-NUM-005", "a corner of a block, or a pin, passed the end of its slot; also where it comes back within a step"},
    {"E-NUM-006",
     "a load jumps back and forth at a condition of its formula, and no force between both sides holds the motion "
     "there: let it change gradually, give joints the friction that is meant, or, where one formula jumps at two "
     "places, write a formula for each"},
    {"E-NUM-007",
     "a joint came open by more than a millionth of the characteristic length: the others hold it to second order "
     "only, or leave it no way on"},
    {"E-NUM-008",
     "the run would not end: steps have become so short that a cycle would take 1e11 evaluations; said with the time "
     "reached, the pace, the largest load and the fastest body"},
    {"E-NUM-010",
     "kinematics: a singular position, drivers that ask for more than the joints permit, or a load without a finite "
     "value"},
    {"E-NUM-011",
     "equilibrium: the loads balance in no position met, the position became singular, or a load has no finite value"},
    {"E-NUM-012",
     "a contact was pressed to where its law of normal force ends: the law, its last force and penetration are told"},
    {"E-NUM-013",
     "a joint jams: no acceleration agrees with its friction, or more than one does (Eq. F15); in kinematics, no force "
     "of the drivers overcomes it"},
    {"E-NUM-020", "the stage finished, but its energy balance does not close (exit code 6)"},
}};

}  // namespace

std::span<const DiagnosticEntry> list_diagnostics() { return kDiagnostics; }

std::string_view severity_of(std::string_view code) {
  switch (code.empty() ? '\0' : code.front()) {
    case 'E':
      return "error";
    case 'W':
      return "warning";
    case 'R':
      return "remark";
    default:
      return "";
  }
}

}  // namespace gudgeon
