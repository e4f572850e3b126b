#include "scene/outline_file.h"

#include <algorithm>

#include "scene/input_file.h"

namespace shatterpave::scene {

geometry::Region outline_of_file(const std::filesystem::path& file, const OutlineChoice& choice) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  const bool svg = ending == ".svg";
  if (!svg && ending != ".geojson" && ending != ".json") {
    throw InputError(choice.file_place,
                     "expected a file that ends in .geojson, .json or .svg, got " + in_quotes(file.filename().string()));
  }
  const std::string text = input_text(file, largest_outline_bytes, choice.file_place);
  require_utf8(text, file.string());
  if (!svg) return outline_of_geojson(text, file.string(), choice);
  if (choice.units) throw InputError(choice.units_place, "expected no such key for SVG, which has its own units, got it");
  return outline_of_svg(text, file.string(), choice);
}

}  // namespace shatterpave::scene
