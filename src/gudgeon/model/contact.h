// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Materials, and how the surfaces of a joint with clearance act on each other.
#pragma once

#include <array>
#include <span>
#include <string>
#include <utility>

#include "gudgeon/laws/friction/any.h"
#include "gudgeon/laws/normal/any.h"
#include "gudgeon/laws/wear/any.h"
#include "gudgeon/model/field.h"

namespace gudgeon {

/// A [materials.NAME] table of the model file.
struct Material {
  std::string name;
  double young_modulus = 0.0;  ///< E [Pa]
  double poisson_ratio = 0.0;  ///< ν [1]

  static constexpr std::string_view kMeaning = "an elastic material";
  static constexpr auto kFields = std::tuple{
      field("young_modulus", &Material::young_modulus,
            {.required = true,
             .dimension = dimension::kPressure,
             .symbol = "E",
             .range = kPositive,
             .code = "E-MODEL-031",
             .meaning = "Young's modulus"}),
      field("poisson_ratio", &Material::poisson_ratio,
            {.required = true,
             .symbol = "ν",
             .range = ParameterRange{0.0, 0.5, false, true},
             .code = "E-MODEL-031",
             .meaning = "Poisson's ratio"}),
  };
};

/// Along which direction a worn surface presses.
enum class NormalDirection {
  gap_gradient,  ///< the normal of the worn surface: elastic contact conserves energy (default)
  eccentricity,  ///< the line of centres, as in the paper
};

inline constexpr std::array<std::pair<std::string_view, NormalDirection>, 2> kNormalDirections{{
    {"gap_gradient", NormalDirection::gap_gradient},
    {"eccentricity", NormalDirection::eccentricity},
}};
constexpr std::span<const std::pair<std::string_view, NormalDirection>> choices(NormalDirection /*kind*/) {
  return kNormalDirections;
}

/// How the pressure of a contact is spread over its arc; a is half the arc, x the place on it from its middle.
enum class PressureDistribution {
  uniform,    ///< p = F/(w L) everywhere, as in the paper (default)
  parabolic,  ///< 3/2 of that at the middle, p ∝ 1 − (x/a)², as between bodies that fit closely
};

inline constexpr std::array<std::pair<std::string_view, PressureDistribution>, 2> kPressureDistributions{{
    {"uniform", PressureDistribution::uniform},
    {"parabolic", PressureDistribution::parabolic},
}};
constexpr std::span<const std::pair<std::string_view, PressureDistribution>> choices(PressureDistribution /*kind*/) {
  return kPressureDistributions;
}

/// How bearing and journal surfaces act on each other: a [contacts.NAME] table of the model file.
struct ContactProperties {
  std::string name;
  Material bearing_material;
  Material journal_material;
  AnyNormalForce normal_force;
  AnyFriction friction;
  AnyWear bearing_wear = NoWear{};
  AnyWear journal_wear = NoWear{};
  double onset_speed_floor = 1e-3;  ///< [m/s] least onset speed the damping is scaled with
  NormalDirection normal_direction = NormalDirection::gap_gradient;
  PressureDistribution pressure = PressureDistribution::uniform;

  static constexpr std::string_view kMeaning = "how the surfaces of joints with clearance act on each other";
  static constexpr auto kFields = std::tuple{
      field("bearing_material", &ContactProperties::bearing_material, {.required = true, .meaning = "of the bearing"}),
      field("journal_material", &ContactProperties::journal_material, {.required = true, .meaning = "of the journal"}),
      field("normal_force", &ContactProperties::normal_force, {.meaning = "how they press on each other"}),
      field("friction", &ContactProperties::friction, {.meaning = "how they rub on each other"}),
      field("bearing_wear", &ContactProperties::bearing_wear, {.meaning = "what the bearing loses"}),
      field("journal_wear", &ContactProperties::journal_wear, {.meaning = "what the journal loses"}),
      field("onset_speed_floor", &ContactProperties::onset_speed_floor,
            {.dimension = dimension::kSpeed,
             .range = kPositive,
             .code = "E-MODEL-033",
             .meaning = "least onset speed that damping is scaled with"}),
      field("normal_direction", &ContactProperties::normal_direction,
            {.meaning = "along which worn surfaces press: the normal of the worn surface, or the line of centres"}),
      field("pressure", &ContactProperties::pressure, {.meaning = "over the contact arc, for wear"}),
  };
};

/// In place of bearing_wear and journal_wear: the wear of both, shared out between them.
inline constexpr std::string_view kTotalWearKey = "wear";
inline constexpr std::string_view kBearingShareKey = "bearing_share";
inline constexpr double kDefaultBearingShare = 0.5;
inline constexpr ParameterRange kShareRange{0.0, 1.0, false, false};

}  // namespace gudgeon
