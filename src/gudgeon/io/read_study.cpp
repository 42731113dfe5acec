// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The study: how long, how often, how accurately, and what is known from elsewhere.
#include <fmt/format.h>

#include <array>

#include "gudgeon/io/read_sections.h"

namespace gudgeon {

namespace {

struct CountField {
  std::string_view key;
  int Study::*member;
};

struct QuantityField {
  std::string_view key;
  Dimension dimension;
  double Study::*member;
};

constexpr std::array<CountField, 5> kCounts{{
    {"cycles", &Study::cycles},
    {"warm_up_cycles", &Study::warm_up_cycles},
    {"wear_stages", &Study::wear_stages},
    {"cells", &Study::cells},
    {"outputs_per_cycle", &Study::outputs_per_cycle},
}};

constexpr std::array<QuantityField, 7> kQuantities{{
    {"cycle_time", dimension::kTime, &Study::cycle_time},
    {"wear_acceleration", dimension::kNone, &Study::wear_acceleration},
    {"relative_tolerance", dimension::kNone, &Study::relative_tolerance},
    {"absolute_tolerance", dimension::kNone, &Study::absolute_tolerance},
    {"max_step", dimension::kTime, &Study::max_step},
    {"baumgarte_alpha", dimension::kPerTime, &Study::baumgarte_alpha},
    {"baumgarte_beta", dimension::kPerTime, &Study::baumgarte_beta},
}};

std::vector<double> read_values(TableReader& table) {
  std::vector<double> values;
  const DocumentNode* node = table.find_required("values");
  if (node == nullptr) return values;
  const auto* array = std::get_if<DocumentNode::Array>(&node->value);
  if (array == nullptr) {
    table.report("E-FILE-003", "values", "values must be an array of quantities, one a stage; nan where none is known");
    return values;
  }
  for (std::size_t i = 0; i < array->size(); ++i) {
    const std::string path = fmt::format("{}.{}", table.path_of("values"), i);
    const std::string label = fmt::format("{}: value {}", table.subject(), i + 1);
    const auto value = read_quantity((*array)[i], std::nullopt, path, label, table.log());
    values.push_back(value.value_or(0.0));
  }
  return values;
}

std::vector<ReferenceValue> read_reference(TableReader& study) {
  std::vector<ReferenceValue> reference;
  const DocumentNode* node = study.find("reference");
  if (node == nullptr) return reference;
  const auto* array = std::get_if<DocumentNode::Array>(&node->value);
  if (array == nullptr) {
    study.report("E-FILE-003", "reference", "reference must be an array of tables, [[study.reference]]");
    return reference;
  }
  for (std::size_t i = 0; i < array->size(); ++i) {
    const std::string path = fmt::format("{}.{}", study.path_of("reference"), i);
    TableReader table{(*array)[i], path, fmt::format("reference value {}", i + 1), study.log()};
    ReferenceValue value;
    value.quantity = table.read_text("quantity");
    value.channel = table.read_text("channel");
    value.measure = table.read_text("measure");
    value.values = read_values(table);
    table.check_unknown_keys();
    reference.push_back(std::move(value));
  }
  return reference;
}

}  // namespace

Study read_study(TableReader& root) {
  Study study;
  auto table = root.find_table("study", "study");
  if (!table) return study;
  study.cycle_driver = table->find_text("cycle_driver").value_or("");
  for (const CountField& field : kCounts) {
    study.*field.member = table->find_count(field.key).value_or(study.*field.member);
  }
  for (const QuantityField& field : kQuantities) {
    const auto value = table->find_quantity(field.key, field.dimension);
    study.*field.member = value.value_or(study.*field.member);
  }
  table->update_choice<WearDistribution>("wear_distribution", kWearDistributions, study.wear_distribution);
  table->update_choice<Integrator>("integrator", kIntegrators, study.integrator);
  table->update_choice<Stabilization>("stabilization", kStabilizations, study.stabilization);
  study.compare_ideal = table->find_switch("compare_ideal").value_or(study.compare_ideal);
  study.ideal_friction = table->find_switch("ideal_friction").value_or(study.ideal_friction);
  study.reference = read_reference(*table);
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
