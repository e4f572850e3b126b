// The colours of stones and sand: linear, of the primaries of sRGB.
#pragma once

namespace shatterpave::exporting::textures {

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

// What is seen of a place, beside its stone's own colour.
struct Place {
  float relief = 0.0F;  // height of the relief over its root mean square: deep pits are at −3
  float grain = 0.0F;   // of the minerals, of rms 1
  float rise = 1.0F;    // height over that of the highest stone; below 0.5 stones are stained by what lies in the joints
};

// The colour of a stone that drew `colour`, 0 … 1: one of the tones that the POV-Ray target knows.
Colour stone_colour(double colour);
// As it is at one place of it.
Colour stone_colour_at(const Colour& stone, const Place& place);
// Sand, darker between its grains.
Colour bed_colour(float grain);

// 0 is a mirror, 1 is chalk: feet polish what stands out of a stone.
float stone_roughness(double colour, const Place& place);
float bed_roughness(float grain);

}  // namespace shatterpave::exporting::textures
