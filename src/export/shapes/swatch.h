// Swatches: seamless squares of a material, without joints, that textures of stones and of what fills their joints are made of.
// This says which there are; export/swatches draws them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "export/model.h"
#include "export/shapes/palette.h"
#include "paving/pavement.h"

namespace shatterpave::exporting::shapes {

enum class SwatchOf { stone, joint };

struct Swatch {
  std::string name;  // unique in the model: letters, digits and '_'; what names of files begin with
  SwatchOf of = SwatchOf::stone;
  paving::Look look;
  paving::Relief relief;       // of the stones
  double longest_mm = 100.0;   // of the waves of the relief, > 0
  double side_m = 1.0;         // of the square, > 0: a place in the picture is `uv_m / side_m`
  std::size_t size_px = 1024;  // of a side of the pictures, 1 … 4096
};

// How a material uses a swatch: the pictures are multiplied by these, which are 0 … 1, and then are of the material.
struct SwatchUse {
  std::size_t swatch = 0;  // its number among those of the model
  Colour tint;
  float roughness = 1.0F;
};

// Stones begin at places of their swatch on a grid of so many by so many: 64 in all.
inline constexpr int places_aside = 8;

// The side of the swatch for the stones of a layout: the least of whole metres, up to 8, in which seven neighbours of any of
// them leave it a part of its own.
double swatch_side_m(const PavedArea& paved);
// By how much a texture reaches beyond the outline of a stone at the most, where it is folded down over arris and side.
double folded_mm(const paving::Pavement& pavement);

// The swatch of a pavement's stones, and that of its joints; without names. None where the pavement asks for colours alone.
std::optional<Swatch> stone_swatch(const PavedArea& paved);
std::optional<Swatch> joint_swatch(const PavedArea& paved);

// Whether both show the same, whatever they are called.
bool are_alike(const Swatch& a, const Swatch& b);

// The number of a swatch that is alike in the list, to which it is added with a name of its own where there is none.
std::size_t number_in(std::vector<Swatch>& list, Swatch swatch);

}  // namespace shatterpave::exporting::shapes
