// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Rigid bodies grow pass by pass, the smaller one taken into the axes of the larger.
#include "gudgeon/system/pinned_bodies.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

namespace gudgeon {

namespace {

double find_direction(Vec2 vector) { return std::atan2(vector.y, vector.x); }

// Where a body is in the axes of its rigid body.
struct Place {
  Vec2 origin;
  double angle = 0.0;

  [[nodiscard]] Vec2 find(Vec2 point) const { return origin + make_rotation(angle) * point; }
};

class RigidBodies {
 public:
  RigidBodies(const Mechanism& mechanism, const std::vector<JointEnds>& ends)
      : mechanism_(mechanism), ends_(ends), places_(mechanism.bodies.size()), members_(mechanism.bodies.size()) {
    found_.rigid_body.resize(mechanism.bodies.size());
    std::iota(found_.rigid_body.begin(), found_.rigid_body.end(), 0);
    for (std::size_t b = 0; b < members_.size(); ++b) members_[b] = {static_cast<int>(b)};
  }

  PinnedBodies find() {
    join_rigid();
    while (join_pinned()) {
    }
    find_sizes();
    is_pinned_.assign(members_.size(), false);
    for (const PinnedPair& pair : found_.pairs) is_pinned_[at(ends_[pair.joint].first)] = true;
    for (std::size_t j = 0; j < ends_.size(); ++j) found_.is_inner.push_back(coincides(j));
    return std::move(found_);
  }

 private:
  [[nodiscard]] int at(const JointEnd& end) const { return found_.rigid_body[end.body]; }
  // The end's point in the axes of its rigid body.
  [[nodiscard]] Vec2 find_point(const JointEnd& end) const { return places_[end.body].find(end.point); }

  // Takes the rigid body of `inner` into the axes of that of `outer`, turned by an angle, the two points together.
  void join(const JointEnd& outer, const JointEnd& inner, double angle) {
    if (members_[at(outer)].size() < members_[at(inner)].size()) return join(inner, outer, -angle);
    const Vec2 from = find_point(inner);
    const Vec2 to = find_point(outer);
    const Rotation rotation = make_rotation(angle);
    std::vector<int> joined = std::exchange(members_[at(inner)], {});
    const int target = at(outer);
    for (const int body : joined) {
      places_[body] = {to + rotation * (places_[body].origin - from), places_[body].angle + angle};
      found_.rigid_body[body] = target;
      members_[target].push_back(body);
    }
  }

  void join_rigid() {
    for (std::size_t j = 0; j < ends_.size(); ++j) {
      const auto* rigid = std::get_if<Rigid>(&mechanism_.joints[j].kind);
      const auto& [first, second] = ends_[j];
      if (rigid == nullptr || at(first) == at(second)) continue;
      join(first, second, places_[first.body].angle + rigid->relative_angle - places_[second.body].angle);
    }
  }

  // One pass over all pairs of rigid bodies with two revolute joints and more.
  bool join_pinned() {
    std::map<std::pair<int, int>, std::vector<int>> pins;
    for (std::size_t j = 0; j < ends_.size(); ++j) {
      const auto& [first, second] = ends_[j];
      if (!std::holds_alternative<Revolute>(mechanism_.joints[j].kind) || at(first) == at(second)) continue;
      pins[std::minmax({at(first), at(second)})].push_back(static_cast<int>(j));
    }
    bool joined = false;
    for (const auto& [pair, joints] : pins) {
      // Bodies may have been joined to others in this pass.
      if (joints.size() < 2 || members_[pair.first].empty() || members_[pair.second].empty()) continue;
      joined = join_pair(joints) || joined;
    }
    return joined;
  }

  // The first joint and the one farthest from it.
  bool join_pair(const std::vector<int>& joints) {
    const int one = joints.front();
    const JointEnd outer = ends_[one].first;
    const JointEnd inner = ends_[one].second;
    const auto find_arms = [&](int joint) {
      const bool same = at(ends_[joint].first) == at(outer);
      const auto& [first, second] = ends_[joint];
      return std::pair{find_point(same ? first : second) - find_point(outer),
                       find_point(same ? second : first) - find_point(inner)};
    };
    const int other = *std::ranges::max_element(joints, {}, [&](int joint) { return norm(find_arms(joint).first); });
    const auto [outer_arm, inner_arm] = find_arms(other);
    const double length = norm(outer_arm);
    if (!(length > 0.0) || std::abs(length - norm(inner_arm)) > kSameLength * length) return false;
    join(outer, inner, find_direction(outer_arm) - find_direction(inner_arm));
    const auto& [first, second] = ends_[other];
    const double angle = std::remainder(places_[second.body].angle - places_[first.body].angle, 2.0 * std::numbers::pi);
    found_.pairs.push_back({one, other, angle});
    return true;
  }

  [[nodiscard]] bool coincides(std::size_t joint) const {
    const AnyJoint& kind = mechanism_.joints[joint].kind;
    const auto& [first, second] = ends_[joint];
    if (!std::holds_alternative<Revolute>(kind) && !std::holds_alternative<Rigid>(kind)) return false;
    if (at(first) != at(second) || !is_pinned_[at(first)]) return false;
    return norm(find_point(second) - find_point(first)) <= kSameLength * sizes_[at(first)];
  }

  // How far the joints of each rigid body lie from its origin at most.
  void find_sizes() {
    sizes_.assign(members_.size(), 0.0);
    for (const auto& [first, second] : ends_) {
      for (const JointEnd& end : {first, second}) sizes_[at(end)] = std::max(sizes_[at(end)], norm(find_point(end)));
    }
  }

  const Mechanism& mechanism_;
  const std::vector<JointEnds>& ends_;
  std::vector<Place> places_;              // one a body
  std::vector<std::vector<int>> members_;  // bodies of each rigid body
  std::vector<double> sizes_;              // of each rigid body
  std::vector<bool> is_pinned_;            // one a rigid body: it has a pair
  PinnedBodies found_;
};

}  // namespace

PinnedBodies find_pinned_bodies(const Mechanism& mechanism, const std::vector<JointEnds>& ends) {
  return RigidBodies(mechanism, ends).find();
}

}  // namespace gudgeon
