// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Angles, places and displacements that start values are given for, and how they move with the free coordinates.
#pragma once

#include <Eigen/Dense>
#include <string>
#include <utility>
#include <vector>

#include "gudgeon/system/coordinates.h"

namespace gudgeon {

/// One number of a mechanism's position.
struct StartQuantity {
  double value = 0.0;                            ///< [rad, m]
  double rate = 0.0;                             ///< with the rates of all coordinates, driven ones among them
  std::vector<std::pair<int, double>> gradient;  ///< by free coordinate, each at most once; empty: nothing moves it

  /// The gradient as a row [n_free].
  [[nodiscard]] Eigen::RowVectorXd make_row(Eigen::Index n_free) const;
  /// The free coordinate that it is but for a constant, or -1.
  [[nodiscard]] int find_coordinate() const;
};

/// A start value of the description, of a position or of a rate.
struct GivenStart {
  enum class Kind { angle, x, y, displacement };
  Kind kind = Kind::angle;
  int index = 0;       ///< of the body; of the joint of a displacement
  double value = 0.0;  ///< [rad, m] or [rad/s, m/s]
  std::string path;    ///< "bodies.rod.start.angle"
  std::string name;    ///< "body 'rod': its start angle"
};

/// The angles, displacements and places given for the start: bodies in their order, then joints.
std::vector<GivenStart> list_given_positions(const Mechanism& mechanism);
/// The rates given for the start.
std::vector<GivenStart> list_given_rates(const Mechanism& mechanism);

/// What a start value is given for, at up-to-date coordinates.
StartQuantity find_quantity(const Mechanism& mechanism, const Topology& topology, const GivenStart& given,
                            const Coordinates& coordinates);

/// The component of the way from a point of one body to a point of another along a unit vector in the axes of a third
/// one, as seen from there.
struct DirectedWay {
  int from_body = 0;
  Vec2 from;
  int to_body = 0;
  Vec2 to;
  int axes_body = 0;
  Vec2 direction;
};
StartQuantity find_quantity(const Topology& topology, const DirectedWay& way, const Coordinates& coordinates);
/// The angle of a body.
StartQuantity find_angle(const Topology& topology, int body, const Coordinates& coordinates);

/// From where a quantity is to where it should be; an angle on the shorter way.
double find_way(const GivenStart& given, double from);

}  // namespace gudgeon
