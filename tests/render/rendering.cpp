#include "render/rendering.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "export/povray/povray.h"
#include "pipeline/generate.h"
#include "render/picture_row.h"
#include "render/povray.h"
#include "scene/read_scene.h"

namespace shatterpave::render_tests {

namespace {

scene::Override override_of(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) throw std::runtime_error("set: expected KEY=VALUE, got " + text);
  return {"expect.toml: " + text, text.substr(0, equals), text.substr(equals + 1)};
}

exporting::Model model_of(const Case& of, const NearMiss* miss, std::optional<std::uint64_t> seed) {
  std::vector<scene::Override> overrides;
  std::ranges::transform(of.set, std::back_inserter(overrides), override_of);
  if (miss != nullptr) std::ranges::transform(miss->set, std::back_inserter(overrides), override_of);
  scene::Scene read = scene::scene_of_file(of.scene, overrides);
  read.name = of.name;
  if (seed) read.seed = *seed;
  exporting::Model model = pipeline::generated(read);
  if (miss != nullptr && miss->without_stone) {
    auto& stones = model.pavements.at(0).layout.stones;
    stones.erase(stones.begin() + static_cast<std::ptrdiff_t>(*miss->without_stone));
  }
  return model;
}

// Every place where `find` stands, in all files. A replacement that finds nothing would make a near miss that misses nothing.
void replace(std::vector<exporting::OutputFile>& files, const Replacement& replacement) {
  std::size_t count = 0;
  for (exporting::OutputFile& file : files) {
    for (std::size_t at = file.content.find(replacement.find); at != std::string::npos;
         at = file.content.find(replacement.find, at + replacement.by.size())) {
      file.content.replace(at, replacement.find.size(), replacement.by);
      ++count;
    }
  }
  if (count == 0) throw std::runtime_error("replace: no exported file holds \"" + replacement.find + '"');
}

}  // namespace

relief::Raster picture(const Case& of, const NearMiss* miss, std::optional<std::uint64_t> seed,
                       const std::filesystem::path& folder) {
  std::vector<exporting::OutputFile> files = exporting::povray::povray_files(model_of(of, miss, seed));
  if (miss != nullptr) {
    for (const Replacement& replacement : miss->replace) replace(files, replacement);
  }
  if (of.draft) replace(files, {"#declare Quality = 1;", "#declare Quality = 0;"});
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  for (const exporting::OutputFile& file : files) {
    std::ofstream(folder / file.name, std::ios::binary) << file.content;
  }
  const std::size_t factor = of.oversampling;
  return shrunk(rendered(folder, of.name + ".pov", of.width * factor, of.height * factor), factor);
}

}  // namespace shatterpave::render_tests
