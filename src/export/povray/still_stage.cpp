#include "export/povray/still_stage.h"

#include <fmt/format.h>

#include <cmath>

#include "export/povray/environment_lights.h"
#include "export/povray/sdl.h"
#include "export/shapes/stage.h"
#include "export/swatches/environment.h"
#include "relief/out_of_focus.h"
#include "relief/raster.h"
#include "studio/camera.h"
#include "studio/light.h"

namespace shatterpave::exporting::povray {

namespace {

// Two to the power of these: 64 lights, as the source of the method has them, and a quarter of that. By eye, on the gallery's
// pavements: below 16 shadows come in steps.
constexpr int cuts = 6;
constexpr int draft_cuts = 4;
// From where far light shines: farther than the largest scene.
constexpr double far_mm = 1e7;

constexpr std::string_view camera_pattern = R"(
// The scene's own camera.
#macro Still_Camera(Shift, Turn)
   camera {{
      perspective
      location vrotate({location}, Turn) + Shift
      direction vrotate({forward}, Turn)
      right vrotate({right}, Turn) * {width}
      up vrotate({up}, Turn) * {width} * image_height / image_width
{lens}   }}
#end
)";

// POV-Ray's aperture is four times the radius of the lens (measured: a plane out of focus by so much is blurred over half of
// what the aperture would make as a diameter).
std::string lens_text(const studio::Camera& camera, const studio::View& view) {
  const double radius = studio::lens_radius_mm(camera);
  if (radius <= 0.0) return {};
  const vec3 focus = camera.at_mm + *camera.focus_mm * view.forward;
  return fmt::format(
      "      focal_point vrotate({}, Turn) + Shift\n      aperture {}\n"
      "      blur_samples select(Quality - 1, 19, 61) confidence 0.95 variance select(Quality - 1, 1 / 128, 1 / 1024)\n",
      lying_point(focus), number(4.0 * radius));
}

std::string camera_text(const studio::Camera& camera) {
  const studio::View view = studio::view_of(camera);
  return fmt::format(fmt::runtime(camera_pattern), fmt::arg("location", lying_point(camera.at_mm)),
                     fmt::arg("forward", lying_point(view.forward)), fmt::arg("right", lying_point(view.right)),
                     fmt::arg("up", lying_point(view.up)),
                     fmt::arg("width", number(studio::film_width_mm / studio::focal_length_mm(camera))),
                     fmt::arg("lens", lens_text(camera, view)));
}

std::string colour_text(vec3 colour) { return fmt::format("rgb <{:.6g}, {:.6g}, {:.6g}>", colour.x, colour.y, colour.z); }

// To six digits, as POV-Ray has it: what is finer than that no picture shows.
std::string direction_text(vec3 towards) {
  const auto part = [](double value) { return std::abs(value) < 1e-7 ? 0.0 : value; };
  return fmt::format("<{:.6g}, {:.6g}, {:.6g}>", part(towards.x), part(towards.z), part(towards.y));
}

// POV-Ray's light of colour 1 makes a white surface that looks at it as bright as radiance 1 does.
std::string lights_text(const relief::Raster& panorama, int cut_count, double factor) {
  std::string text;
  for (const FarLight& light : far_lights(panorama, cut_count)) {
    text += fmt::format("      Still_Far_Light({}, {}, Turn)\n", direction_text(light.towards),
                        colour_text(factor / pi * light.irradiance));
  }
  return text;
}

// An area light, parallel, of the sun's disc, which `orient` turns to what it shines on.
std::string sun_text(const studio::Sun& sun, double factor) {
  const vec2 half = Angle::degrees(0.5 * studio::sun_diameter_deg).direction();
  const double side = 2.0 * far_mm * half.y / half.x;
  return fmt::format(
      "   light_source {{\n      {} * {}, {}\n      area_light x * {:.6g}, z * {:.6g}, select(Quality - 1, 3, 5), "
      "select(Quality - 1, 3, 5) adaptive 1 circular orient\n      parallel point_at 0\n      rotate Turn\n   }}\n",
      direction_text(studio::direction_to(sun)), number(far_mm),
      colour_text(vec3(factor * studio::noon_irradiance * sun.gain / pi)), side, side);
}

constexpr std::string_view light_pattern = R"(
// The scene's own light: what is all around, far lights that stand for it, and a sun.
#macro Still_Far_Light(Towards, Colour, Turn)
   light_source {{
      Towards * {far}, Colour
      parallel point_at 0
      rotate {turn} * -y
      rotate Turn
   }}
#end
#macro Still_Light(Turn)
   sky_sphere {{
      pigment {{
         image_map {{ exr "{picture}" gamma 1.0 map_type 1 interpolate 2 }}
         scale <1, 1, -1>
         rotate -(270 + {turn}) * y
      }}
      rotate Turn
      emission rgb {factor:.6g}
   }}
   #if (Quality > 0)
{lights}   #else
{draft_lights}   #end
{sun}#end
)";

// The name of a file that POV-Ray can be told by.
std::string picture_name(const std::string& scene, Angle blur) {
  std::string name = blur > Angle() ? fmt::format("{}_sky_blur{:.9g}.exr", scene, blur.degrees()) : scene + "_sky.exr";
  for (char& c : name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '-';
    if (!plain) c = '_';
  }
  return name;
}

}  // namespace

StillStage still_stage(const Model& model, bool always) {
  StillStage still;
  still.has_camera = always || model.camera.has_value();
  still.has_light = always || model.light.has_value();
  if (!still.has_camera && !still.has_light) return still;
  const shapes::Stage stage = shapes::stage_of(model);
  still.declarations = "#ifndef(Quality) #declare Quality = 1; #end\n";
  if (still.has_camera) still.declarations += camera_text(stage.camera);
  if (!still.has_light) return still;

  const studio::Light& light = stage.light;
  const double exposure = studio::exposure_factor(light);
  const double factor = light.environment_gain * exposure;
  still.sky = {picture_name(shared_stem_of(model), light.environment_blur), swatches::sharp_environment(stage),
               light.environment_blur};
  const relief::Raster& panorama = still.sky->sharp;
  still.declarations += fmt::format(
      fmt::runtime(light_pattern), fmt::arg("picture", still.sky->name),
      fmt::arg("turn", number(light.environment_turn.degrees())), fmt::arg("factor", factor), fmt::arg("far", number(far_mm)),
      fmt::arg("lights", factor > 0.0 ? lights_text(panorama, cuts, factor) : std::string()),
      fmt::arg("draft_lights", factor > 0.0 ? lights_text(panorama, draft_cuts, factor) : std::string()),
      fmt::arg("sun", light.sun && light.sun->gain > 0.0 ? sun_text(*light.sun, exposure) : std::string()));
  return still;
}

OutputFile sky_file(const SkyPicture& sky) {
  return {sky.name, relief::encoded(relief::out_of_focus(sky.sharp, sky.blur), relief::RasterFormat::exr_half)};
}

}  // namespace shatterpave::exporting::povray
