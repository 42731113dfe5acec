// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Each with numbers of the size of the bodies' weights.
#include "tests/random/random_loads.h"

#include <fmt/format.h>

#include "tests/random/random_curves.h"

namespace gudgeon::random {

namespace {

class LoadDraw {
 public:
  LoadDraw(Mechanism& mechanism, Draw& draw) : mechanism_(mechanism), draw_(draw) {}

  void add(int kind) {
    const std::string name = fmt::format("L{}", mechanism_.loads.size());
    const auto put = [&](AnyLoad load) { mechanism_.loads.push_back({name, std::move(load)}); };
    switch (kind) {
      case 0:
        return put(ConstantForce{draw_point(draw_moving()), draw_.vector(1.0, 20.0)});
      case 1:
        return put(ConstantTorque{draw_moving().name, draw_.between(-2.0, 2.0)});
      case 2:
        return add_spring(name);
      case 3:
        return put(TorsionSpring{kFrameName, draw_moving().name, draw_.scaled(0.1, 10.0), draw_.between(0.0, 0.05),
                                 draw_.angle()});
      case 4:
        return add_bushing(name);
      case 5:
        return put(VariableForce{draw_point(draw_moving()), of_time(), of_speed(), kFrameName});
      case 6:
        return put(VariableTorque{draw_moving().name, kFrameName, of_angle()});
      case 7:
        return put(VariableForce{draw_point(draw_moving()), draw_curve(draw_, "t", -0.01, 0.12, 20.0), of_time(),
                                 draw_moving().name});
      case 8: {
        const std::string body = draw_moving().name;
        return put(VariableTorque{body, draw_other(body), draw_curve(draw_, body + ".angle_rate", -20.0, 40.0, 2.0)});
      }
      default:
        return put(VariableForce{draw_point(draw_moving()), of_time(), 0.0, draw_moving().name});
    }
  }

  Body& draw_moving() {
    const int n = static_cast<int>(mechanism_.bodies.size());
    return mechanism_.bodies[static_cast<std::size_t>(1 + draw_.below(n - 1))];
  }

  Anchor draw_point(const Body& body) {
    const int k = draw_.below(static_cast<int>(body.points.size()));
    return {body.name, body.points[static_cast<std::size_t>(k)].name};
  }

 private:
  // From a point of the frame of its own, well away from any other.
  void add_spring(const std::string& name) {
    Body& frame = mechanism_.bodies.front();
    frame.points.push_back({name, draw_.vector(1.5, 2.0)});
    mechanism_.loads.push_back({name, Spring{{kFrameName, name},
                                             draw_point(draw_moving()),
                                             draw_.scaled(10.0, 1e3),
                                             draw_.between(0.0, 2.0),
                                             draw_.between(1.0, 2.0)}});
  }

  // Between two bodies at points that need not coincide.
  void add_bushing(const std::string& name) {
    const Body& first = mechanism_.bodies.front();
    const Body& second = draw_moving();
    if (first.points.empty()) return;
    mechanism_.loads.push_back({name, Bushing{draw_point(first),
                                              draw_point(second),
                                              {draw_.scaled(10.0, 200.0), draw_.scaled(10.0, 200.0)},
                                              {draw_.between(0.0, 2.0), draw_.between(0.0, 2.0)},
                                              draw_.between(0.0, 2.0),
                                              draw_.between(0.0, 0.1),
                                              draw_.angle()}});
  }

  // A torque has its opposite on another body.
  std::string draw_other(const std::string& body) {
    const Body& other = draw_moving();
    return other.name == body ? kFrameName : other.name;
  }

  Expression of_time() {
    return {"a*sin(w*t + p) + b*t",
            {{"a", draw_.between(-10.0, 10.0)},
             {"b", draw_.between(-20.0, 20.0)},
             {"p", draw_.angle()},
             {"w", draw_.between(3.0, 30.0)}}};
  }

  Expression of_speed() {
    return {fmt::format("-c*{}.y_velocity", draw_moving().name), {{"c", draw_.between(0.0, 3.0)}}};
  }

  Expression of_angle() {
    const std::string name = draw_moving().name;
    return {fmt::format("-k*sin({}.angle) - d*{}.angle_rate", name, name),
            {{"d", draw_.between(0.0, 0.05)}, {"k", draw_.between(0.0, 2.0)}}};
  }

  Mechanism& mechanism_;
  Draw& draw_;
};

}  // namespace

void add_loads(Mechanism& mechanism, Draw& draw) {
  LoadDraw loads(mechanism, draw);
  const int n = 1 + draw.below(4);
  for (int i = 0; i < n; ++i) loads.add(draw.below(10));
}

void add_jump(RandomModel& model, Draw& draw) {
  LoadDraw loads(model.mechanism, draw);
  const Anchor point = loads.draw_point(loads.draw_moving());
  const double before = draw.between(-30.0, 30.0);
  const double after = draw.between(-30.0, 30.0);
  model.jump_time = draw.between(0.2, 0.8) * model.study.cycle_time;
  model.before = model.after = model.mechanism;
  model.mechanism.loads.push_back(
      {"jump", VariableForce{point, Expression{"t < s ? a : b", {{"a", before}, {"b", after}, {"s", model.jump_time}}},
                             0.0, kFrameName}});
  model.before.loads.push_back({"jump", ConstantForce{point, {before, 0.0}}});
  model.after.loads.push_back({"jump", ConstantForce{point, {after, 0.0}}});
}

}  // namespace gudgeon::random
