// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Rules for materials and laws. Ranges come from the laws' own parameter tables.
#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <set>

#include "gudgeon/laws/damping/delivered_restitution.h"
#include "gudgeon/model/check_fields.h"

namespace gudgeon {

namespace {

// A restitution delivered within this of the one asked for is what the user meant.
constexpr double kRestitutionMargin = 0.045;

template <class Law>
void check_parameters(CheckRules& rules, const Law& law, const std::string& subject, const std::string& path) {
  for (const Parameter<Law>& parameter : Law::kParameters) {
    const std::string parameter_path = fmt::format("{}.{}", path, parameter.key);
    rules.check_range("E-MODEL-030", {subject, parameter_path, law.*parameter.member, parameter.dimension},
                      parameter.range);
  }
  if constexpr (requires { law.find_conflict(); }) {
    if (const std::string_view conflict = law.find_conflict(); !conflict.empty()) {
      rules.diagnostics.error("E-MODEL-035", path, fmt::format("{}: {}", subject, conflict));
    }
  }
  if constexpr (NestsDamping<Law>) {
    std::visit([&](const auto& damping) { check_parameters(rules, damping, subject + ".damping", path + ".damping"); },
               law.damping);
  }
}

/// The value of the parameter with that symbol in the law's formula.
template <class Law>
std::optional<double> find_parameter(const Law& law, std::string_view symbol) {
  for (const Parameter<Law>& parameter : Law::kParameters) {
    if (parameter.symbol == symbol) return law.*parameter.member;
  }
  return std::nullopt;
}

/// The restitution of an impact under a law or damping form.
template <class Law>
double find_delivered(const Law& law) {
  if constexpr (requires { law.delivered_restitution(); }) {
    return law.delivered_restitution();
  } else {
    const double factor = law.damping_factor();
    return factor > 0.0 ? find_delivered_restitution(factor) : 1.0;
  }
}

template <class Law>
void remark_restitution(CheckRules& rules, const Law& law, const std::string& subject, const std::string& path) {
  if constexpr (NestsDamping<Law>) {
    std::visit([&](const auto& damping) { remark_restitution(rules, damping, subject, path + ".damping"); },
               law.damping);
  }
  if constexpr (requires { law.restitution; }) {
    if (!kRestitutionRange.contains(law.restitution)) return;  // an error already
    const double delivered = find_delivered(law);
    if (std::abs(delivered - law.restitution) <= kRestitutionMargin) return;
    rules.diagnostics.remark("R-MODEL-101", path + ".restitution",
                             fmt::format("{}: restitution is {:.6g}, but {} delivers {:.3f}", subject, law.restitution,
                                         Law::kName, delivered),
                             {"exact_restitution delivers what it is asked for"});
  }
}

template <class Law>
void remark_friction(CheckRules& rules, const Law& law, const std::string& subject, const std::string& path) {
  const auto static_coefficient = find_parameter(law, "μ_s");
  const auto kinetic_coefficient = find_parameter(law, "μ_k");
  if (!static_coefficient || !kinetic_coefficient) return;
  if (*static_coefficient < *kinetic_coefficient) {
    rules.diagnostics.remark("R-MODEL-102", path + ".static_coefficient",
                             fmt::format("{}: static_coefficient is {:.6g}, below the kinetic_coefficient, {:.6g}",
                                         subject, *static_coefficient, *kinetic_coefficient));
  }
  // Bristles with too little viscous friction can give back more energy than they took.
  const auto bristle_damping = find_parameter(law, "σ₁");
  const auto viscous = find_parameter(law, "σ₂");
  if (!bristle_damping || !viscous || !(*kinetic_coefficient > 0.0)) return;
  const double least = *bristle_damping * (*static_coefficient - *kinetic_coefficient) / *kinetic_coefficient;
  if (*viscous >= least) return;
  rules.diagnostics.remark(
      "R-MODEL-104", path,
      fmt::format("{}: dissipation is certain only for σ₂ >= σ₁ (μ_s - μ_k)/μ_k = {:.6g} s/m; σ₂ is {:.6g}", subject,
                  least, *viscous));
}

/// Cylindrical laws ask for two radii, and one for a range of their difference.
void check_geometry(CheckRules& rules, const Joint& joint, const ContactProperties& contact) {
  const auto* revolute = std::get_if<RevoluteClearance>(&joint.kind);
  const std::string subject = fmt::format("joint '{}'", joint.name);
  const std::string path = fmt::format("contacts.{}.normal_force", contact.name);
  std::visit(
      [&]<class Law>(const Law& /*law*/) {
        if constexpr (NeedsRoundBearing<Law>) {
          if (revolute == nullptr) {
            rules.diagnostics.error(
                "E-MODEL-036", path,
                fmt::format("{}: {} is a law of a round bearing, and this one is flat", subject, Law::kName),
                {"a revolute_clearance has a round bearing; elsewhere take a point law as hertz"});
          }
        }
        if constexpr (std::same_as<Law, Pereira>) {
          if (revolute != nullptr && !kPereiraClearance.contains(revolute->radial_clearance)) {
            rules.diagnostics.remark("R-MODEL-120", path,
                                     fmt::format("{}: radial_clearance is {:.6g} mm, and pereira was fitted from "
                                                 "{:.6g} to {:.6g} mm",
                                                 subject, 1e3 * revolute->radial_clearance,
                                                 1e3 * kPereiraClearance.minimum, 1e3 * kPereiraClearance.maximum));
          }
        }
      },
      contact.normal_force);
}

void check_material(CheckRules& rules, const Material& material) {
  const std::string subject = fmt::format("material '{}'", material.name);
  const std::string path = fmt::format("materials.{}", material.name);
  rules.check_name("a material", path, material.name);
  FieldCheck(rules, subject, path).check(material);
}

void check_friction_law(CheckRules& rules, const AnyFriction& any, const std::string& subject,
                        const std::string& path) {
  std::visit(
      [&](const auto& law) {
        check_parameters(rules, law, subject + ": friction", path + ".friction");
        remark_friction(rules, law, subject, path + ".friction");
      },
      any);
}

void check_laws(CheckRules& rules, const ContactProperties& contact, const std::string& subject,
                const std::string& path) {
  const auto check_law = [&](const auto& any, const std::string& key) {
    std::visit([&](const auto& law) { check_parameters(rules, law, subject + ": " + key, path + "." + key); }, any);
  };
  check_law(contact.normal_force, "normal_force");
  check_friction_law(rules, contact.friction, subject, path);
  check_law(contact.bearing_wear, "bearing_wear");
  check_law(contact.journal_wear, "journal_wear");
  std::visit([&](const auto& law) { remark_restitution(rules, law, subject, path + ".normal_force"); },
             contact.normal_force);
}

}  // namespace

void check_joint_friction(CheckRules& rules, const Joint& joint) {
  const JointFriction* friction = find_friction(joint.kind);
  if (friction == nullptr) return;
  const std::string subject = fmt::format("joint '{}'", joint.name);
  const std::string path = fmt::format("joints.{}", joint.name);
  check_friction_law(rules, friction->law, subject, path);
  if (friction->guide_height > 0.0 && !(friction->guide_length > 0.0)) {
    rules.diagnostics.error("E-MODEL-012", path + ".friction.guide_height",
                            fmt::format("{}: guide_height has no meaning without a guide_length", subject));
  }
  const bool has_bristle = std::visit([]<class Law>(const Law&) { return Law::kHasBristle; }, friction->law);
  if (!std::holds_alternative<PinInSlot>(joint.kind) || !has_bristle) return;
  rules.diagnostics.error("E-MODEL-018", path + ".friction.law",
                          fmt::format("{}: {} bends bristles, and a pin changes the wall of its slot that they are on",
                                      subject, law_name(friction->law)),
                          {"a law without bristles, as lugre_steady, can"});
}

void check_contacts(CheckRules& rules) {
  std::set<std::string> seen_contacts;
  std::set<std::string> seen_materials;
  for (const Joint& joint : rules.mechanism.joints) {
    const ContactProperties* properties = find_contact(joint.kind);
    if (properties == nullptr) continue;
    const ContactProperties& contact = *properties;
    if (contact.name.empty()) {
      rules.diagnostics.error("E-MODEL-032", fmt::format("joints.{}.contact", joint.name),
                              fmt::format("joint '{}' has no contact", joint.name));
      continue;
    }
    check_geometry(rules, joint, contact);
    // Contacts and materials are shared; each is reported once.
    if (!seen_contacts.insert(contact.name).second) continue;
    const std::string subject = fmt::format("contact '{}'", contact.name);
    const std::string path = fmt::format("contacts.{}", contact.name);
    rules.check_name("a contact", path, contact.name);
    check_laws(rules, contact, subject, path);
    FieldCheck(rules, subject, path).check(contact);
    for (const auto* material : {&contact.bearing_material, &contact.journal_material}) {
      const bool bearing = material == &contact.bearing_material;
      if (material->name.empty()) {
        rules.diagnostics.error("E-MODEL-034", path + (bearing ? ".bearing_material" : ".journal_material"),
                                fmt::format("{}: the {} has no material", subject, bearing ? "bearing" : "journal"));
      } else if (seen_materials.insert(material->name).second) {
        check_material(rules, *material);
      }
    }
  }
}

}  // namespace gudgeon
