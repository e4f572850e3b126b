#include "scene/schema/scene_keys.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "core/embedded.h"
#include "paving/limits.h"
#include "scene/schema/pane_keys.h"
#include "scene/schema/pavement_keys.h"
#include "scene/schema/ranges.h"

namespace shatterpave::scene {

namespace {

using SceneRow = Row<Scene, SceneFacts>;
using StillRow = Row<Still, SceneFacts>;
using CameraRow = Row<studio::Camera, SceneFacts>;
using LightRow = Row<LightAsked, SceneFacts>;
using PlanRow = Row<PlanAsked, SceneFacts>;

using rows::in;

constexpr double farthest = std::numeric_limits<double>::max();

bool without_pane(const SceneFacts& f) { return !f.has_pane(); }

bool is_svg(std::string_view name) {
  constexpr std::string_view ending = ".svg";
  if (name.size() < ending.size()) return false;
  const std::string_view end = name.substr(name.size() - ending.size());
  return std::ranges::equal(end, ending, [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
}

bool node_takes_plan(const toml::node& node, bool svg) {
  if (const toml::array* array = node.as_array()) {
    return std::ranges::any_of(*array,
                               [&](const toml::node& element) { return element.is_table() && node_takes_plan(element, svg); });
  }
  const toml::table* table = node.as_table();
  if (table == nullptr) return false;
  for (const auto& [key, value] : *table) {
    const auto* name = value.as_string();
    // The drawing of a module has a scale of its own.
    const bool of_a_plan = key.str().ends_with("_file") && key.str() != "module_file";
    if (name != nullptr && of_a_plan && is_svg(name->get()) == svg) return true;
    if (node_takes_plan(value, svg)) return true;
  }
  return false;
}

}  // namespace

bool SceneFacts::takes_plan(bool svg) const { return node_takes_plan(table.node(), svg); }

std::vector<std::string_view> settings() {
  constexpr std::string_view ending = "_still.pov";
  std::vector<std::string_view> names{own_setting};
  for (const EmbeddedFile& file : embedded_files()) {
    if (file.name.ends_with(ending)) names.push_back(file.name.substr(0, file.name.rfind('.')));
  }
  std::ranges::sort(names);
  return names;
}

const Section<Scene, SceneFacts> root_keys{
    "",
    {
        SceneRow::whole<std::uint64_t>("seed", &Scene::seed, {0, std::numeric_limits<std::int64_t>::max()},
                                       "all that is left to chance follows from it; `--seed N` wins"),
        SceneRow::table("plan", "where plans lie, and their scale").by_default("none"),
        SceneRow::tables("pane", most_panes, "a pane of glass each").by_default("none"),
        SceneRow::tables("pavement", paving::most_pavements, "a paved area each").by_default("none"),
        SceneRow::table("still", "how pictures show the things"),
        SceneRow::table("camera", "where pictures are taken from").by_default("the setting's own"),
        SceneRow::table("light", "what lights the things").by_default("the setting's own"),
        SceneRow::table("frames", "a shot: what changes over its frames").by_default("none"),
    }};

const Section<Still, SceneFacts> still_keys{
    "still",
    {
        StillRow::by_code("setting", ValueType::choice, "how `render` and the POV-Ray scene show the things")
            .one_of(settings())
            .by_default("by what there is"),
        StillRow::flag("dispersion", &Still::dispersion,
                       "glass parts colours, as soda-lime glass does: 1.2 % between red and violet. Up to four times the time")
            .idle(without_pane, "without a pane"),
        StillRow::flag("caustics", &Still::caustics,
                       "light that panes bend is thrown on what is behind them, by photons. About twice the time")
            .idle(without_pane, "without a pane"),
    }};

const Section<studio::Camera, SceneFacts> camera_keys{
    "camera",
    {
        CameraRow::place("at_mm", &studio::Camera::at_mm, coordinate_range, "where it stands"),
        CameraRow::place("look_at_mm", &studio::Camera::look_at_mm, coordinate_range, "what is in the middle of the picture"),
        CameraRow::angle("field_of_view_deg", &studio::Camera::field_of_view, {0.1, 170.0}, "across the picture"),
        CameraRow::number("focus_mm", &studio::Camera::focus_mm, {1.0, geometry::largest_coordinate_mm},
                          "how far along the view things are sharp")
            .beside("f_number", "f_number beside it"),
        CameraRow::number("f_number", &studio::Camera::f_number, {0.1, 1000.0},
                          "focal length over opening of the lens, on film 36 mm wide: the smaller, the more is blurred")
            .beside("focus_mm", "focus_mm beside it")
            .by_default("all is sharp"),
        CameraRow::pixels("size_px", &studio::Camera::size_px, {1, 16384}, "of the picture; `--size` wins")
            .by_default("the command's"),
    }};

const Section<LightAsked, SceneFacts> light_keys{
    "light",
    {
        LightRow::by_code("environment", ValueType::text,
                          "what is all around and lights the things: a name of those installed with Blender's data (`city`, "
                          "`forest` …), or a lat-long picture, EXR, HDR or PNG, whose relative name starts at the scene file's "
                          "folder")
            .written("name or file name")
            .by_default("a plain sky"),
        LightRow::angle("environment_turn_deg", in(&LightAsked::light, &studio::Light::environment_turn), {-360.0, 360.0},
                        "how far it is turned about the upright, counter-clockwise from above"),
        LightRow::angle(
            "environment_blur_deg", in(&LightAsked::light, &studio::Light::environment_blur), {0.0, 60.0},
            "how far it is out of focus: the diameter of the disc that a point of light becomes. A lens of 50 mm at f/4 that "
            "is focused on glass 0.8 m away shows 1°, close-ups 3° and more")
            .idle([](const SceneFacts& f) { return !f.table.place_of_given("light.environment"); }, "without an environment"),
        LightRow::number("environment_gain", in(&LightAsked::light, &studio::Light::environment_gain), {0.0, 1000.0},
                         "how bright it is, a factor"),
        LightRow::angle("sun_azimuth_deg", in(&LightAsked::sun, &studio::Sun::azimuth), {-360.0, 360.0},
                        "where the sun stands, from +y clockwise as on a compass")
            .beside("sun_elevation_deg", "sun_elevation_deg beside it")
            .by_default("no sun"),
        LightRow::angle("sun_elevation_deg", in(&LightAsked::sun, &studio::Sun::elevation), {-90.0, 90.0}, "how high")
            .beside("sun_azimuth_deg", "sun_azimuth_deg beside it")
            .by_default("no sun"),
        LightRow::number("sun_gain", in(&LightAsked::sun, &studio::Sun::gain), {0.0, 1000.0},
                         "1: as bright as noon beside an environment of gain 1")
            .idle([](const SceneFacts& f) { return !f.table.place_of_given("light.sun_elevation_deg"); }, "without a sun"),
        LightRow::number("exposure_ev", in(&LightAsked::light, &studio::Light::exposure_ev), {-20.0, 20.0},
                         "pictures are brighter by 2 to this power"),
    }};

const Section<PlanAsked, SceneFacts> plan_keys{
    "plan",
    {
        PlanRow::point("origin", &PlanAsked::origin, {-farthest, farthest}, "what becomes (0, 0): `[13.4412, 52.4736]`")
            .written("`[x, y]` in the units of the GeoJSON files")
            .by_default("the first outline, see below")
            .idle([](const SceneFacts& f) { return !f.takes_plan(false); }, "without a plan in GeoJSON"),
        PlanRow::number("svg_scale", &PlanAsked::svg_scale, svg_scale_range,
                        "millimetres in the world for one on an SVG page: 100 for a drawing in 1:100")
            .idle([](const SceneFacts& f) { return !f.takes_plan(true); }, "without a plan in SVG"),
    }};

}  // namespace shatterpave::scene
