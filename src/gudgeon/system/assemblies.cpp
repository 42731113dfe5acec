// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Group after group: for every way to close those before it, all ways to close the next one.
#include "gudgeon/system/assemblies.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "gudgeon/system/closure_rank.h"

namespace gudgeon {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// [shares of the size] A group is closed; loops of the whole mechanism are then closed to rounding.
constexpr double kGroupClosed = 1e-12;
constexpr int kMostGroupSteps = 60;
// [rad, shares of the size] Positions that differ by less are one; where two meet they are known to about the root of
// how well loops are closed.
constexpr double kSamePosition = 1e-5;
// Starts without any success after which a group counts as one that cannot be closed.
constexpr std::size_t kVainStarts = 1000;
constexpr std::size_t kMostStarts = 20000;
// Boender and Rinnooy Kan (1987): after n starts that found w positions, w (n − 1)/(n − w − 2) are expected in all. So
// few more than were found must be left.
constexpr double kUnseen = 0.01;
// More ways than that to assemble one mechanism help nobody.
constexpr std::size_t kMostAssemblies = 1024;

bool is_enough(std::size_t n_starts, std::size_t n_found) {
  if (n_found == 0) return n_starts >= kVainStarts;
  if (n_starts <= n_found + 2) return false;
  const auto n = static_cast<double>(n_starts);
  const auto w = static_cast<double>(n_found);
  return w * (n - 1.0) / (n - w - 2.0) <= w + kUnseen || n_starts >= kMostStarts;
}

class AssemblySearch {
 public:
  AssemblySearch(const Tables& tables, const LoopFolds& folds, LoopCloser& closer)
      : tables_(tables), folds_(folds), closer_(closer), starts_(tables) {}

  std::vector<VectorXd> run() {
    search(0);
    return std::move(positions_);
  }

 private:
  void search(std::size_t group) {
    if (positions_.size() >= kMostAssemblies) return;
    if (group == folds_.groups().size()) {
      const VectorXd q = closer_.q;
      if (closer_.close() && is_new(closer_.q, positions_)) positions_.push_back(closer_.q);
      closer_.q = q;
      return;
    }
    const VectorXd before = closer_.q;
    for (const VectorXd& q : find_group_positions(folds_.groups()[group])) {
      closer_.q = q;
      search(group + 1);
    }
    closer_.q = before;
  }

  std::vector<VectorXd> find_group_positions(const LoopGroup& group) {
    std::vector<VectorXd> found;
    const VectorXd before = closer_.q;
    for (std::size_t n = 0; !is_enough(n, found.size()); ++n) {
      closer_.q = before;
      if (n > 0) starts_.scatter(group.unknowns, closer_.q);
      if (!close_group(group) || !is_new(closer_.q, found)) continue;
      found.push_back(closer_.q);
      if (!group.is_dyad) continue;
      // A dyad has this position and its mirror image.
      const LoopFold fold = folds_.find_fold(group);
      closer_.update();
      VectorXd mirrored = closer_.q;
      if (!folds_.mirror(fold, closer_.workspace.coordinates, mirrored.data())) break;
      closer_.q = mirrored;
      if (close_group(group) && is_new(closer_.q, found)) found.push_back(closer_.q);
      break;
    }
    closer_.q = before;
    return found;
  }

  // Levenberg-Marquardt on the group's rows and unknowns alone.
  bool close_group(const LoopGroup& group) {
    double damping = 1e-3;
    double error = look(group);
    for (int step = 0; step < kMostGroupSteps; ++step) {
      if (error <= kGroupClosed) return true;
      if (group.unknowns.empty()) return false;
      MatrixXd normal = jacobian_.transpose() * jacobian_;
      normal.diagonal().array() += damping;
      const VectorXd change = normal.ldlt().solve(-jacobian_.transpose() * gaps_);
      const VectorXd from = closer_.q;
      const MatrixXd jacobian_before = jacobian_;
      const VectorXd gaps_before = gaps_;
      for (std::size_t k = 0; k < group.unknowns.size(); ++k) {
        closer_.q(group.unknowns[k]) += change(static_cast<Index>(k)) * find_unit(group.unknowns[k]);
      }
      const double closed = look(group);
      if (closed < error) {
        error = closed;
        damping *= 0.1;
        continue;
      }
      closer_.q = from;
      jacobian_ = jacobian_before;
      gaps_ = gaps_before;
      damping *= 10.0;
      if (damping > 1e6) return false;
    }
    return error <= kGroupClosed;
  }

  // Gaps and Jacobian of the group in shares of the size; returns the norm of the gaps.
  double look(const LoopGroup& group) {
    closer_.update();
    const MatrixXd all = find_closure_jacobian(tables_, closer_.workspace);
    const VectorXd all_gaps = find_closure_gaps(closer_.workspace);
    const auto n_rows = static_cast<Index>(2 * group.closures.size());
    jacobian_.resize(n_rows, static_cast<Index>(group.unknowns.size()));
    gaps_.resize(n_rows);
    for (std::size_t c = 0; c < group.closures.size(); ++c) {
      const double unit = tables_.closures[group.closures[c]].kind == ClosureKind::angle ? 1.0 : closer_.size();
      for (int k = 0; k < 2; ++k) {
        const auto row = static_cast<Index>(2 * c) + k;
        const Index at = 2 * static_cast<Index>(group.closures[c]) + k;
        gaps_(row) = all_gaps(at) / unit;
        for (std::size_t u = 0; u < group.unknowns.size(); ++u) {
          jacobian_(row, static_cast<Index>(u)) = all(at, group.unknowns[u]) * find_unit(group.unknowns[u]) / unit;
        }
      }
    }
    return gaps_.norm();
  }

  [[nodiscard]] double find_unit(int coordinate) const {
    return coordinate < tables_.counts.n_free_turns ? 1.0 : closer_.size();
  }

  [[nodiscard]] bool is_new(const VectorXd& q, const std::vector<VectorXd>& known) const {
    return std::ranges::none_of(known, [&](const VectorXd& other) {
      for (Index k = 0; k < q.size(); ++k) {
        const bool turns = k < tables_.counts.n_free_turns;
        const double apart =
            turns ? std::remainder(q(k) - other(k), 2.0 * std::numbers::pi) : (q(k) - other(k)) / closer_.size();
        if (std::abs(apart) > kSamePosition) return false;
      }
      return true;
    });
  }

  const Tables& tables_;
  const LoopFolds& folds_;
  LoopCloser& closer_;
  ScatteredStarts starts_;
  MatrixXd jacobian_;
  VectorXd gaps_;
  std::vector<VectorXd> positions_;
};

}  // namespace

ScatteredStarts::ScatteredStarts(const Tables& tables) : tables_(&tables) {
  for (const ClosureRows& rows : tables.closures) {
    double length = 0.0;
    for (int t = rows.first_term; t < rows.end_term; ++t) length += norm(tables.closure_terms[t].vector);
    reach_ = std::max(reach_, length);
  }
}

void ScatteredStarts::scatter(const std::vector<int>& coordinates, VectorXd& q) {
  for (const int coordinate : coordinates) {
    // SplitMix64, which is the same on every machine.
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    z ^= z >> 31U;
    const double share = std::ldexp(static_cast<double>(z >> 11U), -52) - 1.0;  // from -1 to 1
    q(coordinate) = share * (coordinate < tables_->counts.n_free_turns ? std::numbers::pi : reach_);
  }
}

std::optional<std::vector<VectorXd>> find_assemblies(const Topology& topology, const Tables& tables, LoopCloser& closer,
                                                     const std::vector<int>& pinned) {
  const LoopFolds folds(topology, tables, pinned);
  if (!std::ranges::all_of(folds.groups(), &LoopGroup::is_determined)) return std::nullopt;
  const VectorXd before = closer.q;
  std::vector<VectorXd> positions = AssemblySearch(tables, folds, closer).run();
  closer.q = before;
  closer.update();
  return positions;
}

}  // namespace gudgeon
