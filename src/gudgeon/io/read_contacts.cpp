// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Materials, and the contacts that bring them together with laws of force, friction and wear.
#include <fmt/format.h>

#include <algorithm>

#include "gudgeon/io/field_reader.h"
#include "gudgeon/io/read_sections.h"

namespace gudgeon {

namespace {

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

/// In place of bearing_wear and journal_wear.
void read_total_wear(TableReader& contact, ContactProperties& properties) {
  const std::string key{kTotalWearKey};
  auto table = contact.find_table(key, fmt::format("{}: {}", contact.subject(), key));
  if (!table) return;
  const auto total = read_law<AnyWear>(*table);
  const double share = table->find_quantity(kBearingShareKey, dimension::kNone).value_or(kDefaultBearingShare);
  if (!kShareRange.contains(share)) {
    table->report("E-FILE-014", kBearingShareKey, fmt::format("{} must be from 0 to 1", kBearingShareKey));
  }
  table->check_unknown_keys();
  properties.bearing_wear = share_of(total, share);
  properties.journal_wear = share_of(total, 1.0 - share);
  update_shared_spans(contact.path(), contact.log());
  for (const char* own : {"bearing_wear", "journal_wear"}) {
    if (!contact.has(own)) continue;
    contact.report("E-FILE-013", own, fmt::format("{} and {} exclude each other", key, own),
                   {"wear gives the total of both surfaces, bearing_wear and journal_wear give each its own"});
  }
}

ContactProperties read_contact(const DocumentEntry& entry, std::span<const Material> materials, ReadLog& log) {
  ContactProperties contact;
  contact.name = entry.key;
  TableReader table{entry.node, "contacts." + entry.key, fmt::format("contact '{}'", entry.key), log};
  FieldReader(table, {.materials = materials}).read(contact);
  read_total_wear(table, contact);
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
    FieldReader(table).read(material);
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
