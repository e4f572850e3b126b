// The colours of stones and of what fills their joints: linear, of the primaries of sRGB. After the materials of the POV-Ray
// target (templates/includes/shatterpave_materials.inc): a stone has there and here the same colour of its own.
#pragma once

#include <vector>

#include "core/vec.h"
#include "paving/pavement.h"

namespace shatterpave::exporting::shapes {

struct Colour {
  float red = 0.0F;
  float green = 0.0F;
  float blue = 0.0F;

  Colour operator*(float factor) const { return {red * factor, green * factor, blue * factor}; }
  Colour operator*(const Colour& other) const { return {red * other.red, green * other.green, blue * other.blue}; }
  bool operator==(const Colour&) const = default;
};

// `a` where part is 0, `b` where it is 1.
Colour mixed(const Colour& a, const Colour& b, float part);

// What is seen of a place of a stone, beside the stone's own colour.
struct Place {
  float relief = 0.0F;  // height of the relief over its root mean square: deep pits are at −3
  float grain = 0.0F;   // of the minerals, of rms 1
  float cloud = 0.0F;   // the same, `cloud_mm` wide
  float rise = 1.0F;    // height over that of the highest stone; below 0.5 stones are stained by what lies in the joints
  float patch = 0.0F;   // of what grows here and there, of rms 1
  float bend = 0.0F;    // by how many beds those of the stone are moved here
  vec2 from_centre_mm{0.0, 0.0};
};

// A place of the filling of the joints; both of rms 1.
struct BedPlace {
  float grain = 0.0F;  // high are light, coarse grains
  float patch = 0.0F;
};

// What all places of a stone have in common.
struct StoneLook {
  Colour colour;
  float roughness = 0.5F;
  vec2 beds_per_mm{0.0, 0.0};  // across its beds, if it has any
  Colour vein;                 // the colour itself, if it has none
};

class Palette {
 public:
  explicit Palette(const paving::Look& look);

  // Of a stone that drew `colour`, 0 … 1: one of the tones that the POV-Ray target knows. `own`, if it is not −1: which of the
  // user's own colours it has.
  StoneLook stone(double colour, int own = -1) const;
  Colour stone_colour(const StoneLook& stone, const Place& place) const;
  // 0 is a mirror, 1 is chalk: feet polish what stands out of a stone, and water lies over all.
  float stone_roughness(const StoneLook& stone, const Place& place) const;

  // For swatches, which all tones share: a stone of the lightest grey whose colours are 1 at most, so that times `tint` of a
  // tone it has that tone's colours; and as rough as the roughest tone, so that it is the same with `roughness_part`. Its beds
  // cross a square of `side_mm` a whole number of times.
  StoneLook swatch_stone(double side_mm) const;
  Colour tint(const StoneLook& stone) const;
  float roughness_part(const StoneLook& stone) const;
  // The vein of a stone of that colour: 0 is rusty, 1 of white spar.
  static Colour vein(const Colour& stone, float spar);
  // The same for the joints: times `joint_tint` the colours of a swatch are those of `bed_colour`.
  static constexpr float joint_tint = 0.4F;

  // What is below standing water looks so, and the water's own surface is as smooth as that.
  static Colour under_water(const Colour& colour);
  static constexpr float water_roughness = 0.02F;

  Colour bed_colour(const BedPlace& place) const;
  float bed_roughness(const BedPlace& place) const;

  // How wide the minerals and the clouds of the material are, mm; no clouds: 0.
  double mineral_mm() const;
  double cloud_mm() const;
  bool has_moss() const { return moss_ > 0.0F; }

 private:
  float mossy(float patch) const;
  float brightest() const;

  paving::Material material_;
  bool mortar_;
  float moss_;  // 0 … 1
  float damp_;  // 0 … 1
  std::vector<Colour> own_;
};

}  // namespace shatterpave::exporting::shapes
