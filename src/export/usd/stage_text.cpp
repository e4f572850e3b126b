#include "export/usd/stage_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "core/angle.h"
#include "export/usd/element_text.h"

namespace shatterpave::exporting::usd {

namespace {

// Lens and film are in tenths of a unit, whatever the unit is (UsdGeomCamera): here of 100 mm.
constexpr double mm_per_tenth = 100.0;
// What is nearer is not drawn, nor what is farther, by viewers that rasterise; the depth in between is all that 24 bits can
// part: at 3 m to 0.05 mm, far less than a pane is thick.
constexpr std::string_view clipping_m = "(0.01, 10000)";

// Short, and exact to what a `float` holds.
double as_float(double value) { return static_cast<double>(in_parts(value, parts_of_m)) / parts_of_m; }

double focal_length(const studio::Camera& camera) { return as_float(studio::focal_length_mm(camera) / mm_per_tenth); }

double focus_distance(const studio::Camera& camera) {
  return as_float(camera.focus_mm.value_or(glm::length(camera.look_at_mm - camera.at_mm)) / 1000.0);
}

double f_stop(const studio::Camera& camera) { return camera.f_number.value_or(0.0); }  // 0: all is sharp

// What a number of the camera is, and at each frame where that changes.
void put_number(PrimText& text, std::string_view name, double (*of)(const studio::Camera&), const shapes::Stage& stage,
                int first_frame) {
  text.line("float {} = {}", name, of(stage.camera));
  std::vector<std::string> samples;
  samples.reserve(stage.camera_path.size());
  for (const studio::Camera& camera : stage.camera_path) {
    samples.push_back(fmt::format("{}: {}", first_frame + static_cast<int>(samples.size()), of(camera)));
  }
  const auto differs = [&](const studio::Camera& camera) { return of(camera) != of(stage.camera); };
  if (std::ranges::any_of(stage.camera_path, differs)) {
    text.line("float {}.timeSamples = {{ {} }}", name, fmt::join(samples, ", "));
  }
}

void put_camera(PrimText& text, const shapes::Stage& stage, int first_frame) {
  const double film = studio::film_width_mm / mm_per_tenth;
  text.begin("def Camera", "camera");
  text.line("float2 clippingRange = {}", clipping_m);
  put_number(text, "focalLength", focal_length, stage, first_frame);
  put_number(text, "focusDistance", focus_distance, stage, first_frame);
  put_number(text, "fStop", f_stop, stage, first_frame);
  text.line("float horizontalAperture = {}", film);
  text.line("token projection = \"perspective\"");
  text.line("float verticalAperture = {}", as_float(film / studio::aspect_of(stage.camera)));
  if (!stage.camera_path.empty()) put_path(text, shapes::camera_placings(stage), first_frame, true);
  put_placing(text, shapes::placing_of(stage.camera));
  text.end();
}

// Exposure is in the lights, since few renderers obey that of a camera.
void put_exposure(PrimText& text, const studio::Light& light) { text.line("float inputs:exposure = {}", light.exposure_ev); }

// The middle of a dome's picture is at its +z, and what is right in it at −x; in the world that is +y, which is −z here, and
// +x.
void put_environment(PrimText& text, const shapes::Stage& stage) {
  shapes::Placing placing;
  const vec2 d = (Angle::degrees(180.0) + stage.light.environment_turn).direction();
  placing.turn = {vec3{d.x, 0.0, d.y}, vec3{0.0, 1.0, 0.0}, vec3{-d.y, 0.0, d.x}};
  text.begin("def DomeLight", "environment");
  put_exposure(text, stage.light);
  text.line("float inputs:intensity = {}", stage.light.environment_gain);
  text.line("asset inputs:texture:file = {}", asset(stage.environment_name));
  text.line("token inputs:texture:format = \"latlong\"");
  put_placing(text, placing);
  text.end();
}

// Normalised, the intensity is what the light throws on what looks at it, however large its disc.
void put_sun(PrimText& text, const shapes::Stage& stage) {
  text.begin("def DistantLight", "sun");
  text.line("float inputs:angle = {}", studio::sun_diameter_deg);
  put_exposure(text, stage.light);
  text.line("float inputs:intensity = {}", as_float(studio::noon_irradiance * stage.light.sun->gain));
  text.line("bool inputs:normalize = true");
  put_placing(text, shapes::placing_of(*stage.light.sun));
  text.end();
}

}  // namespace

void put_stage(PrimText& text, const shapes::Stage& stage, int first_frame) {
  put_camera(text, stage, first_frame);
  text.begin("def Scope", "lights");
  put_environment(text, stage);
  if (stage.light.sun) put_sun(text, stage);
  text.end();
}

void put_render_settings(PrimText& text, const shapes::Stage& stage, const std::string& camera_path) {
  if (!stage.camera.size_px) return;
  text.begin("def Scope", "Render");
  text.begin("def RenderSettings", "settings");
  text.line("rel camera = <{}>", camera_path);
  text.line("uniform int2 resolution = ({}, {})", (*stage.camera.size_px)[0], (*stage.camera.size_px)[1]);
  text.end();
  text.end();
}

}  // namespace shatterpave::exporting::usd
