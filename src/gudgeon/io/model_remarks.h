// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Remarks that the author of a model file wrote behind its values: where a number comes from.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gudgeon {

/// One line of the file that has a remark.
struct ModelRemark {
  std::string path;     ///< of the line's value or table by its present name, "joints.A.radial_clearance"
  std::string written;  ///< the value as it stands there, without quotes; empty for a table's header
  std::string remark;   ///< "A: the paper is silent"
};

/// What a letter at the start of remarks stands for.
struct RemarkLetter {
  std::string letter;   ///< "P"
  std::string meaning;  ///< "printed in the paper"
};

/// Remarks in the order of the file; the tables of cases are left out.
std::vector<ModelRemark> find_remarks(std::string_view model_text);

/// The legend of a file that explains letters in one comment line, "# P printed in the paper · A assumed"; empty when
/// it has none.
std::vector<RemarkLetter> find_remark_letters(std::string_view model_text);

}  // namespace gudgeon
