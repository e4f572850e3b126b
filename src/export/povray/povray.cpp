#include "export/povray/povray.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "core/embedded.h"
#include "core/error.h"
#include "export/povray/glass.h"
#include "export/povray/sdl.h"
#include "export/povray/still_stage.h"
#include "export/povray/stones.h"
#include "paving/surface/ground.h"
#include "paving/surface/stone_surface.h"
#include "studio/world.h"

namespace shatterpave::exporting::povray {

namespace {

// Ground that pavements lie on: a round patch.
struct Earth {
  vec3 middle_mm{0.0, 0.0, 0.0};
  double radius_mm = 0.0;
};

// As low as the lowest filling of a joint, a little lower, so that no stone is buried.
Earth earth_below(const Model& model) {
  constexpr double clear_mm = 3.0;  // by eye
  vec2 low(std::numeric_limits<double>::max());
  vec2 high = -low;
  double level_mm = std::numeric_limits<double>::max();
  for (const PavedArea& paved : model.pavements) {
    const paving::Pavement& pavement = paved.pavement;
    for (const vec2& p : pavement.area.outline) {
      const double height =
          pavement.ground.level_mm + glm::dot(paving::fall(pavement.ground), p) - pavement.ground.settlement_mm;
      const vec3 at = studio::placed({p, height + paving::bed_level_mm(pavement)}, pavement.placement);
      low = glm::min(low, vec2{at.x, at.y});
      high = glm::max(high, vec2{at.x, at.y});
      level_mm = std::min(level_mm, at.z);
    }
  }
  return {{0.5 * (low + high), level_mm - clear_mm}, 0.5 * glm::length(high - low)};
}

constexpr std::string_view own_setting = "own";
constexpr std::string_view still_ending = "_still.pov";
constexpr std::string_view model_mark = "//@model\n";
// What begins and ends the parts of a template that a scene's own camera and light stand in for.
constexpr std::string_view camera_mark = "//@camera";
constexpr std::string_view light_mark = "//@light";
constexpr std::string_view end_mark = "//@end";

std::string setting_of(const Model& model) {
  std::string setting = !model.setting.empty() ? model.setting : (model.panes.empty() ? "path_still" : "window_still");
  const std::vector<std::string> known = settings();
  if (std::ranges::find(known, setting) == known.end()) {
    throw InputError(fmt::format("setting: expected one of {}, got \"{}\"", fmt::join(known, ", "), setting));
  }
  return setting;
}

// #macro NAME(I …) that gives the I-th of the objects `values`: an array would copy them.
std::string choice(const std::string& head, const std::vector<std::string>& values) {
  std::string text = fmt::format("#macro {}\n   #switch (I)\n", head);
  for (std::size_t i = 0; i < values.size(); ++i) text += fmt::format("      #case ({}) {} #break\n", i, values[i]);
  return text + "   #end\n#end\n";
}

// An array of `values`; nothing where there are none, since an array must hold something.
std::string array(const std::string& name, const std::vector<std::string>& values) {
  if (values.empty()) return {};
  return fmt::format("#declare {} = array[{}] {{ {} }}\n", name, values.size(), fmt::join(values, ", "));
}

std::vector<std::string> each(const std::vector<std::string>& prefixes, std::string_view pattern) {
  std::vector<std::string> texts;
  texts.reserve(prefixes.size());
  for (const std::string& prefix : prefixes) texts.push_back(fmt::format(fmt::runtime(pattern), prefix));
  return texts;
}

// Where shards may have fallen to, for all panes once one of them has shards.
std::string shard_places(const Model& model) {
  if (std::ranges::none_of(model.panes, [](const BrokenPane& broken) { return broken.pane.shards.has_value(); })) return {};
  std::string text;
  for (const auto& [name, member] :
       {std::pair{"Sill_Drop", &glass::ShardRules::sill_drop_mm}, std::pair{"Sill_Depth", &glass::ShardRules::sill_depth_mm},
        std::pair{"Frame", &glass::ShardRules::frame_mm}, std::pair{"Reveal", &glass::ShardRules::reveal_mm},
        std::pair{"Floor_Drop", &glass::ShardRules::floor_drop_mm}}) {
    std::vector<std::string> values;
    for (const BrokenPane& broken : model.panes) {
      values.push_back(number(broken.pane.shards.value_or(glass::ShardRules{}).*member));
    }
    text += array(fmt::format("Still_Pane_{}", name), values);
  }
  return text;
}

// The index of violet over that of red, 400 and 700 nm: soda-lime glass of n = 1.52 and an Abbe number of 59 has 0.0089 between
// the lines F and C, and about twice that between those ends.
constexpr double glass_dispersion = 1.012;
// By eye, on scenes/broken_window.toml: ten times as many take longer and show nothing more.
constexpr int photons = 400'000;

// "rotate … translate …" to where a thing stands in the world; empty where it is placed nowhere else.
std::string placement_text(const studio::Placement& placement) {
  if (placement == studio::Placement{}) return {};
  return fmt::format(" rotate {} * y translate {}", number(-placement.turn.degrees()), lying_point(placement.at_mm));
}

template <typename Things, typename Of>
std::vector<std::string> placement_texts(const Things& things, Of of) {
  std::vector<std::string> texts;
  texts.reserve(things.size());
  for (const auto& thing : things) texts.push_back(placement_text(of(thing)));
  return texts;
}

// What the setting "own" reads beside the rest: where things stand, and the ground below pavements.
std::string own_text(const Model& model) {
  std::string text =
      choice("Still_Pane_Place(I)", placement_texts(model.panes, [](const BrokenPane& b) { return b.pane.placement; }));
  text += choice("Still_Pavement_Place(I)",
                 placement_texts(model.pavements, [](const PavedArea& paved) { return paved.pavement.placement; }));
  if (model.pavements.empty()) return text;
  const Earth earth = earth_below(model);
  return text + fmt::format("#declare Still_Earth_Middle = {};\n#declare Still_Earth_Radius = {};\n",
                            lying_point(earth.middle_mm), number(earth.radius_mm));
}

// Whether all light is that of far lights, which stand for the picture all around.
bool is_lit_from_around_alone(const Model& model) { return model.light && !model.light->sun; }

// Where light comes from all around, the shadows of cracks are too faint to be seen, and without them a ray to a light need not
// pass all gaps on its way, thousands in tempered glass.
std::vector<std::string> pane_objects(const Model& model, const std::vector<std::string>& panes) {
  std::vector<std::string> texts;
  texts.reserve(panes.size());
  for (std::size_t i = 0; i < panes.size(); ++i) {
    const bool casts_shadows = !is_lit_from_around_alone(model) || model.panes[i].pane.shards.has_value();
    const std::string_view how = model.caustics  ? " photons { target refraction on reflection on collect off }"
                                 : casts_shadows ? ""
                                                 : " no_shadow";
    texts.push_back(fmt::format("object {{ {}_Pane{} }}", panes[i], how));
  }
  return texts;
}

// What stands in the scene for the mark.
std::string model_text(const Model& model, const std::vector<std::string>& panes, const std::vector<std::string>& pavements) {
  std::string text;
  // Glass mirrors the picture all around by itself.
  if (is_lit_from_around_alone(model)) text += "#declare Shatterpave_Glint = 0;\n";
  if (model.dispersion) text += fmt::format("#declare Shatterpave_Dispersion = {};\n", glass_dispersion);
  if (model.caustics) text += fmt::format("global_settings {{ photons {{ count {} }} }}\n", photons);
  for (const BrokenPane& broken : model.panes) text += fmt::format("#include \"{}.inc\"\n", stem_of(broken));
  for (const PavedArea& paved : model.pavements) text += fmt::format("#include \"{}.inc\"\n", stem_of(paved));
  text += fmt::format("#declare Still_Pane_Count = {};\n#declare Still_Pavement_Count = {};\n", panes.size(), pavements.size());
  text += choice("Still_Pane(I)", pane_objects(model, panes));
  text += array("Still_Pane_Min", each(panes, "{}_Min"));
  text += array("Still_Pane_Max", each(panes, "{}_Max"));
  text += array("Still_Pane_Rectangular", each(panes, "{}_Rectangular"));
  text += shard_places(model);
  text += choice("Still_Pane_Surround(I, Width, Depth)", each(panes, "{}_Surround(Width, Depth)"));
  text += choice("Still_Pavement(I)", each(pavements, "object {{ {}_Pavement }}"));
  text += choice("Still_Pavement_Bed(I)", each(pavements, "object {{ {}_Bed }}"));
  text += array("Still_Pavement_Min", each(pavements, "{}_Min"));
  text += array("Still_Pavement_Max", each(pavements, "{}_Max"));
  return text;
}

// The template without marks. A part between marks goes where the scene has a camera or light of its own: what is called in its
// place has the arguments that stand behind the mark; without arguments, nothing is.
std::string staged(std::string_view pattern, const StillStage& stage) {
  std::string text;
  bool is_left_out = false;
  while (!pattern.empty()) {
    const std::size_t end = std::min(pattern.find('\n'), pattern.size() - 1) + 1;
    const std::string_view line = pattern.substr(0, end);
    pattern.remove_prefix(end);
    const bool camera = line.starts_with(camera_mark);
    if (camera || line.starts_with(light_mark)) {
      is_left_out = camera ? stage.has_camera : stage.has_light;
      std::string_view arguments = line.substr((camera ? camera_mark : light_mark).size());
      arguments.remove_suffix(1);
      if (is_left_out && !arguments.empty()) {
        text += fmt::format("{}({})\n", camera ? "Still_Camera" : "Still_Light", arguments.substr(1));
      }
    } else if (line.starts_with(end_mark)) {
      is_left_out = false;
    } else if (!is_left_out) {
      text += line;
    }
  }
  return text;
}

OutputFile still(const Model& model, const std::vector<std::string>& panes, const std::vector<std::string>& pavements,
                 const StillStage& stage) {
  const std::string setting = setting_of(model);
  std::string text = staged(embedded_text(setting + ".pov"), stage);
  const std::size_t mark = text.find(model_mark);
  ENSURE(mark != std::string::npos);
  std::string things = model_text(model, panes, pavements);
  if (setting == own_setting) things += own_text(model);
  text.replace(mark, model_mark.size(), things + stage.declarations);
  return {model.name + ".pov", text};
}

// Appends the embedded includes that the files include, and those that these include.
void append_materials(std::vector<OutputFile>& files) {
  for (std::size_t i = 0; i < files.size(); ++i) {
    for (const EmbeddedFile& embedded : embedded_files()) {
      const auto has_its_name = [&](const OutputFile& file) { return file.name == embedded.name; };
      if (files[i].content.find(fmt::format("#include \"{}\"", embedded.name)) == std::string::npos) continue;
      if (std::ranges::none_of(files, has_its_name)) {
        files.push_back({std::string(embedded.name), std::string(embedded.text)});
      }
    }
  }
}

// Of the identifiers of each thing.
struct Prefixes {
  std::vector<std::string> panes;
  std::vector<std::string> pavements;
};

Prefixes prefixes_of(const Model& model) {
  std::vector<std::string> names;
  for (const BrokenPane& broken : model.panes) names.push_back(broken.pane.name);
  for (const PavedArea& paved : model.pavements) names.push_back(paved.pavement.name);
  const std::vector<std::string> prefixes = identifiers(names);
  const auto pavements_begin = prefixes.begin() + static_cast<std::ptrdiff_t>(model.panes.size());
  return {{prefixes.begin(), pavements_begin}, {pavements_begin, prefixes.end()}};
}

StillStage stage_of(const Model& model) { return still_stage(model, setting_of(model) == own_setting); }

// The focus may go from one thing to another over a shot.
bool is_shared_by_frames(const SkyPicture& sky) { return sky.blur == Angle(); }

// The includes of the things that `wanted` says, by their number, panes first.
void append_things(const Model& model, const Prefixes& prefixes, const IsShared& wanted, std::vector<OutputFile>& files) {
  const std::size_t panes = model.panes.size();
  for (std::size_t i = 0; i < panes; ++i) {
    if (wanted(i)) files.push_back(pane_include(model.panes[i], prefixes.panes[i], model.seed));
  }
  for (std::size_t i = 0; i < model.pavements.size(); ++i) {
    if (!wanted(panes + i)) continue;
    std::ranges::move(pavement_files(model.pavements[i], prefixes.pavements[i], model.seed), std::back_inserter(files));
  }
}

}  // namespace

std::vector<std::string> settings() {
  std::vector<std::string> names{std::string(own_setting)};
  for (const EmbeddedFile& file : embedded_files()) {
    if (file.name.ends_with(still_ending)) names.emplace_back(file.name.substr(0, file.name.size() - 4));
  }
  std::ranges::sort(names);
  return names;
}

std::vector<OutputFile> povray_files(const Model& model) {
  const Prefixes prefixes = prefixes_of(model);
  const StillStage stage = stage_of(model);
  std::vector<OutputFile> files{still(model, prefixes.panes, prefixes.pavements, stage)};
  append_things(
      model, prefixes, [](std::size_t /*thing*/) { return true; }, files);
  append_materials(files);
  if (stage.sky) files.push_back(sky_file(*stage.sky));
  return files;
}

std::vector<OutputFile> frame_files(const Model& model, const IsShared& is_shared) {
  const Prefixes prefixes = prefixes_of(model);
  const StillStage stage = stage_of(model);
  std::vector<OutputFile> files{still(model, prefixes.panes, prefixes.pavements, stage)};
  append_things(
      model, prefixes, [&](std::size_t thing) { return !is_shared(thing); }, files);
  append_materials(files);
  if (stage.sky && !is_shared_by_frames(*stage.sky)) files.push_back(sky_file(*stage.sky));
  return files;
}

std::vector<OutputFile> shared_files(const Model& model, const IsShared& is_shared) {
  std::vector<OutputFile> files;
  append_things(model, prefixes_of(model), is_shared, files);
  append_materials(files);
  const StillStage stage = stage_of(model);
  if (stage.sky && is_shared_by_frames(*stage.sky)) files.push_back(sky_file(*stage.sky));
  return files;
}

void append(const Model& model, Outputs& outputs) { std::ranges::move(povray_files(model), std::back_inserter(outputs.files)); }

}  // namespace shatterpave::exporting::povray
