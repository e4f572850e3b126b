// The stones of a pavement as POV-Ray's objects, in text.
//
// As patches; or, where a pavement says from where it is seen, by distance: near ones as meshes with their relief and chips as
// true geometry, then patches with ever fewer steps, and far ones as prisms with sloping sides, which are a tenth of the work.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "export/model.h"
#include "relief/height_field.h"

namespace shatterpave::exporting::povray {

// Classes of wear, from rough to polished; only the first without wear.
inline constexpr int wear_classes = 3;

struct StoneText {
  int tone = 0;
  int wear = 0;
  bool displaced = false;  // a mesh that has the relief as geometry
  std::size_t objects = 0;
  double face_mm = 0.0;  // height of the stone in its middle
  std::string text;
  // Of a far stone: parts of the one mesh that all of a group share. Indices count from the stone's first vertex.
  std::string vertices;
  std::string places;
  std::vector<std::uint32_t> triangles;
  std::size_t vertex_count = 0;
};

// Wear of a class as a factor on the relief.
double relief_of_wear(int wear);

//   relief_side_mm  of the periodic relief
//   relief          its heights, for stones that are close; else may be null
std::vector<StoneText> stone_texts(const PavedArea& paved, std::uint64_t seed, double relief_side_mm,
                                   const relief::HeightField* relief);

// `units` / 10^decimals, without trailing zeros: by hand because there are megabytes of it.
void append_decimal(std::string& text, std::int64_t units, int decimals);

// Ours has z up, POV-Ray's y: the exchange of y and z also turns right-handed into left-handed. To a thousandth of a mm.
void append_stone_point(std::string& text, vec3 mm);

}  // namespace shatterpave::exporting::povray
