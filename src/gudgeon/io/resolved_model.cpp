// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Mechanism and study as a model file; contacts and materials come out of the joints that hold them.
#include "gudgeon/io/resolved_model.h"

#include <optional>

#include "gudgeon/io/read_sections.h"
#include "gudgeon/io/resolved_loads.h"
#include "gudgeon/io/toml_lines.h"
#include "gudgeon/laws/law.h"
#include "gudgeon/model/friction_sizes.h"

namespace gudgeon {

namespace {

/// The fields that are set, as an inline table; nothing when none is.
class StartTable {
 public:
  void add(std::string_view key, std::optional<double> value, Dimension dimension) {
    if (value) add_text(key, toml_quantity(*value, dimension));
  }
  void add(std::string_view key, std::optional<Vec2> value, Dimension dimension) {
    if (value) add_text(key, toml_vector(*value, dimension));
  }
  void write(TomlLines& out) const {
    if (!fields_.empty()) out.line("start", fmt::format("{{ {} }}", fields_));
  }

 private:
  void add_text(std::string_view key, std::string_view value) {
    fields_ += fmt::format("{}{} = {}", fields_.empty() ? "" : ", ", key, value);
  }
  std::string fields_;
};

void write_body(const Body& body, TomlLines& out) {
  out.header("bodies", body.name);
  if (body.name != kFrameName) {
    out.line("mass", toml_quantity(body.mass, dimension::kMass));
    out.line("inertia", toml_quantity(body.inertia, dimension::kInertia));
    out.line("center_of_mass", toml_vector(body.center_of_mass, dimension::kLength));
    StartTable start;
    start.add("angle", body.start.angle, dimension::kAngle);
    start.add("angle_rate", body.start.angle_rate, dimension::kAngularSpeed);
    start.add("position", body.start.position, dimension::kLength);
    start.add("velocity", body.start.velocity, dimension::kSpeed);
    start.write(out);
  }
  for (const Point& point : body.points) {
    out.line("points." + point.name, toml_vector(point.position, dimension::kLength));
  }
}

template <class AnyLaw>
std::string law_text(const AnyLaw& any, std::string_view more = "") {
  return std::visit(
      [&]<class Law>(const Law& law) {
        std::string text = fmt::format("{{ law = \"{}\"", Law::kName);
        for (const Parameter<Law>& parameter : Law::kParameters) {
          text += fmt::format(", {} = {}", parameter.key, toml_quantity(law.*parameter.member, parameter.dimension));
        }
        if constexpr (NestsDamping<Law>) text += ", damping = " + law_text(law.damping);
        return fmt::format("{}{} }}", text, more);
      },
      any);
}

/// Friction of an ideal joint, with its sizes beside the law's parameters.
template <class Kind>
void write_friction(const Kind& joint, TomlLines& out) {
  if (!joint.friction) return;
  std::string sizes;
  for (const FrictionSize& size : list_friction_sizes(joint)) {
    sizes += fmt::format(", {} = {}", size.key, toml_quantity((*joint.friction).*size.member, size.dimension));
  }
  out.line("friction", law_text(joint.friction->law, sizes));
}

/// Materials and contacts by their text, since two that share a name may differ when a program made them.
class SharedTables {
 public:
  std::string contact_name(const ContactProperties& contact) {
    TomlLines lines;
    lines.line("bearing_material", toml_text(material_name(contact.bearing_material)));
    lines.line("journal_material", toml_text(material_name(contact.journal_material)));
    lines.line("normal_force", law_text(contact.normal_force));
    lines.line("friction", law_text(contact.friction));
    lines.line("bearing_wear", law_text(contact.bearing_wear));
    lines.line("journal_wear", law_text(contact.journal_wear));
    lines.line("onset_speed_floor", toml_quantity(contact.onset_speed_floor, dimension::kSpeed));
    lines.line("normal_direction",
               toml_text(choice_name<NormalDirection>(kNormalDirections, contact.normal_direction)));
    lines.line("pressure", toml_text(choice_name<PressureDistribution>(kPressureDistributions, contact.pressure)));
    return find_name(contacts_, contact.name, lines.text());
  }

  void write(TomlLines& out) const {
    for (const auto& [name, text] : contacts_) write_table("contacts", name, text, out);
    for (const auto& [name, text] : materials_) write_table("materials", name, text, out);
  }

 private:
  using Tables = std::vector<std::pair<std::string, std::string>>;

  static void write_table(std::string_view section, const std::string& name, const std::string& text, TomlLines& out) {
    out.header(section, name);
    out.raw(text);
  }

  std::string material_name(const Material& material) {
    TomlLines lines;
    lines.line("young_modulus", toml_quantity(material.young_modulus, dimension::kPressure));
    lines.line("poisson_ratio", toml_quantity(material.poisson_ratio, dimension::kNone));
    return find_name(materials_, material.name, lines.text());
  }

  /// The name under which that text is written: the wished one unless another text has it.
  static std::string find_name(Tables& tables, const std::string& wished, const std::string& text) {
    std::string name = wished;
    for (int i = 2;; ++i) {
      bool taken = false;
      for (const auto& [known_name, known_text] : tables) {
        if (known_name != name) continue;
        if (known_text == text) return name;
        taken = true;
      }
      if (!taken) break;
      name = fmt::format("{}_{}", wished, i);
    }
    tables.emplace_back(name, text);
    return name;
  }

  Tables contacts_;
  Tables materials_;
};

void write_between(const Anchor& first, const Anchor& second, TomlLines& out) {
  out.line("between", fmt::format("[{}, {}]", toml_point(first), toml_point(second)));
}

void write_kind(const Revolute& joint, SharedTables& /*shared*/, TomlLines& out) {
  out.line("type", "\"revolute\"");
  write_between(joint.first, joint.second, out);
  write_friction(joint, out);
}

void write_kind(const Prismatic& joint, SharedTables& /*shared*/, TomlLines& out) {
  out.line("type", "\"prismatic\"");
  write_between(joint.first, joint.second, out);
  out.line("direction", toml_quantity(joint.direction, dimension::kAngle));
  out.line("relative_angle", toml_quantity(joint.relative_angle, dimension::kAngle));
  StartTable start;
  start.add("displacement", joint.start_displacement, dimension::kLength);
  start.add("speed", joint.start_speed, dimension::kSpeed);
  start.write(out);
  write_friction(joint, out);
}

void write_kind(const PinInSlot& joint, SharedTables& /*shared*/, TomlLines& out) {
  out.line("type", "\"pin_in_slot\"");
  write_between(joint.first, joint.second, out);
  out.line("direction", toml_quantity(joint.direction, dimension::kAngle));
  write_friction(joint, out);
}

void write_kind(const PrismaticClearance& joint, SharedTables& shared, TomlLines& out) {
  out.line("type", "\"prismatic_clearance\"");
  out.line("bearing", toml_point(joint.bearing));
  out.line("journal", toml_point(joint.journal));
  out.line("direction", toml_quantity(joint.direction, dimension::kAngle));
  out.line("relative_angle", toml_quantity(joint.relative_angle, dimension::kAngle));
  out.line("bearing_length", toml_quantity(joint.bearing_length, dimension::kLength));
  out.line("journal_length", toml_quantity(joint.journal_length, dimension::kLength));
  out.line("journal_height", toml_quantity(joint.journal_height, dimension::kLength));
  out.line("corner_radius", toml_quantity(joint.corner_radius, dimension::kLength));
  out.line("clearance", toml_quantity(joint.clearance, dimension::kLength));
  out.line("width", toml_quantity(joint.width, dimension::kLength));
  out.line("contact", toml_text(shared.contact_name(joint.contact)));
}

void write_kind(const PinInSlotClearance& joint, SharedTables& shared, TomlLines& out) {
  out.line("type", "\"pin_in_slot_clearance\"");
  out.line("bearing", toml_point(joint.bearing));
  out.line("journal", toml_point(joint.journal));
  out.line("direction", toml_quantity(joint.direction, dimension::kAngle));
  out.line("bearing_length", toml_quantity(joint.bearing_length, dimension::kLength));
  out.line("journal_radius", toml_quantity(joint.journal_radius, dimension::kLength));
  out.line("clearance", toml_quantity(joint.clearance, dimension::kLength));
  out.line("width", toml_quantity(joint.width, dimension::kLength));
  out.line("contact", toml_text(shared.contact_name(joint.contact)));
}

void write_kind(const Rigid& joint, SharedTables& /*shared*/, TomlLines& out) {
  out.line("type", "\"rigid\"");
  write_between(joint.first, joint.second, out);
  out.line("relative_angle", toml_quantity(joint.relative_angle, dimension::kAngle));
}

void write_kind(const RevoluteClearance& joint, SharedTables& shared, TomlLines& out) {
  out.line("type", "\"revolute_clearance\"");
  out.line("bearing", toml_point(joint.bearing));
  out.line("journal", toml_point(joint.journal));
  out.line("bearing_radius", toml_quantity(joint.bearing_radius, dimension::kLength));
  out.line("radial_clearance", toml_quantity(joint.radial_clearance, dimension::kLength));
  out.line("width", toml_quantity(joint.width, dimension::kLength));
  out.line("contact", toml_text(shared.contact_name(joint.contact)));
}

void write_reference(const ReferenceValue& reference, TomlLines& out) {
  out.raw("\n[[study.reference]]\n");
  out.line("quantity", toml_text(reference.quantity));
  out.line("channel", toml_text(reference.channel));
  out.line("measure", toml_text(reference.measure));
  std::string values;
  for (const double value : reference.values) values += (values.empty() ? "" : ", ") + toml_number(value);
  out.line("values", fmt::format("[{}]", values));
}

void write_study(const Study& study, TomlLines& out) {
  out.raw("\n[study]\n");
  if (!study.cycle_driver.empty()) {
    out.line("cycle_driver", fmt::format("{}  # a turn takes {} s", toml_text(study.cycle_driver), study.cycle_time));
  } else {
    out.line("cycle_time", toml_quantity(study.cycle_time, dimension::kTime));
  }
  out.line("cycles", fmt::format("{}", study.cycles));
  out.line("warm_up_cycles", fmt::format("{}", study.warm_up_cycles));
  out.line("wear_stages", fmt::format("{}", study.wear_stages));
  out.line("wear_acceleration", toml_number(study.wear_acceleration));
  out.line("cells", fmt::format("{}", study.cells));
  out.line("wear_distribution", toml_text(choice_name<WearDistribution>(kWearDistributions, study.wear_distribution)));
  out.line("compare_ideal", study.compare_ideal ? "true" : "false");
  out.line("ideal_friction", study.ideal_friction ? "true" : "false");
  out.line("outputs_per_cycle", fmt::format("{}", study.outputs_per_cycle));
  out.line("relative_tolerance", toml_number(study.relative_tolerance));
  out.line("absolute_tolerance", toml_number(study.absolute_tolerance));
  out.line("max_step", toml_quantity(study.max_step, dimension::kTime));
  out.line("integrator", toml_text(choice_name<Integrator>(kIntegrators, study.integrator)));
  out.line("stabilization", toml_text(choice_name<Stabilization>(kStabilizations, study.stabilization)));
  out.line("baumgarte_alpha", toml_quantity(study.baumgarte_alpha, dimension::kPerTime));
  out.line("baumgarte_beta", toml_quantity(study.baumgarte_beta, dimension::kPerTime));
  for (const ReferenceValue& reference : study.reference) write_reference(reference, out);
}

}  // namespace

std::string write_resolved_model(const Mechanism& mechanism, const Study& study) {
  TomlLines out;
  out.line("name", toml_text(mechanism.name));
  out.line("description", toml_text(mechanism.description));
  out.line("gravity", toml_vector(mechanism.gravity, dimension::kAcceleration));
  for (const Body& body : mechanism.bodies) write_body(body, out);
  SharedTables shared;
  for (const Joint& joint : mechanism.joints) {
    out.header("joints", joint.name);
    std::visit([&](const auto& kind) { write_kind(kind, shared, out); }, joint.kind);
    if (joint.branch) out.line("branch", toml_text(choice_name<Branch>(kBranches, *joint.branch)));
  }
  shared.write(out);
  for (const Driver& driver : mechanism.drivers) write_driver(driver, out);
  for (const Load& load : mechanism.loads) write_load(load, out);
  write_study(study, out);
  return out.text();
}

}  // namespace gudgeon
