// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// From bodies, joints and studies to scenes and sentences.
#include "gudgeon/app/report_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "gudgeon/io/model_remarks.h"
#include "gudgeon/report/number_format.h"
#include "gudgeon/system/contact_force.h"

namespace gudgeon {
namespace {

/// From the centre of mass, which is what is recorded; the frame stays where it is.
Vec2 find_scene_place(const Mechanism& mechanism, int body, Vec2 local) {
  return body == 0 ? local : local - mechanism.bodies[body].center_of_mass;
}

SceneBody make_scene_body(const Mechanism& mechanism, int index) {
  const Body& body = mechanism.bodies[index];
  SceneBody scene{body.name, index == 0, {}};
  for (const Point& point : body.points) {
    scene.points.push_back({point.name, find_scene_place(mechanism, index, point.position)});
  }
  return scene;
}

void add_shape(const AnyJoint& kind, SceneJoint& scene) {
  std::visit(
      [&]<class Kind>(const Kind& joint) {
        if constexpr (requires { joint.direction; }) scene.direction = joint.direction;
        if constexpr (ClearanceJoint<Kind>) scene.clearance = joint.play();
        if constexpr (requires { joint.bearing_length; }) scene.slot_length = joint.bearing_length;
        if constexpr (requires { joint.journal_length; }) scene.block_length = joint.journal_length;
        if constexpr (requires { joint.journal_height; }) scene.block_height = joint.journal_height;
      },
      kind);
}

SceneJoint make_scene_joint(const Mechanism& mechanism, const Joint& joint) {
  const auto [first, second] = anchors(joint.kind);
  SceneJoint scene;
  scene.name = joint.name;
  scene.kind = joint_type(joint.kind);
  scene.first = find_body(mechanism, first.body);
  scene.second = find_body(mechanism, second.body);
  const auto place = [&](int body, const Anchor& anchor) {
    return find_scene_place(mechanism, body, find_point(mechanism.bodies[body], anchor.point)->position);
  };
  scene.first_place = place(scene.first, first);
  scene.second_place = place(scene.second, second);
  add_shape(joint.kind, scene);
  return scene;
}

std::string describe_joint(const Joint& joint) {
  if (const auto* round = std::get_if<RevoluteClearance>(&joint.kind)) {
    return fmt::format("{} radial, bearing radius {}, width {}", format_engineering(round->radial_clearance, "m"),
                       format_engineering(round->bearing_radius, "m"), format_engineering(round->width, "m"));
  }
  if (const auto* block = std::get_if<PrismaticClearance>(&joint.kind)) {
    return fmt::format("{} on either side, block {} long and {} high, corners {}, slot {} long, width {}",
                       format_engineering(block->clearance, "m"), format_engineering(block->journal_length, "m"),
                       format_engineering(block->journal_height, "m"), format_engineering(block->corner_radius, "m"),
                       format_engineering(block->bearing_length, "m"), format_engineering(block->width, "m"));
  }
  if (const auto* pin = std::get_if<PinInSlotClearance>(&joint.kind)) {
    return fmt::format("{} on either side, pin radius {}, slot {} long, width {}",
                       format_engineering(pin->clearance, "m"), format_engineering(pin->journal_radius, "m"),
                       format_engineering(pin->bearing_length, "m"), format_engineering(pin->width, "m"));
  }
  return std::string(joint_type(joint.kind));
}

/// One entry for all joints that are alike: names of joints, and what they are.
class JointFacts {
 public:
  explicit JointFacts(std::string heading) : heading_(std::move(heading)) {}

  void add(const Joint& joint, const std::string& text) {
    const auto alike = std::ranges::find(facts_, text, &NamedText::second);
    if (alike == facts_.end()) {
      facts_.emplace_back(heading_ + joint.name, text);
    } else {
      alike->first += ", " + joint.name;
    }
  }
  void move_to(std::vector<NamedText>& facts) { std::ranges::move(facts_, std::back_inserter(facts)); }

 private:
  std::string heading_;
  std::vector<NamedText> facts_;
};

void add_joints(const Mechanism& mechanism, const Study& study, std::vector<NamedText>& facts) {
  JointFacts clearances("Clearance in ");
  JointFacts frictions("Friction in ");
  for (const Joint& joint : mechanism.joints) {
    if (has_clearance(joint.kind)) clearances.add(joint, describe_joint(joint));
    const JointFriction* friction = find_friction(joint.kind);
    if (friction != nullptr) frictions.add(joint, std::string(law_name(friction->law)));
  }
  clearances.move_to(facts);
  frictions.move_to(facts);
  if (study.compare_ideal && study.ideal_friction) {
    facts.emplace_back("Ideal joints", "with the friction of the contacts that they replace");
  }
}

// What takes the steps, with what takes over from it where contacts make them short.
std::string describe_integrator(const Mechanism& mechanism, Integrator integrator) {
  if (integrator == Integrator::stiff) return "backward differentiation (stiff)";
  const std::string pair = "Tsitouras 5(4)";
  if (integrator == Integrator::explicit_pair) return pair;
  const auto bends = [](const Joint& joint) {
    const ContactProperties* contact = find_contact(joint.kind);
    return contact != nullptr && has_bristle(contact->friction);
  };
  if (std::ranges::any_of(mechanism.joints, bends)) return pair + ", stiff where bristles are";
  const auto touches = [](const Joint& joint) { return has_clearance(joint.kind); };
  return std::ranges::any_of(mechanism.joints, touches) ? pair + ", implicit where contacts stick" : pair;
}

}  // namespace

Scene make_scene(const Mechanism& mechanism) {
  Scene scene;
  scene.gravity = mechanism.gravity;
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
    scene.bodies.push_back(make_scene_body(mechanism, static_cast<int>(b)));
  }
  for (const Joint& joint : mechanism.joints) scene.joints.push_back(make_scene_joint(mechanism, joint));
  return scene;
}

std::vector<NamedText> describe_study(const Mechanism& mechanism, const Study& study) {
  std::vector<NamedText> facts;
  const auto n_clear = std::ranges::count_if(mechanism.joints, [](const Joint& j) { return has_clearance(j.kind); });
  facts.emplace_back(
      "Mechanism", fmt::format("moving bodies: {}; joints: {}, with clearance: {}; drivers: {}; loads: {}",
                               mechanism.bodies.size() - 1, mechanism.joints.size(), n_clear, mechanism.drivers.size(),
                               mechanism.loads.size()));
  facts.emplace_back("Gravity", fmt::format("({}, {}) m/s²", mechanism.gravity.x, mechanism.gravity.y));
  for (const Driver& driver : mechanism.drivers) {
    const bool turns = std::holds_alternative<DrivenAngle>(driver.target);
    facts.emplace_back("Driver " + driver.name, driver.is_uniform()
                                                    ? format_engineering(driver.speed, turns ? "rad/s" : "m/s")
                                                    : std::string("a motion over time"));
  }
  add_joints(mechanism, study, facts);
  facts.emplace_back("Cycle", format_engineering(study.cycle_time, "s"));
  facts.emplace_back("Cycles a stage", fmt::format("{} after {} to warm up", study.cycles, study.warm_up_cycles));
  facts.emplace_back("Wear stages", fmt::format("{}", study.wear_stages));
  if (study.wear_stages > 0) {
    facts.emplace_back("Wear acceleration factor", fmt::format("{:g}", study.wear_acceleration));
    facts.emplace_back("Wear goes",
                       study.wear_distribution == WearDistribution::spread ? "over the contact arc" : "into one cell");
    facts.emplace_back("Cells of a circumference", fmt::format("{}", study.cells));
  }
  facts.emplace_back("Integrator", describe_integrator(mechanism, study.integrator));
  facts.emplace_back("Loops held by", study.stabilization == Stabilization::projection ? "projection" : "Baumgarte");
  facts.emplace_back("Local error",
                     fmt::format("{:g} relative, {:g} absolute", study.relative_tolerance, study.absolute_tolerance));
  facts.emplace_back("Samples a cycle", fmt::format("{}", study.outputs_per_cycle));
  return facts;
}

void read_stated_values(std::string_view model_text, ReportCase& one) {
  for (const RemarkLetter& letter : find_remark_letters(model_text)) {
    one.statuses.push_back({letter.letter, letter.meaning});
  }
  for (const ModelRemark& item : find_remarks(model_text)) {
    const std::size_t end = std::min(item.remark.find_first_of(" :,;("), item.remark.size());
    const std::string word = item.remark.substr(0, end);
    const bool has_status =
        std::ranges::find(one.statuses, word.substr(0, 1), &StatusMeaning::status) != one.statuses.end() &&
        std::ranges::all_of(word.substr(1), [](unsigned char c) { return std::isdigit(c) != 0; });
    const std::size_t rest = has_status ? item.remark.find_first_not_of(" :,;", end) : 0;
    one.stated.push_back(
        {item.path, item.written, has_status ? word : "", rest == std::string::npos ? "" : item.remark.substr(rest)});
  }
}

}  // namespace gudgeon
