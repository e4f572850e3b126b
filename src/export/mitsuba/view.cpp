#include "export/mitsuba/view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "studio/world.h"

namespace shatterpave::exporting::mitsuba {

namespace {

using studio::upright_of_world;

constexpr int samples = 64;  // by eye: noise of glass is gone at some 500
constexpr int default_width_px = 960;

// The sun's distance, at least and in extents of the scene: over the scene its direction then differs by less than its own
// radius, 0.27°.
constexpr double least_distance_m = 1000.0;
constexpr double extents_away = 500.0;
// What is farther away the camera does not see.
constexpr double far_clip_m = 1.0e6;
constexpr double near_clip_m = 0.001;

vec3 metres(vec3 mm) { return upright_of_world(mm) / 1000.0; }

void write_look(Xml& xml, vec3 origin, vec3 target, vec3 up) {
  xml.open("transform", {{"name", "to_world"}});
  xml.leaf("lookat", {{"origin", numbers(origin)}, {"target", numbers(target)}, {"up", numbers(up)}});
  xml.close();
}

// A disc of 0.53 degrees, since a direction alone would never be met by light that glass or water bends: their shadows would be
// black, and no sun would glint in them.
void write_sun(Xml& xml, const studio::Sun& sun, double factor, double extent_mm) {
  const double distance_m = std::max(least_distance_m, extents_away * extent_mm / 1000.0);
  const vec2 edge = Angle::degrees(0.5 * studio::sun_diameter_deg).direction();
  const double radius_m = distance_m * edge.y / edge.x;
  const double radiance = factor * sun.gain * studio::noon_irradiance / (pi * edge.y * edge.y);
  const vec3 at = distance_m * upright_of_world(studio::direction_to(sun));
  // Any vector that is not along it.
  const vec3 up = std::abs(at.y) < 0.9 * distance_m ? vec3{0.0, 1.0, 0.0} : vec3{1.0, 0.0, 0.0};
  xml.open("shape", {{"type", "disk"}, {"id", "sun"}});
  xml.open("transform", {{"name", "to_world"}});
  xml.leaf("scale", {{"value", number(radius_m)}});
  xml.leaf("lookat", {{"origin", numbers(at)}, {"target", "0, 0, 0"}, {"up", numbers(up)}});
  xml.close();
  xml.open("emitter", {{"type", "area"}});
  xml.value("rgb", "radiance", numbers(vec3{radiance, radiance, radiance}));
  xml.close();
  xml.close();
}

}  // namespace

void write_defaults(Xml& xml, const shapes::Stage& stage) {
  const int width = stage.camera.size_px ? (*stage.camera.size_px)[0] : default_width_px;
  const int height = stage.camera.size_px ? (*stage.camera.size_px)[1] : default_width_px * 3 / 4;
  for (const auto& [name, value] : {std::pair{"spp", samples}, std::pair{"width", width}, std::pair{"height", height}}) {
    xml.leaf("default", {{"name", name}, {"value", fmt::format("{}", value)}});
  }
}

void write_camera(Xml& xml, const shapes::Stage& stage) {
  const studio::Camera& camera = stage.camera;
  const double lens_mm = studio::lens_radius_mm(camera);
  const studio::View view = studio::view_of(camera);
  xml.open("sensor", {{"type", lens_mm > 0.0 ? "thinlens" : "perspective"}, {"id", "camera"}});
  xml.value("float", "fov", number(camera.field_of_view.degrees()));
  xml.value("string", "fov_axis", "x");
  xml.value("float", "near_clip", number(near_clip_m));
  xml.value("float", "far_clip", number(far_clip_m));
  if (lens_mm > 0.0) {
    xml.value("float", "aperture_radius", number(lens_mm / 1000.0));
    xml.value("float", "focus_distance", number(*camera.focus_mm / 1000.0));
  }
  write_look(xml, metres(camera.at_mm), metres(camera.look_at_mm), upright_of_world(view.up));
  xml.open("film", {{"type", "hdrfilm"}});
  xml.value("integer", "width", "$width");
  xml.value("integer", "height", "$height");
  xml.value("string", "pixel_format", "rgb");
  xml.close();
  xml.open("sampler", {{"type", "independent"}});
  xml.value("integer", "sample_count", "$spp");
  xml.close();
  xml.close();
}

void write_lights(Xml& xml, const shapes::Stage& stage, double extent_mm) {
  const double factor = studio::exposure_factor(stage.light);
  xml.open("emitter", {{"type", "envmap"}, {"id", "environment"}});
  xml.value("string", "filename", stage.environment_name);
  xml.value("float", "scale", number(factor * stage.light.environment_gain));
  xml.open("transform", {{"name", "to_world"}});
  // Mitsuba has the middle of the picture at +z, which is away from where ours lies.
  xml.leaf("rotate", {{"y", "1"}, {"angle", number(180.0 + stage.light.environment_turn.degrees())}});
  xml.close();
  xml.close();
  if (stage.light.sun && stage.light.sun->gain > 0.0) write_sun(xml, *stage.light.sun, factor, extent_mm);
}

}  // namespace shatterpave::exporting::mitsuba
