// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Cases grouped by what they have in common.
#include "gudgeon/app/case_groups.h"

#include <algorithm>
#include <cmath>

#include "gudgeon/report/number_format.h"

namespace gudgeon {
namespace {

/// What a case is, apart from the reference values beside it.
struct CaseTraits {
  const ReadRun* run = nullptr;
  std::vector<double> clearances;  ///< [m] one a clearance joint
  std::vector<double> speeds;      ///< [rad/s or m/s] one a driver
  std::vector<NamedText> others;   ///< changes of anything else, sorted
};

CaseTraits find_traits(const ReadRun& run) {
  CaseTraits traits;
  traits.run = &run;
  for (const Joint& joint : run.model->mechanism.joints) {
    if (has_clearance(joint.kind)) traits.clearances.push_back(find_clearance(joint.kind));
  }
  for (const Driver& driver : run.model->mechanism.drivers) traits.speeds.push_back(driver.speed);
  std::vector<NamedText> changes = run.outline.overrides;
  const auto found = std::ranges::find(run.model->cases, run.model->case_name, &Case::name);
  if (found != run.model->cases.end()) std::ranges::copy(found->overrides, std::back_inserter(changes));
  for (const auto& [path, value] : changes) {
    const bool is_told = path.ends_with("clearance") || (path.starts_with("drivers.") && path.ends_with(".speed"));
    if (!is_told && path != "study.reference") traits.others.emplace_back(path, value);
  }
  std::ranges::sort(traits.others);
  return traits;
}

/// The largest group of cases that share everything but one trait, the smallest value of it first.
template <class SharesRest>
std::vector<CaseTraits> find_group(const std::vector<CaseTraits>& all, std::vector<double> CaseTraits::*varied,
                                   SharesRest shares_rest) {
  std::vector<CaseTraits> largest;
  for (const CaseTraits& one : all) {
    std::vector<CaseTraits> group;
    for (const CaseTraits& other : all) {
      const bool is_new = std::ranges::none_of(group, [&](const CaseTraits& g) { return g.*varied == other.*varied; });
      if (shares_rest(one, other) && is_new) group.push_back(other);
    }
    if (group.size() > largest.size()) largest = std::move(group);
  }
  const auto find_size = [&](const CaseTraits& one) {
    const auto& values = one.*varied;
    return values.empty() ? 0.0 : std::abs(values.front());
  };
  std::ranges::stable_sort(largest, {}, find_size);
  return largest;
}

CaseComparison make_comparison(std::string id, std::string title, const std::vector<CaseTraits>& group,
                               std::vector<double> CaseTraits::*varied, const FigureAxis& axis) {
  CaseComparison comparison{std::move(id), std::move(title), axis, {}};
  for (const CaseTraits& one : group) {
    const double value = std::abs((one.*varied).front());
    comparison.cases.push_back({format_engineering(value, axis.unit), value, &one.run->outline});
  }
  return comparison;
}

}  // namespace

std::vector<CaseComparison> group_cases(std::span<const ReadRun> runs) {
  std::vector<CaseTraits> all;
  for (const ReadRun& run : runs) {
    if (run.model && !run.outline.stages.empty()) all.push_back(find_traits(run));
  }
  std::vector<CaseComparison> comparisons;
  const auto over_clearance = find_group(all, &CaseTraits::clearances, [](const CaseTraits& a, const CaseTraits& b) {
    return a.speeds == b.speeds && a.others == b.others && !a.clearances.empty();
  });
  if (over_clearance.size() > 1) {
    comparisons.push_back(make_comparison("clearance", "over clearance", over_clearance, &CaseTraits::clearances,
                                          {"Clearance", "m", "m", 1.0}));
  }
  const auto over_speed = find_group(all, &CaseTraits::speeds, [](const CaseTraits& a, const CaseTraits& b) {
    return a.clearances == b.clearances && a.others == b.others && !a.speeds.empty();
  });
  if (over_speed.size() > 1) {
    comparisons.push_back(
        make_comparison("speed", "over speed", over_speed, &CaseTraits::speeds, {"Speed", "rad/s", "rad/s", 1.0}));
  }
  if (comparisons.empty() && all.size() > 1) {
    CaseComparison& every = comparisons.emplace_back(CaseComparison{"case", "in every case", {}, {}});
    for (const CaseTraits& one : all)
      every.cases.push_back({.label = one.run->outline.case_name, .run = &one.run->outline});
  }
  return comparisons;
}

}  // namespace gudgeon
