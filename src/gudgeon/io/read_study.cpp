// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The study: how long, how often, how accurately, and what is known from elsewhere.
#include "gudgeon/io/field_reader.h"
#include "gudgeon/io/read_sections.h"

namespace gudgeon {

Study read_study(TableReader& root) {
  Study study;
  auto table = root.find_table("study", "study");
  if (!table) return study;
  FieldReader reader(*table);
  reader.read(Study::kCycleFields, study);
  reader.read(study);
  if (table->is_newer("cycle_time", "cycle_driver")) {
    study.cycle_driver.clear();
  } else if (table->is_newer("cycle_driver", "cycle_time")) {
    study.cycle_time = 0.0;
  } else if (table->has("cycle_driver") && table->has("cycle_time")) {
    table->report("E-FILE-013", "cycle_time", "cycle_driver and cycle_time exclude each other");
  }
  table->check_unknown_keys();
  return study;
}

}  // namespace gudgeon
