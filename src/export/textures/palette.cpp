#include "export/textures/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "export/povray/stone_text.h"

namespace shatterpave::exporting::textures {

namespace {

// The quarry of templates/shatterpave_stone.inc: greys from cold to warm, some of them rusty. By eye, after granite setts.
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

// Feldspar, quartz and mica about the colour of the stone: over the grain.
constexpr std::array<Stop, 6> minerals = {{{-1.8F, {0.45F, 0.45F, 0.45F}},
                                           {-0.9F, {0.80F, 0.80F, 0.80F}},
                                           {-0.1F, {1.0F, 1.0F, 1.0F}},
                                           {0.6F, {1.12F, 1.12F, 1.12F}},
                                           {1.4F, {1.45F, 1.45F, 1.45F}},
                                           {2.4F, {1.70F, 1.70F, 1.70F}}}};

// Dirt stays in the pits, and feet polish what stands out: over the relief.
constexpr std::array<Stop, 3> wear = {
    {{-2.5F, {0.62F, 0.58F, 0.52F}}, {-0.2F, {1.0F, 1.0F, 1.0F}}, {2.7F, {1.22F, 1.22F, 1.22F}}}};

constexpr Colour stain{0.105F, 0.088F, 0.068F};
constexpr float stained_below = 0.08F;
constexpr float clean_above = 0.36F;

constexpr std::array<Stop, 2> sand = {{{-2.0F, {0.045F, 0.038F, 0.029F}}, {2.0F, {0.205F, 0.172F, 0.130F}}}};

Colour between_stops(std::span<const Stop> stops, float at) {
  if (at <= stops.front().at) return stops.front().colour;
  for (std::size_t k = 1; k < stops.size(); ++k) {
    if (at > stops[k].at) continue;
    return mixed(stops[k - 1].colour, stops[k].colour, (at - stops[k - 1].at) / (stops[k].at - stops[k - 1].at));
  }
  return stops.back().colour;
}

}  // namespace

Colour mixed(const Colour& a, const Colour& b, float part) {
  return {a.red + part * (b.red - a.red), a.green + part * (b.green - a.green), a.blue + part * (b.blue - a.blue)};
}

Colour stone_colour(double colour) {
  // The middle of the tone, as the POV-Ray target has it, and then what its template makes of that.
  const double tone = (std::floor(colour * povray::stone_tones) + 0.5) / povray::stone_tones;
  const auto step = static_cast<std::size_t>(tone * 21.0);
  const double light = 0.98 + 0.44 * static_cast<double>(step * 5 % 21) / 20.0;
  return quarry.at(step * 3 % quarry.size()) * static_cast<float>(light);
}

Colour stone_colour_at(const Colour& stone, const Place& place) {
  const Colour face = stone * between_stops(wear, place.relief) * between_stops(minerals, place.grain);
  const float clean = std::clamp((place.rise - stained_below) / (clean_above - stained_below), 0.0F, 1.0F);
  return clean < 1.0F ? mixed(stain, face, clean) : face;
}

Colour bed_colour(float grain) { return between_stops(sand, grain); }

float stone_roughness(double colour, const Place& place) {
  // By eye: trodden granite shines a little, its pits and its edges do not.
  const float own = 0.56F + 0.12F * static_cast<float>(colour);
  const float worn = 0.07F * std::clamp(place.relief, -2.0F, 2.0F) + 0.02F * std::clamp(place.grain, -2.0F, 2.0F);
  const float edge = 0.25F * std::clamp(1.0F - place.rise / clean_above, 0.0F, 1.0F);
  return std::clamp(own - worn + edge, 0.05F, 1.0F);
}

float bed_roughness(float grain) { return std::clamp(0.93F + 0.02F * grain, 0.0F, 1.0F); }

}  // namespace shatterpave::exporting::textures
