// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Mechanism and study as a model file; contacts and materials come out of the joints that hold them.
#include "gudgeon/io/resolved_model.h"

#include "gudgeon/io/field_writer.h"

namespace gudgeon {

namespace {

class ModelWriter {
 public:
  std::string write(const Mechanism& mechanism, const Study& study) {
    writer_.write(mechanism);
    for (const Body& body : mechanism.bodies) write(body);
    for (const Joint& joint : mechanism.joints) write(joint);
    shared_.write(out_);
    for (const Driver& driver : mechanism.drivers) write(driver);
    for (const Load& load : mechanism.loads) write(load);
    write(study);
    return out_.text();
  }

 private:
  void write(const Body& body) {
    out_.header("bodies", body.name);
    if (body.name != kFrameName) {
      writer_.write(Body::kMassFields, body);
      writer_.write(Body::kPlaceFields, body);
    }
    writer_.write(Body::kPointFields, body);
  }

  void write(const Joint& joint) {
    out_.header("joints", joint.name);
    out_.line("type", toml_text(joint_type(joint.kind)));
    std::visit([&](const auto& kind) { writer_.write(kind); }, joint.kind);
    writer_.write(joint);
  }

  void write(const Load& load) {
    out_.header("loads", load.name);
    out_.line("type", toml_text(load_type(load.kind)));
    std::visit([&](const auto& kind) { writer_.write(kind); }, load.kind);
  }

  void write(const Driver& driver) {
    out_.header("drivers", driver.name);
    std::visit(
        [&]<class Driven>(const Driven& target) {
          writer_.write(target);
          write_motion(driver, Driven::kPlace, Driven::kRate);
        },
        driver.target);
  }

  void write_motion(const Driver& driver, Dimension place, Dimension rate) {
    std::visit(
        [&]<class Motion>(const Motion& motion) {
          if constexpr (std::same_as<Motion, std::monostate>) {
            writer_.write(Driver::uniform_fields(place, rate), driver);
          } else {
            writer_.write_function(Driver::kMotionKey, {.dimension = place}, motion, kMotionInterpolation);
            writer_.write_constants();
          }
        },
        driver.motion);
  }

  void write(const Study& study) {
    out_.raw("\n[study]\n");
    if (!study.cycle_driver.empty()) {
      out_.line("cycle_driver",
                fmt::format("{}  # a turn takes {} s", toml_text(study.cycle_driver), study.cycle_time));
    } else {
      out_.line("cycle_time", toml_quantity(study.cycle_time, dimension::kTime));
    }
    writer_.write(study);
  }

  TomlLines out_;
  SharedTableNames shared_;
  FieldWriter writer_{out_, shared_};
};

}  // namespace

std::string write_resolved_model(const Mechanism& mechanism, const Study& study) {
  return ModelWriter().write(mechanism, study);
}

}  // namespace gudgeon
