// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One walk over all families, two ways to print it.
#include "gudgeon/app/law_tables.h"

#include <fmt/format.h>

#include <cmath>

#include "gudgeon/app/interval_text.h"
#include "gudgeon/base/quantity.h"
#include "gudgeon/laws/damping/any.h"
#include "gudgeon/laws/friction/any.h"
#include "gudgeon/laws/normal/any.h"
#include "gudgeon/laws/wear/any.h"

namespace gudgeon {

namespace {

template <class Any>
void add_family(const std::string& family, std::vector<LawEntry>& laws) {
  for_each_alternative<Any>([&]<class Law>() {
    LawEntry entry{family, std::string{Law::kName}, std::string{Law::kFormula}, {}};
    const Law defaults;
    for (const Parameter<Law>& parameter : Law::kParameters) {
      const double value = defaults.*parameter.member;
      entry.parameters.push_back({std::string{parameter.key}, std::string{parameter.symbol},
                                  si_unit(parameter.dimension), interval_text(parameter.range),
                                  std::isnan(value) ? "required" : fmt::format("{:g}", value),
                                  std::string{parameter.meaning}});
    }
    if constexpr (NestsDamping<Law>) {
      entry.parameters.push_back({"damping", "χ", "1", "a damping law", std::string{law_name(defaults.damping)},
                                  "share of the force that is damping, by the law of that name"});
    }
    laws.push_back(std::move(entry));
  });
}

}  // namespace

std::vector<LawEntry> list_laws() {
  std::vector<LawEntry> laws;
  add_family<AnyNormalForce>("normal_force", laws);
  add_family<AnyDamping>("damping", laws);
  add_family<AnyFriction>("friction", laws);
  add_family<AnyWear>("wear", laws);
  return laws;
}

std::string render_laws_page() {
  std::string text =
      "# Laws\n\nEvery law that a `[contacts.NAME]` may name, made from the laws themselves by `gudgeon laws "
      "--markdown`. "
      "Ranges are\nintervals: `(` and `)` leave their end out. Defaults are in the unit named.\n";
  std::string family;
  for (const LawEntry& law : list_laws()) {
    if (law.family != family) text += fmt::format("\n## {}\n", law.family);
    family = law.family;
    text += fmt::format("\n### {}\n\n`{}`\n", law.name, law.formula);
    if (law.parameters.empty()) continue;
    text += "\n| key | symbol | unit | range | default | meaning |\n|---|---|---|---|---|---|\n";
    for (const auto& row : law.parameters) {
      for (const std::string& cell : row) text += "| " + cell + " ";
      text += "|\n";
    }
  }
  return text;
}

std::string render_laws(std::string_view name) {
  std::string text;
  for (const LawEntry& law : list_laws()) {
    if (!name.empty() && law.family != name && law.name != name) continue;
    text += fmt::format("{}{} ({})\n  {}\n", text.empty() ? "" : "\n", law.name, law.family, law.formula);
    for (const auto& row : law.parameters) {
      text += fmt::format("    {:<22} {:<4} {:<8} {:<14} {:<20} {}\n", row[0], row[1], row[2], row[3], row[4], row[5]);
    }
  }
  return text;
}

}  // namespace gudgeon
