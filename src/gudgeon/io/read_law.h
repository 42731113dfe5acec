// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Reads a law of any family, { law = "archard", coefficient = "4e-14 1/Pa" }, by the law's own parameter table;
// a law that nests a damping form has it as a table within, damping = { law = "lee_wang", restitution = 0.8 }.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "gudgeon/io/table_reader.h"
#include "gudgeon/laws/law.h"

namespace gudgeon {

/// The law that a table names, with its parameters; the family's first law when the name is wrong.
/// Does not check for unknown keys, so that the caller may read more.
template <class AnyLaw>
AnyLaw read_law(TableReader& table) {
  AnyLaw any;
  const std::optional<std::string> name = table.read_name("law");
  bool found = false;
  std::vector<std::string> names;
  for_each_alternative<AnyLaw>([&]<class Law>() {
    names.emplace_back(Law::kName);
    if (name != Law::kName) return;
    found = true;
    Law law;
    for (const Parameter<Law>& parameter : Law::kParameters) {
      double& member = law.*parameter.member;
      member = std::isnan(member) ? table.read_quantity(parameter.key, parameter.dimension)
                                  : table.find_quantity(parameter.key, parameter.dimension).value_or(member);
    }
    if constexpr (NestsDamping<Law>) {
      if (auto nested = table.find_table("damping", table.subject() + ": damping")) {
        law.damping = read_law<decltype(law.damping)>(*nested);
        nested->check_unknown_keys();
      }
    }
    any = law;
  });
  if (found) return any;
  if (name) table.report_unknown_choice("law", *name, names);
  // Which other keys are right depends on the law, so none is called wrong.
  for (const DocumentEntry& entry : table.entries()) table.find(entry.key);
  return any;
}

}  // namespace gudgeon
