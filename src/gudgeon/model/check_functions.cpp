// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Rules for formulas: their constants, every name in them, and their grammar.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "gudgeon/base/expression.h"
#include "gudgeon/base/formula_readings.h"
#include "gudgeon/base/formula_tokens.h"
#include "gudgeon/model/channel_names.h"
#include "gudgeon/model/check_rules.h"
#include "gudgeon/model/formula_hints.h"

namespace gudgeon {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

/// True for a recorded channel that is no state channel: by its last part, "slider.x_acceleration", or as an energy.
bool is_result(const std::string& name) {
  static constexpr std::array<std::string_view, 31> kResults{
      "x_acceleration", "y_acceleration", "angle_acceleration", "x_force",       "y_force",       "force",
      "moment",         "effort",         "normal_force",       "left_force",    "right_force",   "friction_force",
      "penetration",    "slip_speed",     "in_contact",         "n_contacts",    "bristle",       "friction_torque",
      "contact_angle",  "x_offset",       "y_offset",           "x_offset_rate", "y_offset_rate", "height",
      "height_rate",    "tilt",           "tilt_rate",          "torque",        "power",         "length",
      "twist"};
  if (name.starts_with("energy.")) return true;
  const auto dot = name.rfind('.');
  return dot != std::string::npos && std::ranges::find(kResults, name.substr(dot + 1)) != kResults.end();
}

class ExpressionCheck {
 public:
  ExpressionCheck(CheckRules& rules, const FunctionUse& use, const Expression& expression)
      : rules_(rules), use_(use), expression_(expression), path_(use.path()), channels_(rules.channels()) {
    for (const auto& [name, value] : expression.constants) constants_.push_back(name);
  }

  /// True when the formula can be run.
  bool check() {
    check_constants();
    const std::vector<FormulaToken> tokens = split_formula(expression_.text);
    bool good = true;
    for (std::size_t k = 0; k < tokens.size(); ++k) {
      if (tokens[k].kind != FormulaToken::Kind::name) continue;
      good = check_name(tokens[k], k + 1 < tokens.size() && tokens[k + 1].text == "(") && good;
    }
    if (!good || !check_grammar()) return false;
    remark_readings();
    return true;
  }

 private:
  void check_constants() {
    for (std::size_t k = 0; k < constants_.size(); ++k) {
      const std::string& name = constants_[k];
      const std::string path = fmt::format("{}.constants.{}", use_.owner, name);
      const auto fail = [&](const std::string& what) {
        rules_.diagnostics.error("E-MODEL-080", path, fmt::format("{}: constant '{}' {}", use_.subject, name, what));
      };
      const bool plain = !name.empty() && !is_digit(name.front()) && std::ranges::all_of(name, [](char c) {
        return is_digit(c) || (is_formula_letter(c) && c > 0);
      });
      if (!plain) fail("needs a name of the letters A-Z and a-z, digits and '_' that does not begin with a digit");
      if (name == "t") fail("has the name of the time");
      if (name == "pi") fail("has the name of π");
      if (contains(list_formula_functions(), name)) fail("has the name of a function");
      if (std::find(constants_.begin(), constants_.begin() + static_cast<std::ptrdiff_t>(k), name) !=
          constants_.begin() + static_cast<std::ptrdiff_t>(k)) {
        fail("is given twice");
      }
      if (!std::isfinite(expression_.constants[k].second)) fail("is not finite");
    }
  }

  bool check_name(const FormulaToken& found, bool called) {
    const std::string name{found.text};
    if (name == "t" || name == "pi" || contains(constants_, name) || contains(list_formula_functions(), name)) {
      return true;
    }
    const bool known = channels_.find(name) >= 0;
    if (known && !use_.of_time_only) return true;
    if (known) {
      fail("E-MODEL-083", found, fmt::format("uses '{}'; a motion may depend on the time t only", name),
           {"a spring, or a load with this formula, follows the mechanism"});
    } else if (is_result(name) || is_pin_motion(name)) {
      fail(
          "E-MODEL-083", found, fmt::format("uses '{}', which is a result", name),
          {"forces, accelerations and contacts depend on the loads, so loads may depend on positions and speeds only"});
    } else if (called) {
      fail("E-MODEL-082", found, fmt::format("calls unknown function '{}'", name), list_functions(name));
    } else {
      fail("E-MODEL-082", found, fmt::format("uses unknown name '{}'", name), list_possible(name));
    }
    return false;
  }

  /// Recorded, but known to loads for guides only.
  [[nodiscard]] bool is_pin_motion(const std::string& name) const {
    return std::ranges::any_of(rules_.mechanism.joints, [&](const Joint& joint) {
      return std::holds_alternative<PinInSlotClearance>(joint.kind) &&
             (name == joint.name + ".displacement" || name == joint.name + ".speed");
    });
  }

  bool check_grammar() {
    std::vector<std::string> variables;
    for (const int k : channels_.find_in_formula(expression_.text)) variables.push_back(channels_.names()[k]);
    if (use_.of_time_only) variables = {"t"};
    try {
      const ExpressionEvaluator formula(expression_.text, expression_.constants, variables);
      return true;
    } catch (const ExpressionError& error) {
      fail("E-MODEL-081", {FormulaToken::Kind::symbol, "", static_cast<int>(error.position())},
           fmt::format("is not a valid expression: {}", error.what()), list_hints());
      return false;
    }
  }

  void fail(const char* code, const FormulaToken& where, const std::string& what, std::vector<std::string> notes) {
    rules_.diagnostics.add({Severity::error, code, path_,
                            fmt::format("{}: \"{}\" {}", use_.subject, expression_.text, what), std::move(notes),
                            where.position, static_cast<int>(std::max<std::size_t>(where.text.size(), 1))});
  }

  /// Says how chains are read that MATLAB, or people, read otherwise.
  void remark_readings() {
    for (const FormulaReading& reading : find_readings(expression_.text)) {
      const bool powers = reading.kind == FormulaReading::Kind::chained_powers;
      const std::string what =
          powers ? "is read from the right, a^b^c = a^(b^c), as in Python; MATLAB and Octave read (a^b)^c"
                 : "is read from the left: the truth of the first comparison, 1 or 0, is compared further";
      rules_.diagnostics.add({Severity::remark,
                              "R-MODEL-118",
                              path_,
                              fmt::format("{}: \"{}\" {}", use_.subject, reading.text, what),
                              {powers ? "parentheses say which is meant" : "a range is written a < b && b < c"},
                              reading.position,
                              static_cast<int>(reading.text.size())});
    }
  }

  /// What was probably meant: another language's symbols; or a quantity, with a slip of the pen, where it begins so.
  [[nodiscard]] std::vector<std::string> list_hints() const {
    std::vector<std::string> notes = list_symbol_hints(expression_.text);
    const std::string& text = expression_.text;
    const auto quantity = parse_quantity(text);
    const bool like_one = !text.empty() && (is_digit(text.front()) || text.front() == '.' || text.front() == '-');
    const bool is_formula = text.find_first_of("(?") != std::string::npos;
    if (!like_one || is_formula || !std::holds_alternative<QuantityError>(quantity)) return notes;
    notes.push_back("if a quantity was meant: " + std::get<QuantityError>(quantity).message);
    return notes;
  }

  [[nodiscard]] std::vector<std::string> list_functions(const std::string& name) const {
    std::vector<std::string> notes = list_hints();
    if (std::string hint = find_word_hint(name); !hint.empty()) notes.push_back(std::move(hint));
    const std::string suggestion = suggest(name, list_formula_functions());
    notes.push_back(fmt::format("functions are: {}{}{}", join_names(list_formula_functions()),
                                suggestion.empty() ? "" : "   ", suggestion));
    return notes;
  }

  [[nodiscard]] std::vector<std::string> list_possible(const std::string& name) const {
    std::vector<std::string> notes = list_hints();
    if (std::string hint = find_word_hint(name); !hint.empty()) notes.push_back(std::move(hint));
    std::vector<std::string> near{"t", "pi"};
    near.insert(near.end(), constants_.begin(), constants_.end());
    if (!use_.of_time_only) near.insert(near.end(), channels_.names().begin() + 1, channels_.names().end());
    std::string note;
    if (use_.of_time_only) {
      note = fmt::format("possible: {}", join_names(near));
    } else {
      note = fmt::format("constants are: {}; {}", constants_.empty() ? "none" : join_names(constants_),
                         list_channels(name));
    }
    const auto& functions = list_formula_functions();
    near.insert(near.end(), functions.begin(), functions.end());
    const std::string suggestion = suggest(name, near);
    notes.push_back(suggestion.empty() ? note : note + "   " + suggestion);
    return notes;
  }

  /// The channels of the body, point or joint that the name begins with, or the first few of all.
  [[nodiscard]] std::string list_channels(const std::string& name) const {
    constexpr std::size_t kFew = 12;  // more do not help
    const std::string owner = name.substr(0, name.find('.')) + ".";
    std::vector<std::string> own;
    for (const std::string& channel : channels_.names()) {
      if (channel.starts_with(owner)) own.push_back(channel);
    }
    std::vector<std::string> listed = own.empty() ? channels_.names() : own;
    const bool cut = listed.size() > kFew;
    if (cut) listed.resize(kFew);
    return fmt::format("channels{} are: {}{}", own.empty() ? "" : " of '" + name.substr(0, name.find('.')) + "'",
                       join_names(listed), cut ? ", …" : "");
  }

  CheckRules& rules_;
  const FunctionUse& use_;
  const Expression& expression_;
  std::string path_;
  const ChannelIndex& channels_;
  std::vector<std::string> constants_;
};

}  // namespace

bool check_expression(CheckRules& rules, const FunctionUse& use, const Expression& expression) {
  return ExpressionCheck(rules, use, expression).check();
}

void check_function(CheckRules& rules, const FunctionUse& use, const Function& function) {
  if (const auto* constant = std::get_if<double>(&function)) {
    if (std::isfinite(*constant)) return;
    rules.diagnostics.error("E-MODEL-005", use.path(),
                            fmt::format("{} is {}; it must be finite", use.subject, *constant));
  } else if (const auto* expression = std::get_if<Expression>(&function)) {
    check_expression(rules, use, *expression);
  } else {
    check_curve(rules, use, std::get<SampledCurve>(function));
  }
}

}  // namespace gudgeon
