// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Every key of a model file as plain data, made from the tables that the reader walks: for the manual's page, for the
// schema that editors read, for a terminal.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gudgeon/model/field.h"

namespace gudgeon {

/// What stands behind a key.
enum class ValueKind {
  quantity,         ///< a number in SI or a text with a unit
  vector,           ///< [x, y], two quantities
  quantities,       ///< an array of quantities of any dimension
  count,            ///< a whole number
  flag,             ///< true or false
  text,             ///< any
  name,             ///< of what `of` says
  choice,           ///< one of `choices`
  point,            ///< "body.point"
  point_pair,       ///< of two points
  body_pair,        ///< of two bodies' names
  function,         ///< a quantity, a formula or a curve
  function_pair,    ///< [x, y], two of them
  constants,        ///< quantities by name
  points,           ///< vectors by name
  law,              ///< { law = "NAME", … } of the family that `of` says
  table,            ///< with `keys`
  array_of_tables,  ///< each with `keys`
  overrides,        ///< values by their paths
};

/// One key.
struct KeyEntry {
  std::string key;
  ValueKind kind = ValueKind::text;
  bool required = false;
  std::string unless;                    ///< key that takes the place of a required one
  Dimension dimension;                   ///< of its numbers
  std::string symbol;                    ///< in formulas
  ParameterRange range;                  ///< of its numbers
  std::string default_text;              ///< as the model file would have it, or in words
  std::optional<double> default_number;  ///< of a quantity or count without words
  std::string of;                        ///< what a name names, "body"; the family of a law
  std::vector<std::string> choices;      ///< of a choice
  std::string meaning;
  std::vector<KeyEntry> keys;  ///< of a table within
};

/// The keys of one table of the file, or of one type of it.
struct KeyTable {
  std::string section;  ///< "joints"; "" for the top, "curve" for what may stand in place of a function
  std::string type;     ///< value of its key `type`, "prismatic"; "" without one
  bool type_required = false;
  std::string meaning;
  std::vector<KeyEntry> keys;
};

/// All of them, in the order of the manual.
std::vector<KeyTable> list_model_keys();

}  // namespace gudgeon
