#include "export/povray/povray.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "core/embedded.h"
#include "core/error.h"
#include "export/povray/glass.h"
#include "export/povray/sdl.h"
#include "export/povray/stones.h"

namespace shatterpave::exporting::povray {

namespace {

constexpr std::string_view still_ending = "_still.pov";
constexpr std::string_view model_mark = "//@model\n";

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

// What stands in the scene for the mark.
std::string model_text(const Model& model, const std::vector<std::string>& panes, const std::vector<std::string>& pavements) {
  std::string text;
  if (model.dispersion) text += fmt::format("#declare Shatterpave_Dispersion = {};\n", glass_dispersion);
  if (model.caustics) text += fmt::format("global_settings {{ photons {{ count {} }} }}\n", photons);
  for (const BrokenPane& broken : model.panes) text += fmt::format("#include \"{}.inc\"\n", broken.pane.name);
  for (const PavedArea& paved : model.pavements) text += fmt::format("#include \"{}.inc\"\n", paved.pavement.name);
  text += fmt::format("#declare Still_Pane_Count = {};\n#declare Still_Pavement_Count = {};\n", panes.size(), pavements.size());
  text +=
      choice("Still_Pane(I)",
             each(panes, model.caustics ? "object {{ {}_Pane photons {{ target refraction on reflection on collect off }} }}"
                                        : "object {{ {}_Pane }}"));
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

OutputFile still(const Model& model, const std::vector<std::string>& panes, const std::vector<std::string>& pavements) {
  std::string text{embedded_text(setting_of(model) + ".pov")};
  const std::size_t mark = text.find(model_mark);
  ENSURE(mark != std::string::npos);
  text.replace(mark, model_mark.size(), model_text(model, panes, pavements));
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

}  // namespace

std::vector<std::string> settings() {
  std::vector<std::string> names;
  for (const EmbeddedFile& file : embedded_files()) {
    if (file.name.ends_with(still_ending)) names.emplace_back(file.name.substr(0, file.name.size() - 4));
  }
  std::ranges::sort(names);
  return names;
}

std::vector<OutputFile> povray_files(const Model& model) {
  std::vector<std::string> names;
  for (const BrokenPane& broken : model.panes) names.push_back(broken.pane.name);
  for (const PavedArea& paved : model.pavements) names.push_back(paved.pavement.name);
  const std::vector<std::string> prefixes = identifiers(names);
  const auto pavements_begin = prefixes.begin() + static_cast<std::ptrdiff_t>(model.panes.size());
  const std::vector<std::string> panes(prefixes.begin(), pavements_begin);
  const std::vector<std::string> pavements(pavements_begin, prefixes.end());

  std::vector<OutputFile> files{still(model, panes, pavements)};
  for (std::size_t i = 0; i < panes.size(); ++i) files.push_back(pane_include(model.panes[i], panes[i]));
  for (std::size_t i = 0; i < pavements.size(); ++i) {
    std::ranges::move(pavement_files(model.pavements[i], pavements[i], model.seed), std::back_inserter(files));
  }
  append_materials(files);
  return files;
}

void append(const Model& model, Outputs& outputs) { std::ranges::move(povray_files(model), std::back_inserter(outputs.files)); }

}  // namespace shatterpave::exporting::povray
