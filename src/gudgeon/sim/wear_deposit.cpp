// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Pressure, laws, and the two rules of deposition.
#include "gudgeon/sim/wear_deposit.h"

#include <cmath>
#include <numbers>

#include "gudgeon/geometry/contact_arc.h"

namespace gudgeon {

namespace {

// Depth at the middle of an arc over its mean depth.
constexpr double kParabolaPeak = 1.5;

double find_wear_rate(const AnyWear& any, const WearContact& contact) noexcept {
  return std::visit([&](const auto& law) { return law(contact); }, any);
}

std::vector<double> magnified(const ArcAccumulator& deposits, double magnification) {
  std::vector<double> depths = deposits.sum();
  for (double& depth : depths) depth *= magnification;
  return depths;
}

// Depth over a circumference of equal regions, as volume.
double find_volume(const std::vector<double>& depths, double radius, double width) {
  double sum = 0.0;
  for (const double depth : depths) sum += depth;
  return sum * 2.0 * std::numbers::pi * radius / static_cast<double>(depths.size()) * width;
}

std::vector<double> surface_depth(const RadialProfile& profile, std::size_t n_regions) {
  return profile.is_worn() ? profile.region_depths() : std::vector<double>(n_regions, 0.0);
}

}  // namespace

WearDeposit::WearDeposit(const Contact& contact, Deposition deposition, int n_regions, double magnification)
    : contact_(&contact),
      deposition_(deposition),
      magnification_(magnification),
      bearing_(static_cast<std::size_t>(n_regions)),
      journal_(static_cast<std::size_t>(n_regions)),
      total_(static_cast<std::size_t>(n_regions)) {}

void WearDeposit::add(const ContactSample& sample, double weight) noexcept {
  if (!(sample.normal_force > 0.0)) return;
  const double speed = std::abs(sample.slip_speed);
  const double length = find_contact_arc(sample.penetration, sample.bearing_radius, sample.journal_radius).length;
  const double pressure = sample.normal_force / (contact_->width * length);
  // Half-way through this part of the step: the sum over the parts is then a midpoint rule in the distance.
  const double distance = sliding_distance_ + 0.5 * weight * speed;
  WearContact wear{pressure, speed, std::abs(sample.friction_force) / sample.normal_force, sample.bearing_depth,
                   contact_->sliding_distance + magnification_ * distance};
  const double bearing_depth = weight * find_wear_rate(contact_->bearing_wear, wear);
  wear.depth = sample.journal_depth;
  const double journal_depth = weight * find_wear_rate(contact_->journal_wear, wear);
  sliding_distance_ += weight * speed;
  impulse_ += weight * sample.normal_force;
  volume_ += (bearing_depth + journal_depth) * length * contact_->width;

  const double direction = std::atan2(sample.normal.y, sample.normal.x);
  const double bearing_at = direction - sample.bearing_angle;
  // As angles of the unworn radii, so that depth times circumference is the volume removed.
  const double bearing_width = length / contact_->surfaces.bearing_radius;
  lay(bearing_, bearing_at, bearing_width, bearing_depth);
  lay(journal_, direction - sample.journal_angle, length / contact_->surfaces.journal_radius, journal_depth);
  lay(total_, bearing_at, bearing_width, bearing_depth + journal_depth);
}

void WearDeposit::lay(ArcAccumulator& surface, double angle, double width, double mean_depth) const noexcept {
  const bool parabolic = contact_->pressure == PressureDistribution::parabolic;
  if (deposition_ == Deposition::point) {
    surface.add_point(angle, parabolic ? kParabolaPeak * mean_depth : mean_depth);
  } else if (parabolic) {
    surface.add_parabola(angle, width, mean_depth);
  } else {
    surface.add_arc(angle, width, mean_depth);
  }
}

JointWear WearDeposit::summarize(const std::string& joint) const {
  JointWear wear;
  wear.joint = joint;
  wear.bearing_radius = contact_->surfaces.bearing_radius;
  wear.journal_radius = contact_->surfaces.journal_radius;
  wear.width = contact_->width;
  wear.bearing_depth_added = magnified(bearing_, magnification_);
  wear.journal_depth_added = magnified(journal_, magnification_);
  wear.total_depth_added = magnified(total_, magnification_);
  wear.bearing_depth = surface_depth(contact_->surfaces.bearing_wear, wear.bearing_depth_added.size());
  wear.journal_depth = surface_depth(contact_->surfaces.journal_wear, wear.journal_depth_added.size());
  wear.archard_volume = volume_ * magnification_;
  wear.removed_volume = find_volume(wear.bearing_depth_added, wear.bearing_radius, wear.width) +
                        find_volume(wear.journal_depth_added, wear.journal_radius, wear.width);
  wear.sliding_distance = sliding_distance_;
  wear.contact_time = contact_time_;
  wear.impulse = impulse_;
  return wear;
}

}  // namespace gudgeon
