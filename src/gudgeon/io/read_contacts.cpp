// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Materials, and the contacts that bring them together with laws of force, friction and wear.
#include <fmt/format.h>

#include <algorithm>

#include "gudgeon/io/read_law.h"
#include "gudgeon/io/read_sections.h"

namespace gudgeon {

namespace {

constexpr double kDefaultBearingShare = 0.5;
constexpr ParameterRange kShareRange{0.0, 1.0, false, false};

Material read_material_of(TableReader& contact, std::string_view key, std::span<const Material> materials) {
  const std::string name = contact.read_text(key);
  const auto found = std::ranges::find(materials, name, &Material::name);
  if (found != materials.end()) return *found;
  std::vector<std::string> names;
  for (const Material& material : materials) names.push_back(material.name);
  if (!name.empty()) {
    report_choice("E-FILE-011", contact.path_of(key),
                  fmt::format("{}: {}: unknown material '{}'", contact.subject(), key, name), name, names,
                  contact.log());
  }
  return {};
}

template <class AnyLaw>
void update_law(TableReader& contact, std::string_view key, AnyLaw& law) {
  auto table = contact.find_table(key, fmt::format("{}: {}", contact.subject(), key));
  if (!table) return;
  law = read_law<AnyLaw>(*table);
  table->check_unknown_keys();
}

/// The law of one surface that takes that share of the wear.
AnyWear share_of(const AnyWear& total, double share) {
  return std::visit([&](const auto& law) -> AnyWear { return law.share_of(share); }, total);
}

/// Points the split laws' paths to where the total stands, for messages about them.
void update_shared_spans(const std::string& contact, ReadLog& log) {
  const std::string total = contact + ".wear";
  std::vector<std::pair<std::string, SourceSpan>> copies;
  const auto& spans = log.source.spans;
  for (auto at = spans.lower_bound(total); at != spans.end() && at->first.starts_with(total); ++at) {
    const auto& [path, span] = *at;
    if (path != total && !path.starts_with(total + ".")) continue;
    for (const char* surface : {".bearing_wear", ".journal_wear"}) {
      copies.emplace_back(contact + surface + path.substr(total.size()), span);
    }
  }
  log.source.spans.insert(copies.begin(), copies.end());
}

void read_wear(TableReader& contact, ContactProperties& properties) {
  auto table = contact.find_table("wear", fmt::format("{}: wear", contact.subject()));
  if (!table) {
    update_law(contact, "bearing_wear", properties.bearing_wear);
    update_law(contact, "journal_wear", properties.journal_wear);
    return;
  }
  const auto total = read_law<AnyWear>(*table);
  const double share = table->find_quantity("bearing_share", dimension::kNone).value_or(kDefaultBearingShare);
  if (!kShareRange.contains(share)) table->report("E-FILE-014", "bearing_share", "bearing_share must be from 0 to 1");
  table->check_unknown_keys();
  properties.bearing_wear = share_of(total, share);
  properties.journal_wear = share_of(total, 1.0 - share);
  update_shared_spans(contact.path(), contact.log());
  for (const char* key : {"bearing_wear", "journal_wear"}) {
    if (contact.find(key) == nullptr) continue;
    contact.report("E-FILE-013", key, fmt::format("wear and {} exclude each other", key),
                   {"wear gives the total of both surfaces, bearing_wear and journal_wear give each its own"});
  }
}

ContactProperties read_contact(const DocumentEntry& entry, std::span<const Material> materials, ReadLog& log) {
  ContactProperties contact;
  contact.name = entry.key;
  TableReader table{entry.node, "contacts." + entry.key, fmt::format("contact '{}'", entry.key), log};
  contact.bearing_material = read_material_of(table, "bearing_material", materials);
  contact.journal_material = read_material_of(table, "journal_material", materials);
  update_law(table, "normal_force", contact.normal_force);
  update_law(table, "friction", contact.friction);
  read_wear(table, contact);
  const auto floor = table.find_quantity("onset_speed_floor", dimension::kSpeed);
  contact.onset_speed_floor = floor.value_or(contact.onset_speed_floor);
  table.update_choice<NormalDirection>("normal_direction", kNormalDirections, contact.normal_direction);
  table.update_choice<PressureDistribution>("pressure", kPressureDistributions, contact.pressure);
  table.check_unknown_keys();
  return contact;
}

}  // namespace

std::vector<Material> read_materials(TableReader& root) {
  std::vector<Material> materials;
  auto all = root.find_table("materials", "materials");
  if (!all) return materials;
  for (const DocumentEntry& entry : all->entries()) {
    TableReader table{entry.node, "materials." + entry.key, fmt::format("material '{}'", entry.key), root.log()};
    Material material{entry.key};
    material.young_modulus = table.read_quantity("young_modulus", dimension::kPressure);
    material.poisson_ratio = table.read_quantity("poisson_ratio", dimension::kNone);
    table.check_unknown_keys();
    materials.push_back(std::move(material));
  }
  return materials;
}

std::vector<ContactProperties> read_contacts(TableReader& root, std::span<const Material> materials) {
  std::vector<ContactProperties> contacts;
  auto all = root.find_table("contacts", "contacts");
  if (!all) return contacts;
  for (const DocumentEntry& entry : all->entries()) contacts.push_back(read_contact(entry, materials, root.log()));
  return contacts;
}

}  // namespace gudgeon
