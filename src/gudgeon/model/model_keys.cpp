// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One walk over all tables. Keys that the readers of sections handle on their own are written out here.
#include "gudgeon/model/model_keys.h"

#include <fmt/format.h>

#include <optional>
#include <type_traits>
#include <variant>

#include "gudgeon/base/alternatives.h"
#include "gudgeon/model/check_rules.h"
#include "gudgeon/model/mechanism.h"
#include "gudgeon/model/study.h"

namespace gudgeon {

namespace {

// What kind a value is, from the type it is stored in, and its default.

void describe_value(const double& value, KeyEntry& entry) {
  entry.kind = ValueKind::quantity;
  entry.default_text = with_unit(value, entry.dimension);
  entry.default_number = value;
}
void describe_value(const int& value, KeyEntry& entry) {
  describe_value(static_cast<double>(value), entry);
  entry.kind = ValueKind::count;
}
void describe_value(const bool& value, KeyEntry& entry) {
  entry.kind = ValueKind::flag;
  entry.default_text = value ? "true" : "false";
}
void describe_value(const Vec2& value, KeyEntry& entry) {
  entry.kind = ValueKind::vector;
  entry.default_text = fmt::format("[{}, {}]", value.x, value.y);
}
void describe_value(const std::vector<double>& /*value*/, KeyEntry& entry) { entry.kind = ValueKind::quantities; }
void describe_value(const std::string& value, KeyEntry& entry) {
  entry.kind = entry.of.empty() ? ValueKind::text : ValueKind::name;
  entry.default_text = fmt::format("\"{}\"", value);
}
void describe_value(const Anchor& /*value*/, KeyEntry& entry) { entry.kind = ValueKind::point; }
void describe_value(const Function& /*value*/, KeyEntry& entry) { entry.kind = ValueKind::function; }
void describe_value(const std::vector<Point>& /*value*/, KeyEntry& entry) {
  entry.kind = ValueKind::points;
  entry.default_text = "none";
}
void describe_value(const Material& /*value*/, KeyEntry& entry) {
  entry.kind = ValueKind::name;
  entry.of = "material";
}
void describe_value(const ContactProperties& /*value*/, KeyEntry& entry) {
  entry.kind = ValueKind::name;
  entry.of = "contact";
}
void describe_law(std::string_view family, std::string_view law, KeyEntry& entry) {
  entry.kind = ValueKind::law;
  entry.of = family;
  entry.default_text = law;
}
void describe_value(const AnyNormalForce& value, KeyEntry& entry) {
  describe_law("normal_force", law_name(value), entry);
}
void describe_value(const AnyFriction& value, KeyEntry& entry) { describe_law("friction", law_name(value), entry); }
void describe_value(const AnyWear& value, KeyEntry& entry) { describe_law("wear", law_name(value), entry); }

template <class Choice>
requires std::is_enum_v<Choice>
void describe_value(const Choice& value, KeyEntry& entry) {
  entry.kind = ValueKind::choice;
  for (const auto& [name, choice] : choices(value)) {
    entry.choices.emplace_back(name);
    if (choice == value) entry.default_text = fmt::format("\"{}\"", name);
  }
}

template <class Fields, class Owner>
void add_keys(const Fields& fields, const Owner& owner, std::vector<KeyEntry>& keys);

template <TableWithin Value>
void describe_value(const Value& value, KeyEntry& entry) {
  entry.kind = ValueKind::table;
  entry.default_text = "none";
  add_keys(Value::kFields, value, entry.keys);
}
void describe_value(const std::vector<ReferenceValue>& /*value*/, KeyEntry& entry) {
  entry.kind = ValueKind::array_of_tables;
  add_keys(ReferenceValue::kFields, ReferenceValue{}, entry.keys);
}
template <class Value>
void describe_value(const std::optional<Value>& value, KeyEntry& entry) {
  describe_value(value.value_or(Value{}), entry);
  entry.default_number.reset();
}

void describe_pair(const Anchor& /*first*/, KeyEntry& entry) { entry.kind = ValueKind::point_pair; }
void describe_pair(const std::string& /*first*/, KeyEntry& entry) { entry.kind = ValueKind::body_pair; }
void describe_pair(const Function& /*first*/, KeyEntry& entry) { entry.kind = ValueKind::function_pair; }

std::string_view word_for(Names names) {
  switch (names) {
    case Names::nothing:
      return "";
    case Names::body:
      return "body";
    case Names::joint:
      return "joint";
    case Names::driver:
      return "driver";
    case Names::channel:
      return "channel";
  }
  return "";
}

KeyEntry make_entry(std::string_view key, const FieldTraits& traits) {
  KeyEntry entry;
  entry.key = key;
  entry.required = traits.required;
  entry.unless = traits.unless;
  entry.dimension = traits.dimension;
  entry.symbol = traits.symbol;
  entry.range = traits.range;
  entry.of = word_for(traits.names);
  entry.meaning = traits.meaning;
  return entry;
}

/// What holds when the key is absent, in the words of its table if there are any.
void update_default(const FieldTraits& traits, KeyEntry& entry) {
  if (!traits.required && traits.absent.empty()) return;
  entry.default_text = traits.absent;
  entry.default_number.reset();
}

template <class Owner, class Value>
KeyEntry describe_field(const Field<Owner, Value>& one, const Owner& owner) {
  KeyEntry entry = make_entry(one.key, one.traits);
  describe_value(owner.*one.member, entry);
  update_default(one.traits, entry);
  return entry;
}

/// A law, with the sizes that a joint of that type has beside it.
template <class Owner>
KeyEntry describe_field(const Field<Owner, std::optional<JointFriction>>& one, const Owner& /*owner*/) {
  KeyEntry entry = make_entry(one.key, one.traits);
  describe_law("friction", one.traits.absent, entry);
  add_keys(Owner::kFrictionFields, JointFriction{}, entry.keys);
  return entry;
}

template <class Owner, class Value>
KeyEntry describe_field(const PairField<Owner, Value>& one, const Owner& owner) {
  KeyEntry entry = make_entry(one.key, one.traits);
  describe_pair(owner.*one.first, entry);
  update_default(one.traits, entry);
  return entry;
}

template <class Fields, class Owner>
void add_keys(const Fields& fields, const Owner& owner, std::vector<KeyEntry>& keys) {
  for_each_field(fields, [&](const auto& one) { keys.push_back(describe_field(one, owner)); });
}

/// One that no table of fields has; required without a default.
KeyEntry make_key(std::string_view key, ValueKind kind, std::string_view default_text, std::string_view meaning) {
  KeyEntry entry = make_entry(key, {.meaning = meaning});
  entry.kind = kind;
  entry.default_text = default_text;
  entry.required = default_text.empty();
  return entry;
}

KeyEntry make_constants() { return make_key("constants", ValueKind::constants, "none", "that formulas may name"); }

bool has_function(const std::vector<KeyEntry>& keys) {
  for (const KeyEntry& entry : keys) {
    if (entry.kind == ValueKind::function || entry.kind == ValueKind::function_pair) return true;
  }
  return false;
}

template <class Owner>
KeyTable make_table(std::string_view section) {
  KeyTable table;
  table.section = section;
  table.meaning = Owner::kMeaning;
  if constexpr (requires { Owner::kType; }) table.type = Owner::kType;
  add_keys(Owner::kFields, Owner{}, table.keys);
  if (has_function(table.keys)) table.keys.push_back(make_constants());
  return table;
}

void add_joints(std::vector<KeyTable>& tables) {
  for_each_alternative<AnyJoint>([&]<class Kind>() {
    KeyTable& table = tables.emplace_back(make_table<Kind>("joints"));
    table.type_required = true;
    add_keys(Joint::kFields, Joint{}, table.keys);
  });
}

void add_loads(std::vector<KeyTable>& tables) {
  for_each_alternative<AnyLoad>([&]<class Kind>() {
    if constexpr (FileLoad<Kind>) {
      KeyTable& table = tables.emplace_back(make_table<Kind>("loads"));
      table.type_required = !std::same_as<Kind, VariableForce> && !std::same_as<Kind, VariableTorque>;
    }
  });
}

template <class Driven>
KeyTable make_driver() {
  KeyTable table = make_table<Driven>("drivers");
  add_keys(Driver::uniform_fields(Driven::kPlace, Driven::kRate), Driver{}, table.keys);
  KeyEntry motion = make_entry(Driver::kMotionKey, {.dimension = Driven::kPlace, .meaning = Driver::kMotionMeaning});
  motion.kind = ValueKind::function;
  motion.default_text = "none";
  table.keys.push_back(motion);
  table.keys.push_back(make_constants());
  return table;
}

KeyTable make_contact() {
  KeyTable table = make_table<ContactProperties>("contacts");
  KeyEntry total =
      make_entry(kTotalWearKey, {.meaning = "what both lose together, in place of bearing_wear and journal_wear"});
  describe_law("wear", "", total);
  total.default_text = "none";
  KeyEntry share = make_entry(kBearingShareKey, {.range = kShareRange, .meaning = "of the bearing in the total"});
  describe_value(kDefaultBearingShare, share);
  total.keys.push_back(share);
  table.keys.push_back(total);
  return table;
}

KeyTable make_study() {
  KeyTable table = make_table<Study>("study");
  std::vector<KeyEntry> keys;
  add_keys(Study::kCycleFields, Study{}, keys);
  table.keys.insert(table.keys.begin(), keys.begin(), keys.end());
  return table;
}

/// What may stand where a function is asked for.
KeyTable make_curve() {
  KeyTable table{"curve", "", false, "a curve through points, wherever a function may stand", {}};
  KeyEntry over = make_key("over", ValueKind::name, "\"t\"", "the time t or a channel");
  over.of = "channel";
  KeyEntry interpolation = make_key("interpolation", ValueKind::choice, "\"monotone\"; \"spline\" for a motion",
                                    "how it runs between its points");
  for (const auto& [name, kind] : kInterpolations) interpolation.choices.emplace_back(name);
  table.keys = {
      over,
      make_key("arguments", ValueKind::quantities, "", "strictly increasing"),
      make_key("argument_unit", ValueKind::text, "SI", "of those without a unit of their own"),
      make_key("values", ValueKind::quantities, "", "one per argument"),
      make_key("value_unit", ValueKind::text, "SI", "of those without a unit of their own"),
      make_key("periodic", ValueKind::flag, "false",
               "whether it repeats beyond its ends; otherwise it holds its end values"),
      interpolation,
      make_key("smoothing", ValueKind::text, "none",
               "for measured points: a cut-off, \"20 Hz\", or the noise of the values, \"0.02 deg\""),
  };
  return table;
}

KeyTable make_cases() {
  return {"cases",
          "",
          false,
          "a variant of the model",
          {make_key("description", ValueKind::text, "\"\"", "what it is"),
           make_key("set", ValueKind::overrides, "", "values by their paths, \"joints.A.width\" = \"20 mm\"")}};
}

}  // namespace

std::vector<KeyTable> list_model_keys() {
  std::vector<KeyTable> tables;
  tables.push_back(make_table<Mechanism>(""));
  tables.push_back(make_table<Body>("bodies"));
  add_joints(tables);
  tables.push_back(make_contact());
  tables.push_back(make_table<Material>("materials"));
  tables.push_back(make_driver<DrivenAngle>());
  tables.push_back(make_driver<DrivenSlide>());
  add_loads(tables);
  tables.push_back(make_curve());
  tables.push_back(make_study());
  tables.push_back(make_cases());
  return tables;
}

}  // namespace gudgeon
