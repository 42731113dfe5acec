// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon draw.
#include "gudgeon/app/draw_command.h"

#include <fmt/format.h>

#include <memory>
#include <variant>

#include "gudgeon/app/command_line.h"
#include "gudgeon/app/mechanism_picture.h"
#include "gudgeon/app/model_options.h"
#include "gudgeon/app/text_output.h"
#include "gudgeon/base/quantity.h"
#include "gudgeon/io/safe_file.h"
#include "gudgeon/report/mechanism_drawing.h"
#include "gudgeon/system/assembly.h"

namespace gudgeon {
namespace {

struct DrawOptions {
  ModelOptions model;
  std::string case_name;
  std::filesystem::path output;
  std::string time = "0 s";
  std::vector<std::string> traces;  ///< "body.point"
  bool overwrite = false;
};

double read_time(const std::string& text) {
  const auto parsed = parse_quantity(text);
  if (const auto* error = std::get_if<QuantityError>(&parsed)) {
    throw UsageError(fmt::format("--time '{}': {}", text, error->message));
  }
  const Quantity& time = std::get<Quantity>(parsed);
  if (time.dimension != dimension::kTime && time.dimension != dimension::kNone) {
    throw UsageError(
        fmt::format("--time '{}' is {}; it must be a time, such as \"0.25 s\"", text, dimension_name(time.dimension)));
  }
  return time.value;
}

/// "panel_7.D" as a body and one of its points.
Anchor read_anchor(const Mechanism& mechanism, const std::string& text) {
  const std::size_t dot = text.rfind('.');
  const Anchor anchor{text.substr(0, dot), dot == std::string::npos ? "" : text.substr(dot + 1)};
  const int body = find_body(mechanism, anchor.body);
  if (body >= 0 && find_point(mechanism.bodies[body], anchor.point) != nullptr) return anchor;
  std::vector<std::string> known;
  for (const Body& one : mechanism.bodies) {
    for (const Point& point : one.points) known.push_back(one.name + "." + point.name);
  }
  throw UsageError(
      fmt::format("--trace takes a point of a body, BODY.POINT; there is no '{}'. {}", text, suggest(text, known)));
}

/// The first line of the description, the case and the time, as much as fits beside the gravity arrow.
std::string make_subtitle(const ModelFile& model, double time) {
  constexpr std::size_t kLongest = 76;
  std::string about = model.mechanism.description.substr(0, model.mechanism.description.find('\n'));
  if (about.size() > kLongest) about = about.substr(0, about.rfind(' ', kLongest)) + " …";
  if (!about.empty()) about += "  ·  ";
  if (!model.case_name.empty()) about += fmt::format("case {}, ", model.case_name);
  return about + fmt::format("t = {:g} s", time);
}

std::string render_picture(const ModelFile& model, const DrawOptions& options) {
  const double time = read_time(options.time);
  MechanismDrawing drawing = make_drawing(model.mechanism, assemble(model.mechanism, time));
  drawing.title = model.mechanism.name;
  drawing.subtitle = make_subtitle(model, time);
  for (const std::string& trace : options.traces) {
    const Anchor anchor = read_anchor(model.mechanism, trace);
    if (model.study.cycle_time <= 0.0)
      throw UsageError("--trace follows a point over one cycle, and the study has none");
    drawing.traces.push_back(make_trace(model.mechanism, anchor, model.study.cycle_time));
  }
  return render_svg(drawing);
}

ExitCode run_draw(const DrawOptions& options) {
  const bool to_stdout = options.output == "-";
  if (!to_stdout) check_target(options.output, options.overwrite);
  const ModelFile model = read_case(options.model, options.case_name);
  require_sound(model);
  const std::string svg = with_source(model, [&] { return render_picture(model, options); });
  if (to_stdout) {
    write_stdout(svg);
  } else {
    write_whole(options.output, svg);
    write_receipt(fmt::format("{}\n", options.output.string()));
  }
  return ExitCode::done;
}

}  // namespace

void add_draw_command(CLI::App& program, Action& action) {
  const auto options = std::make_shared<DrawOptions>();
  CLI::App* command = program.add_subcommand("draw", "Draw the mechanism as SVG, its clearance joints marked");
  add_model_options(*command, options->model);
  add_case_option(*command, options->case_name);
  command->add_option("-o,--output", options->output, "SVG file to write; - is standard output")->required();
  command->add_option("--time", options->time, "Position at this time, such as \"0.25 s\"")->capture_default_str();
  command->add_option("--trace", options->traces, "Path of a point over one cycle, BODY.POINT (may be repeated)")
      ->type_name("BODY.POINT")
      ->allow_extra_args(false);
  command->add_flag("--overwrite", options->overwrite, "Replace an existing file");
  command->footer("\nExample:\n  gudgeon draw press.toml -o press.svg --time \"0.25 s\" --trace panel_7.D\n");
  command->callback([options, &action] { action = [options] { return run_draw(*options); }; });
}

}  // namespace gudgeon
