// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Pressure, laws, and the two rules of distribution; equations are numbered as in docs/theory/wear.md.
#include "gudgeon/sim/wear_accumulator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "gudgeon/geometry/contact_arc.h"
#include "gudgeon/geometry/moving_mean.h"

namespace gudgeon {

namespace {

// Depth at the middle of an arc over its mean depth.
constexpr double kParabolaPeak = 1.5;
// [m] A law may press before its surfaces touch: its arc is then that of a hundredth of an atom.
constexpr double kLeastPenetration = 1e-12;

// The ends of an arc, where pressure goes to zero between elastic bodies, are ramps of this share of it at least: a
// step there would make a worn surface the rougher the finer its cells.
constexpr double kSoftEdge = 0.1;

// Depths are told no finer than this share of the contact's mean length: shorter waves come from the steps that it was
// distributed in, not from the motion.
constexpr double kFinest = 0.1;

// A contact that moves and grows by less than this share of its length within a step does so evenly.
constexpr double kHardly = 0.1;
// Parts of the way of a contact that turns back within a step.
constexpr int kWays = 32;
// Stages of a step that places are taken from, at most.
constexpr std::size_t kMostPlaces = 8;

// How fast a contact wears at one instant of a step against another [W].
double find_intensity(const ContactSample& sample) noexcept {
  return sample.normal_force * std::abs(sample.slip_speed);
}

double find_place_intensity(const WearAccumulator::StepSample& at) noexcept {
  return at.contact->normal_force > 0.0 ? find_intensity(*at.contact) : 0.0;
}

// Whether a contact that presses throughout slides one way first, then the other.
bool turns_back(std::span<const WearAccumulator::StepSample> places) noexcept {
  const double first = places.front().contact->slip_speed;
  return std::ranges::all_of(places, [](const auto& at) { return at.contact->normal_force > 0.0; }) &&
         std::ranges::any_of(places, [&](const auto& at) { return at.contact->slip_speed * first < 0.0; });
}

// The shorter way round, where there is one.
double find_turn(double difference, bool is_round) noexcept {
  if (!is_round || std::abs(difference) <= std::numbers::pi) return difference;
  return std::remainder(difference, 2.0 * std::numbers::pi);
}

double find_wear_rate(const AnyWear& any, const WearContact& contact) noexcept {
  return std::visit([&](const auto& law) { return law(contact); }, any);
}

// M h_k, h_k averaged three times over a tenth of the contacts' length (Eqs. W4, W7): surface after surface; of a round
// one the last cell is beside the first.
std::vector<double> find_accelerated(const std::vector<ArcAccumulator>& accumulators, double wear_acceleration,
                                     double finest, bool is_round) {
  std::vector<double> depths;
  for (const ArcAccumulator& accumulator : accumulators) {
    std::vector<double> surface = accumulator.sum();
    smooth_by_moving_means(surface, finest * static_cast<double>(surface.size()), is_round);
    for (const double depth : surface) depths.push_back(depth * wear_acceleration);
  }
  return depths;
}

// Depth over the cells of n circumferences, as volume.
double find_volume(const std::vector<double>& depths, std::size_t n, double radius, double width) {
  double sum = 0.0;
  for (const double depth : depths) sum += depth;
  return sum * 2.0 * std::numbers::pi * radius * static_cast<double>(n) / static_cast<double>(depths.size()) * width;
}

// The depths that a stage ran on, into the place of one of n surfaces.
template <class Profile>
void copy_depths(const Profile& profile, int surface, std::size_t n, std::vector<double>& depths) {
  if (!profile.is_worn()) return;
  const auto first = static_cast<std::size_t>(surface) * (depths.size() / n);
  std::ranges::copy(profile.cell_depths(), depths.begin() + static_cast<std::ptrdiff_t>(first));
}

}  // namespace

WearAccumulator::WearAccumulator(std::span<const Contact> contacts, WearDistribution distribution, int n_cells,
                                 double wear_acceleration)
    : contacts_(contacts), distribution_(distribution), wear_acceleration_(wear_acceleration) {
  if (const auto* slot = std::get_if<GuideSurfaces>(&contacts.front().surfaces)) {
    slot_length_ = 2.0 * slot->half_length;
    bearing_radius_ = slot_length_ / (2.0 * std::numbers::pi);
    journal_radius_ = slot->journal_radius;
  } else {
    const auto& round = std::get<RevoluteSurfaces>(contacts.front().surfaces);
    bearing_radius_ = round.bearing_radius;
    journal_radius_ = round.journal_radius;
  }
  const ArcAccumulator none(static_cast<std::size_t>(n_cells));
  for (const Contact& contact : contacts) {
    bearing_.resize(std::max(bearing_.size(), static_cast<std::size_t>(contact.bearing_surface) + 1), none);
    journal_.resize(std::max(journal_.size(), static_cast<std::size_t>(contact.journal_surface) + 1), none);
  }
  total_ = bearing_;
}

void WearAccumulator::add(std::span<const StepSample> samples) noexcept {
  const auto presses = [](const StepSample& at) { return at.contact->normal_force > 0.0; };
  double slip = 0.0;
  double impulse = 0.0;
  const StepSample* last = nullptr;
  for (const StepSample& at : samples) {
    if (!presses(at)) continue;
    slip += at.weight * std::abs(at.contact->slip_speed);
    impulse += at.weight * at.contact->normal_force;
    last = &at;
  }
  if (last == nullptr) return;
  impulse_ += impulse;
  Amounts worn;
  for (const StepSample& at : samples) {
    if (!presses(at) || at.weight == 0.0) continue;
    const Amounts rates = find_rates(*at.contact, sliding_distance_ + at.node * slip);
    worn.bearing += at.weight * rates.bearing;
    worn.journal += at.weight * rates.journal;
  }
  std::array<StepSample, kMostPlaces> places;
  std::size_t n_places = 0;
  bool is_placed = false;
  for (const StepSample& at : samples) {
    if ((at.node > 0.0 && at.share == 0.0) || n_places == kMostPlaces) continue;
    places[n_places++] = at;
    is_placed = is_placed || (presses(at) && find_intensity(*at.contact) > 0.0);
  }
  const std::span<const StepSample> known(places.data(), n_places);
  if (is_placed && turns_back(known)) {
    const double factor = find_turning_factor(samples, known);
    slip *= factor;
    worn.bearing *= factor;
    worn.journal *= factor;
  }
  sliding_distance_ += slip;
  volume_ += (worn.bearing + worn.journal) * contacts_.front().width;
  if (!is_placed) {
    distribute_at(find_place(*last), worn);
  } else if (distribution_ == WearDistribution::point) {
    distribute_points(known, worn);
  } else {
    distribute_path(known, worn);
  }
}

double WearAccumulator::find_length(const ContactSample& sample) const noexcept {
  const double penetration = std::max(sample.penetration, kLeastPenetration);
  return slot_length_ > 0.0 ? find_flat_contact_length(penetration, sample.journal_radius)
                            : find_contact_arc(penetration, sample.bearing_radius, sample.journal_radius).length;
}

// ḣ L [m^2/s], ḣ = k_d p |v| or as another law has it, after a distance slid in this stage: laws are proportional to
// the pressure, here the mean p = F/(w L), and are asked at p L      (Eqs. W1, W3)
WearAccumulator::Amounts WearAccumulator::find_rates(const ContactSample& sample, double distance) const noexcept {
  const Contact& contact = contacts_.front();  // its laws and width are those of all
  WearContact wear{sample.normal_force / contact.width, std::abs(sample.slip_speed),
                   std::abs(sample.friction_force) / sample.normal_force, sample.bearing_depth,
                   contact.sliding_distance + wear_acceleration_ * distance};
  const double bearing = find_wear_rate(contact.bearing_wear, wear);
  wear.depth = sample.journal_depth;
  return {bearing, find_wear_rate(contact.journal_wear, wear)};
}

// As angles of the unworn radii, so that depth times circumference is the volume removed.
WearAccumulator::Place WearAccumulator::find_place(const StepSample& at) const noexcept {
  const ContactSample& sample = *at.contact;
  const double length = find_length(sample);
  const double direction = std::atan2(sample.normal.y, sample.normal.x);
  const double bearing_at = slot_length_ > 0.0 ? find_side_angle(sample.bearing_position, length / bearing_radius_)
                                               : direction - sample.bearing_angle;
  return {&sample, at.node, find_place_intensity(at), length, bearing_at, direction - sample.journal_angle};
}

// Lagrange's polynomials; the intensity is that of the slip and of the force, each by its own.
WearAccumulator::Place WearAccumulator::interpolate(std::span<const Place> places, double node) noexcept {
  Place at = places.front();
  at.node = node;
  at.length = at.bearing_at = at.journal_at = 0.0;
  double slip = 0.0;
  double force = 0.0;
  for (const Place& place : places) {
    double weight = 1.0;
    for (const Place& other : places) {
      if (other.node != place.node) weight *= (node - other.node) / (place.node - other.node);
    }
    at.length += weight * place.length;
    at.bearing_at += weight * place.bearing_at;
    at.journal_at += weight * place.journal_at;
    slip += weight * place.sample->slip_speed;
    force += weight * place.sample->normal_force;
  }
  at.length = std::max(at.length, kLeastPenetration);
  at.intensity = std::max(force, 0.0) * std::abs(slip);
  return at;
}

void WearAccumulator::distribute_points(std::span<const StepSample> places, const Amounts& worn) noexcept {
  double whole = 0.0;
  for (const StepSample& at : places) whole += at.share * find_place_intensity(at);
  for (const StepSample& at : places) {
    // Where only a stage without a share presses, it is the place.
    const double intensity = find_place_intensity(at);
    const double part = whole > 0.0 ? at.share * intensity / whole : intensity > 0.0 ? 1.0 : 0.0;
    if (part > 0.0) distribute_at(find_place(at), {part * worn.bearing, part * worn.journal});
  }
}

// From place to place, in parts as the trapezoidal rule has them; those between which the contact hardly moves or grows
// at once.
void WearAccumulator::distribute_path(std::span<const StepSample> places, const Amounts& worn) noexcept {
  Place from = find_place(places.front());
  const Place end = find_place(places.back());
  if (places.size() == 1) {
    distribute_at(end, worn);
    return;
  }
  // A contact that begins with the step begins as a point.
  const bool begins = from.node > 0.0;
  if (begins) from.node = from.intensity = from.length = 0.0;
  if (turns_back(places)) {
    // One that sticks turns often, and goes nowhere.
    double way = 0.0;
    for (std::size_t k = 1; k < places.size(); ++k) {
      way += find_movement(find_place(places[k - 1]), find_place(places[k]));
    }
    if (way > kHardly * (from.length + end.length)) {
      distribute_turning_path(places, worn);
      return;
    }
  }
  if (find_movement(from, end) < kHardly * (from.length + end.length)) {
    distribute_between(from, end, worn);
    return;
  }
  const auto find_part = [](double duration, double a, double b) { return duration * (a + b); };
  double whole = 0.0;
  double node = from.node;
  double intensity = from.intensity;
  for (const StepSample& at : places.subspan(begins ? 0 : 1)) {
    const double next = find_place_intensity(at);
    whole += find_part(at.node - node, intensity, next);
    node = at.node;
    intensity = next;
  }
  double part = 0.0;  // since `from`, up to which the wear is distributed
  double before = from.intensity;
  double since = from.node;
  for (const StepSample& at : places.subspan(begins ? 0 : 1)) {
    const Place to = find_place(at);
    part += find_part(to.node - since, before, to.intensity) / whole;
    since = to.node;
    before = to.intensity;
    if (&at != &places.back() && find_movement(from, to) < kHardly * (from.length + to.length)) continue;
    if (part > 0.0) distribute_between(from, to, {part * worn.bearing, part * worn.journal});
    from = to;
    part = 0.0;
  }
}

// The same where the contact turns back within the step, beyond all of its places perhaps: along the polynomial through
// them, in many short ways.
void WearAccumulator::distribute_turning_path(std::span<const StepSample> samples, const Amounts& worn) noexcept {
  std::array<Place, kMostPlaces> memory{};
  const std::span<const Place> places = find_turning_places(samples, memory);
  const double whole = sum_ways(places);
  Place from = find_way(places, 0);
  for (int way = 1; way <= kWays; ++way) {
    const Place to = find_way(places, way);
    const double part = whole > 0.0 ? 0.5 * (from.intensity + to.intensity) / (kWays * whole) : 1.0 / kWays;
    if (part > 0.0) distribute_between(from, to, {part * worn.bearing, part * worn.journal});
    from = to;
  }
}

// What the rule of the step, which is meant for smooth integrands, makes of F |v| where v changes its sign, is replaced
// by the integral over the polynomials.
double WearAccumulator::find_turning_factor(std::span<const StepSample> samples,
                                            std::span<const StepSample> known) const noexcept {
  std::array<Place, kMostPlaces> memory{};
  const std::span<const Place> places = find_turning_places(known, memory);
  double duration = 0.0;
  double rule = 0.0;
  for (const StepSample& at : samples) {
    duration += at.weight;
    rule += at.weight * find_place_intensity(at);
  }
  const double factor = duration * sum_ways(places) / rule;
  // Where next to nothing slides the rule may leave nothing, or less.
  return factor > 0.5 && factor < 2.0 ? factor : 1.0;
}

std::span<const WearAccumulator::Place> WearAccumulator::find_turning_places(std::span<const StepSample> samples,
                                                                             std::span<Place> places) const noexcept {
  for (std::size_t k = 0; k < samples.size(); ++k) {
    places[k] = find_place(samples[k]);
    // Not from turn to turn of an angle.
    places[k].bearing_at =
        places[0].bearing_at + find_turn(places[k].bearing_at - places[0].bearing_at, slot_length_ == 0.0);
    places[k].journal_at = places[0].journal_at + find_turn(places[k].journal_at - places[0].journal_at, true);
  }
  return places.first(samples.size());
}

WearAccumulator::Place WearAccumulator::find_way(std::span<const Place> places, int way) noexcept {
  const double first = places.front().node;
  return interpolate(places, first + (places.back().node - first) * way / kWays);
}

// Mean intensity over the step [W].
double WearAccumulator::sum_ways(std::span<const Place> places) noexcept {
  double sum = 0.0;
  for (int way = 0; way <= kWays; ++way) {
    sum += (way == 0 || way == kWays ? 0.5 : 1.0) * find_way(places, way).intensity;
  }
  return sum / kWays;
}

// How far [m] the contact moves and grows on the surface where it does so more.
double WearAccumulator::find_movement(const Place& from, const Place& to) const noexcept {
  const double along_bearing = std::abs(find_turn(to.bearing_at - from.bearing_at, slot_length_ == 0.0));
  const double along_journal = std::abs(find_turn(to.journal_at - from.journal_at, true));
  return std::max(along_bearing * bearing_radius_, along_journal * journal_radius_) + std::abs(to.length - from.length);
}

void WearAccumulator::distribute_at(const Place& place, const Amounts& amounts) noexcept {
  distribute_between(place, place, amounts);
}

// Over what the contact covers on its way, whose mean length L̄ the amounts are spread over:
// h(x) = V/(w L̄) · (share of the movement during which the arc covers x)      (Eq. W4)
void WearAccumulator::distribute_between(const Place& from, const Place& to, const Amounts& amounts) noexcept {
  const double length = 0.5 * (from.length + to.length);
  length_sum_ += length * (amounts.bearing + amounts.journal);
  const double bearing_depth = amounts.bearing / length;
  const double journal_depth = amounts.journal / length;
  const double bearing_move = to.bearing_at - from.bearing_at;
  const auto bearing = static_cast<std::size_t>(to.sample->bearing_surface);
  const auto journal = static_cast<std::size_t>(to.sample->journal_surface);
  distribute({{&bearing_[bearing], bearing_depth}, {&total_[bearing], bearing_depth + journal_depth}}, from.bearing_at,
             from.length / bearing_radius_, find_turn(bearing_move, slot_length_ == 0.0), to.length / bearing_radius_);
  distribute({{&journal_[journal], journal_depth}}, from.journal_at, from.length / journal_radius_,
             find_turn(to.journal_at - from.journal_at, true), to.length / journal_radius_);
}

// On all that are given, at the same place: the mean depth [m] over the arc.
void WearAccumulator::distribute(std::initializer_list<ArcAccumulator::Increment> increments, double angle,
                                 double width, double turn, double end_width) const noexcept {
  const bool parabolic = contacts_.front().pressure == PressureDistribution::parabolic;
  if (distribution_ == WearDistribution::spread && !parabolic) {
    const ArcAccumulator& any = *increments.begin()->surface;
    ArcAccumulator::add_sweep(any.find_sweep(angle, width, turn, end_width, kSoftEdge), increments);
    return;
  }
  for (const auto& [surface, mean_depth] : increments) {
    if (distribution_ == WearDistribution::point) {
      surface->add_point(angle, parabolic ? kParabolaPeak * mean_depth : mean_depth);
    } else {
      surface->add_parabola(angle, 0.5 * (width + end_width), mean_depth, turn);
    }
  }
}

// Where the middle of a contact on a side is, so that none of it lies past the ends of the slot.
double WearAccumulator::find_side_angle(double position, double width) const noexcept {
  const double at = (position + 0.5 * slot_length_) / bearing_radius_;
  const double margin = std::min(0.5 * (1.0 + kSoftEdge) * width, std::numbers::pi);
  return std::clamp(at, margin, 2.0 * std::numbers::pi - margin);
}

// What the surfaces tell apart [m].
double WearAccumulator::find_finest_length() const noexcept {
  const double worn = volume_ / contacts_.front().width;
  const bool parabolic = contacts_.front().pressure == PressureDistribution::parabolic;
  return distribution_ == WearDistribution::spread && !parabolic && worn > 0.0 ? kFinest * length_sum_ / worn : 0.0;
}

JointWear WearAccumulator::summarize(const std::string& joint) const {
  JointWear wear;
  wear.joint = joint;
  wear.bearing_radius = slot_length_ > 0.0 ? std::numeric_limits<double>::infinity() : bearing_radius_;
  wear.journal_radius = journal_radius_;
  wear.slot_length = slot_length_;
  wear.width = contacts_.front().width;
  const double finest = find_finest_length() / (2.0 * std::numbers::pi);
  const bool is_round = slot_length_ == 0.0;
  wear.bearing_depth_added = find_accelerated(bearing_, wear_acceleration_, finest / bearing_radius_, is_round);
  wear.journal_depth_added = find_accelerated(journal_, wear_acceleration_, finest / journal_radius_, true);
  wear.total_depth_added = find_accelerated(total_, wear_acceleration_, finest / bearing_radius_, is_round);
  wear.bearing_depth.assign(wear.bearing_depth_added.size(), 0.0);
  wear.journal_depth.assign(wear.journal_depth_added.size(), 0.0);
  for (const Contact& contact : contacts_) {
    std::visit(
        [&](const auto& surfaces) {
          copy_depths(surfaces.bearing_wear, contact.bearing_surface, bearing_.size(), wear.bearing_depth);
          copy_depths(surfaces.journal_wear, contact.journal_surface, journal_.size(), wear.journal_depth);
        },
        contact.surfaces);
  }
  wear.archard_volume = volume_ * wear_acceleration_;
  wear.removed_volume = find_volume(wear.bearing_depth_added, bearing_.size(), bearing_radius_, wear.width) +
                        find_volume(wear.journal_depth_added, journal_.size(), journal_radius_, wear.width);
  wear.sliding_distance = sliding_distance_;
  wear.contact_time = contact_time_;
  wear.impulse = impulse_;
  return wear;
}

}  // namespace gudgeon
