#include "scene/schema/scene_keys.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "core/embedded.h"
#include "scene/schema/pane_keys.h"
#include "scene/schema/pavement_keys.h"

namespace shatterpave::scene {

namespace {

using SceneRow = Row<Scene, SceneFacts>;
using StillRow = Row<Still, SceneFacts>;
using PlanRow = Row<PlanAsked, SceneFacts>;

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
    if (name != nullptr && key.str().ends_with("_file") && is_svg(name->get()) == svg) return true;
    if (node_takes_plan(value, svg)) return true;
  }
  return false;
}

}  // namespace

bool SceneFacts::takes_plan(bool svg) const { return node_takes_plan(table.node(), svg); }

std::vector<std::string_view> settings() {
  constexpr std::string_view ending = "_still.pov";
  std::vector<std::string_view> names;
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
        SceneRow::tables("pavement", most_pavements, "a paved area each").by_default("none"),
        SceneRow::table("still", "how pictures show the things"),
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

const Section<PlanAsked, SceneFacts> plan_keys{
    "plan",
    {
        PlanRow::point("origin", &PlanAsked::origin, {-farthest, farthest}, "what becomes (0, 0): `[13.4412, 52.4736]`")
            .written("`[x, y]` in the units of the GeoJSON files")
            .by_default("the first outline, see below")
            .idle([](const SceneFacts& f) { return !f.takes_plan(false); }, "without a plan in GeoJSON"),
        PlanRow::number("svg_scale", &PlanAsked::svg_scale, {0.001, 100'000.0},
                        "millimetres in the world for one on an SVG page: 100 for a drawing in 1:100")
            .idle([](const SceneFacts& f) { return !f.takes_plan(true); }, "without a plan in SVG"),
    }};

}  // namespace shatterpave::scene
