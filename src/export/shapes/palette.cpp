// Figures without a source are by eye, after photographs of paving, and so that a pavement looks alike in both targets.
#include "export/shapes/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "core/angle.h"
#include "core/functions.h"
#include "export/shapes/tones.h"

namespace shatterpave::exporting::shapes {

namespace {

using Stone = paving::Material;

// The quarry of templates/includes/shatterpave_stone.inc: greys from cold to warm, some of them rusty, after granite setts.
constexpr std::array<Colour, 7> quarry = {{{0.205F, 0.205F, 0.215F},
                                           {0.150F, 0.152F, 0.165F},
                                           {0.250F, 0.235F, 0.215F},
                                           {0.185F, 0.172F, 0.158F},
                                           {0.285F, 0.262F, 0.232F},
                                           {0.225F, 0.190F, 0.160F},
                                           {0.170F, 0.175F, 0.178F}}};

struct Stop {
  float at;
  Colour colour;
};

constexpr Colour grey(float value) { return {value, value, value}; }

// Over the grain. Feldspar, quartz and mica about the colour of the stone.
constexpr std::array<Stop, 6> sett_minerals = {{{-1.8F, grey(0.45F)},
                                                {-0.9F, grey(0.80F)},
                                                {-0.1F, grey(1.0F)},
                                                {0.6F, grey(1.12F)},
                                                {1.4F, grey(1.45F)},
                                                {2.4F, grey(1.70F)}}};
constexpr std::array<Stop, 7> granite_minerals = {{{-1.25F, grey(0.13F)},
                                                   {-1.10F, grey(0.66F)},
                                                   {-0.30F, grey(0.76F)},
                                                   {-0.15F, grey(0.90F)},
                                                   {0.45F, grey(1.02F)},
                                                   {0.60F, {1.22F, 1.20F, 1.18F}},
                                                   {2.20F, {1.36F, 1.34F, 1.31F}}}};
constexpr std::array<Stop, 5> basalt_minerals = {
    {{-1.7F, grey(0.32F)}, {-1.5F, grey(0.80F)}, {0.2F, grey(1.0F)}, {1.5F, grey(1.25F)}, {1.7F, grey(2.1F)}}};
constexpr std::array<Stop, 3> sandstone_grains = {{{-1.8F, grey(0.76F)}, {0.0F, grey(1.0F)}, {1.8F, grey(1.28F)}}};
constexpr std::array<Stop, 3> limestone_grains = {{{-2.0F, grey(0.90F)}, {0.0F, grey(1.0F)}, {2.0F, grey(1.09F)}}};
constexpr std::array<Stop, 6> brick_grains = {{{-1.6F, grey(0.42F)},
                                               {-1.4F, grey(0.86F)},
                                               {0.2F, grey(1.0F)},
                                               {1.35F, grey(1.18F)},
                                               {1.5F, {1.55F, 1.85F, 1.95F}},
                                               {2.4F, {1.7F, 2.1F, 2.3F}}}};

// Over the height between two beds of sandstone, 0 … 1.
constexpr std::array<Stop, 6> beds = {{{0.0F, grey(0.82F)},
                                       {0.30F, {1.05F, 1.02F, 0.97F}},
                                       {0.50F, {1.10F, 1.07F, 1.02F}},
                                       {0.58F, {0.88F, 0.81F, 0.74F}},
                                       {0.66F, grey(1.03F)},
                                       {1.0F, grey(0.82F)}}};

// Dirt stays in the pits, and feet polish what stands out: over the relief.
constexpr std::array<Stop, 3> wear = {{{-2.5F, {0.62F, 0.58F, 0.52F}}, {-0.2F, grey(1.0F)}, {2.7F, grey(1.22F)}}};

constexpr Colour stain{0.105F, 0.088F, 0.068F};
constexpr float stained_below = 0.08F;
constexpr float clean_above = 0.36F;

constexpr std::array<Stop, 2> sand = {{{-2.0F, {0.045F, 0.038F, 0.029F}}, {2.0F, {0.205F, 0.172F, 0.130F}}}};
constexpr std::array<Stop, 2> mortar = {{{-2.0F, {0.200F, 0.190F, 0.175F}}, {2.0F, {0.345F, 0.335F, 0.315F}}}};
constexpr std::array<Stop, 3> moss = {
    {{-1.5F, {0.022F, 0.031F, 0.010F}}, {0.5F, {0.070F, 0.094F, 0.030F}}, {1.6F, {0.140F, 0.160F, 0.060F}}}};

// Water in the pores of what is wet: darker by so much, and with a film that shines.
constexpr float wet_dark = 0.48F;
constexpr float wet_roughness = 0.16F;

// By how much the roughest tone of a material is rougher than the smoothest.
constexpr float rougher = 0.12F;

constexpr Colour rusty_vein{0.72F, 0.58F, 0.42F};
constexpr Colour white_vein{1.22F, 1.24F, 1.26F};

struct Traits {
  std::span<const Stop> minerals;
  double mineral_mm;
  double cloud_mm;
  float roughness;
};

Traits traits(Stone material) {
  switch (material) {
    case Stone::setts:
      break;
    case Stone::granite:
      return {granite_minerals, 2.6, 0.0, 0.56F};
    case Stone::basalt:
      return {basalt_minerals, 1.6, 45.0, 0.52F};
    case Stone::sandstone:
      return {sandstone_grains, 1.0, 30.0, 0.80F};
    case Stone::limestone:
      return {limestone_grains, 2.0, 32.0, 0.66F};
    case Stone::brick:
      return {brick_grains, 1.8, 60.0, 0.84F};
  }
  return {sett_minerals, 1.6, 0.0, 0.56F};
}

Colour between_stops(std::span<const Stop> stops, float at) {
  if (at <= stops.front().at) return stops.front().colour;
  for (std::size_t k = 1; k < stops.size(); ++k) {
    if (at > stops[k].at) continue;
    return mixed(stops[k - 1].colour, stops[k].colour, (at - stops[k - 1].at) / (stops[k].at - stops[k - 1].at));
  }
  return stops.back().colour;
}

// The tone's number from 0, and its k-th draw, 0 … 1: Shatterpave_Draw of the template, so that colours are the same.
struct Tone {
  int number = 0;

  double draw(int k) const {
    const double far = 437.5453 * std::abs(sine((number + 1) * 12.9898 + k * 78.233));
    return far - std::floor(far);
  }
  float part(int k) const { return static_cast<float>(draw(k)); }
};

Colour sett_colour(Tone tone) {
  // The middle of the tone, as the POV-Ray target has it, and then what its template makes of that.
  const auto step = static_cast<std::size_t>(shapes::colour_of(tone.number) * 21.0);
  const double light = 0.98 + 0.44 * static_cast<double>(step * 5 % 21) / 20.0;
  return quarry.at(step * 3 % quarry.size()) * static_cast<float>(light);
}

Colour colour_of(Stone material, Tone tone) {
  const float first = tone.part(1);
  const float second = tone.part(2);
  switch (material) {
    case Stone::setts:
      return sett_colour(tone);
    case Stone::granite:
      return mixed(mixed({0.34F, 0.335F, 0.33F}, {0.44F, 0.425F, 0.40F}, first), {0.46F, 0.36F, 0.30F},
                   0.55F * second * second) *
             (0.82F + 0.34F * tone.part(7));
    case Stone::basalt:
      return mixed({0.070F, 0.072F, 0.078F}, {0.115F, 0.112F, 0.106F}, first) * (0.80F + 0.45F * second);
    case Stone::sandstone:
      return mixed(mixed({0.44F, 0.33F, 0.205F}, {0.37F, 0.31F, 0.235F}, first), {0.36F, 0.215F, 0.14F},
                   0.85F * second * second * std::sqrt(second)) *
             (0.82F + 0.34F * tone.part(7));
    case Stone::limestone:
      return mixed(mixed({0.50F, 0.445F, 0.36F}, {0.47F, 0.44F, 0.395F}, first), {0.42F, 0.355F, 0.26F},
                   0.8F * second * second) *
             (0.84F + 0.26F * tone.part(7));
    case Stone::brick:
      return mixed(mixed({0.34F, 0.125F, 0.070F}, {0.27F, 0.115F, 0.085F}, first), {0.40F, 0.22F, 0.12F},
                   0.6F * second * second * second) *
             (0.66F + 0.52F * tone.part(7));
  }
  return {};
}

// What the clouds of a material make of its colour.
Colour clouded(Stone material, const StoneLook& stone, const Place& place) {
  const Colour& own = stone.colour;
  switch (material) {
    case Stone::setts:
    case Stone::granite:
      return own;
    case Stone::basalt:
      return mixed(own, own * Colour{1.45F, 1.42F, 1.35F}, 0.5F * std::clamp(0.5F + 0.7F * place.cloud, 0.0F, 1.0F));
    case Stone::sandstone: {
      const double at = glm::dot(place.from_centre_mm, stone.beds_per_mm) + 0.30 * static_cast<double>(place.cloud) +
                        static_cast<double>(place.bend);
      return own * between_stops(beds, static_cast<float>(at - std::floor(at)));
    }
    case Stone::limestone: {
      const Colour base = own * (1.0F + 0.09F * std::clamp(place.cloud, -1.6F, 1.6F));
      // Veins run where the clouds, frayed by the grain, pass through 0.4.
      const float off = std::abs(place.cloud + 0.10F * place.grain - 0.4F);
      return mixed(stone.vein, base, std::clamp((off - 0.03F) / 0.06F, 0.0F, 1.0F));
    }
    case Stone::brick:
      return mixed(own, own * Colour{0.52F, 0.50F, 0.62F}, 0.62F * std::clamp(0.35F + 0.6F * place.cloud, 0.0F, 1.0F));
  }
  return own;
}

// Like has_plain_bed and the look of the bed there (export/povray/pavement_look.cpp), but for sand that nobody asked for: it is
// bare.
float moss_of(const paving::Look& look) {
  const bool grows = look.joint_fill && *look.joint_fill == paving::JointFill::sand;
  return static_cast<float>(look.moss.value_or(grows ? 0.25 : 0.0));
}

}  // namespace

namespace {

// IEC 61966-2-1.
float linear(double srgb) { return static_cast<float>(srgb <= 0.04045 ? srgb / 12.92 : power((srgb + 0.055) / 1.055, 2.4)); }

}  // namespace

Colour mixed(const Colour& a, const Colour& b, float part) {
  return {a.red + part * (b.red - a.red), a.green + part * (b.green - a.green), a.blue + part * (b.blue - a.blue)};
}

Palette::Palette(const paving::Look& look)
    : material_(look.material),
      mortar_(look.joint_fill && *look.joint_fill == paving::JointFill::mortar),
      moss_(moss_of(look)),
      damp_(static_cast<float>(std::min(1.0, 2.0 * look.wetness))) {
  for (const vec3& srgb : look.colours.colours) {
    own_.push_back({linear(srgb.x), linear(srgb.y), linear(srgb.z)});
  }
}

double Palette::mineral_mm() const { return traits(material_).mineral_mm; }
double Palette::cloud_mm() const { return traits(material_).cloud_mm; }

StoneLook Palette::stone(double colour, int own) const {
  const Tone tone{shapes::tone_of(colour)};
  StoneLook look;
  look.colour = own >= 0 ? own_.at(static_cast<std::size_t>(own)) : colour_of(material_, tone);
  look.roughness = traits(material_).roughness + rougher * static_cast<float>(colour);
  look.beds_per_mm = Angle::degrees(180.0 * tone.draw(4)).direction() / (16.0 + 34.0 * tone.draw(3));
  const float kind = tone.part(5);  // a third without veins, a third rusty, a third of white spar
  look.vein = kind < 0.33F ? look.colour : vein(look.colour, kind < 0.7F ? 0.0F : 1.0F);
  return look;
}

Colour Palette::vein(const Colour& stone, float spar) { return stone * mixed(rusty_vein, white_vein, spar); }

// Over the grey of a swatch: the tints of all tones stay below 1, and lighter minerals and polish below 1 as well, but for the
// glints of brick.
float Palette::brightest() const {
  float most = 0.0F;
  for (int tone = 0; tone < stone_tones; ++tone) {
    const Colour own = colour_of(material_, {tone});
    most = std::max({most, own.red, own.green, own.blue});
  }
  for (const Colour& own : own_) most = std::max({most, own.red, own.green, own.blue});
  constexpr float least = 0.4F;
  return std::max(least, most);
}

StoneLook Palette::swatch_stone(double side_mm) const {
  // Flat beds, about 33 mm apart.
  constexpr double bed_mm = 33.0;
  const float light = brightest();
  StoneLook look;
  look.colour = {light, light, light};
  look.roughness = traits(material_).roughness + rougher;
  look.beds_per_mm = vec2{std::round(side_mm / 500.0), std::round(side_mm / bed_mm)} / side_mm;
  look.vein = look.colour;
  return look;
}

Colour Palette::tint(const StoneLook& stone) const { return stone.colour * (1.0F / brightest()); }

float Palette::roughness_part(const StoneLook& stone) const {
  return stone.roughness / (traits(material_).roughness + rougher);
}

// Moss grows in patches, of which there are more the more of it there is: at 1 nine tenths of the ground.
float Palette::mossy(float patch) const {
  if (moss_ == 0.0F) return 0.0F;
  const float edge = (0.30F - 0.52F * moss_) / 0.17F;
  return std::clamp((patch - edge) / 0.4F + 0.5F, 0.0F, 1.0F);
}

Colour Palette::stone_colour(const StoneLook& stone, const Place& place) const {
  const Colour face = clouded(material_, stone, place) * between_stops(wear, place.relief) *
                      between_stops(traits(material_).minerals, place.grain);
  const float clean = std::clamp((place.rise - stained_below) / (clean_above - stained_below), 0.0F, 1.0F);
  Colour colour = clean < 1.0F ? mixed(stain, face, clean) : face;
  // On arrises and sides.
  const float reach = clean_above + 0.5F * moss_;
  const float green = mossy(place.patch) * std::clamp((reach - place.rise) / 0.3F, 0.0F, 1.0F);
  if (green > 0.0F) colour = mixed(colour, between_stops(moss, place.grain), green);
  return colour * (1.0F - wet_dark * damp_);
}

float Palette::stone_roughness(const StoneLook& stone, const Place& place) const {
  // Trodden granite shines a little, its pits and its edges do not.
  const float worn = 0.07F * std::clamp(place.relief, -2.0F, 2.0F) + 0.02F * std::clamp(place.grain, -2.0F, 2.0F);
  const float edge = 0.25F * std::clamp(1.0F - place.rise / clean_above, 0.0F, 1.0F);
  const float dry = std::clamp(stone.roughness - worn + edge, 0.05F, 1.0F);
  return dry + 0.8F * damp_ * (wet_roughness - dry);
}

Colour Palette::bed_colour(const BedPlace& place) const {
  const Colour bare = between_stops(mortar_ ? mortar : sand, place.grain);
  return mixed(bare, between_stops(moss, place.grain), mossy(place.patch)) * (1.0F - wet_dark * damp_);
}

float Palette::bed_roughness(const BedPlace& place) const {
  const float dry = std::clamp(0.93F + 0.02F * place.grain, 0.0F, 1.0F);
  return dry + 0.5F * damp_ * (wet_roughness - dry);
}

// By eye: a puddle on paving is some millimetres deep and not quite clear.
Colour Palette::under_water(const Colour& colour) { return colour * Colour{0.72F, 0.70F, 0.64F}; }

}  // namespace shatterpave::exporting::shapes
