#include "export/povray/stones.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>

#include "core/parallel.h"
#include "export/stone_relief.h"
#include "geometry/lattice.h"
#include "paving/stone_surface.h"
#include "relief/raster.h"

namespace shatterpave::exporting::povray {

namespace {

using geometry::BezierPatch;
using paving::StoneDraws;

// ---- the relief

struct ReliefImage {
  std::string png;
  double side_mm = 1.0;    // of the periodic image
  double bump_size = 0.0;  // range of the heights over the spacing of the pixels
};

ReliefImage relief_image(const paving::Pavement& pavement, std::uint64_t seed) {
  const relief::FractalSurface surface = stone_relief(pavement);
  ReliefImage image;
  image.side_mm = surface.spacing_mm * static_cast<double>(surface.size);
  if (pavement.relief.rms_mm == 0.0) return image;
  const relief::HeightImage heights = relief::height_image(stone_relief_heights(pavement, seed));
  image.bump_size = heights.range_mm / surface.spacing_mm;
  image.png = relief::encoded(heights.raster, relief::RasterFormat::png16);
  return image;
}

// ---- text, written by hand because there are megabytes of it

// `units` / 10^decimals, without trailing zeros.
void append_decimal(std::string& text, std::int64_t units, int decimals) {
  if (units < 0) {
    text += '-';
    units = -units;
  }
  std::int64_t scale = 1;
  for (int i = 0; i < decimals; ++i) scale *= 10;
  text += std::to_string(units / scale);
  std::int64_t rest = units % scale;
  if (rest == 0) return;
  text += '.';
  while (rest != 0) {
    scale /= 10;
    text += static_cast<char>('0' + rest / scale);
    rest %= scale;
  }
}

// Ours has z up, POV-Ray's y: the exchange of y and z also turns right-handed into left-handed.
void append_point(std::string& text, vec3 mm) {
  text += '<';
  append_decimal(text, geometry::to_lattice(mm.x), 3);
  text += ',';
  append_decimal(text, geometry::to_lattice(mm.z), 3);
  text += ',';
  append_decimal(text, geometry::to_lattice(mm.y), 3);
  text += '>';
}

// Five decimals of an image that is five stones wide: a two-hundredth of its pixel.
void append_texture_place(std::string& text, vec2 place) {
  text += '<';
  append_decimal(text, std::llround(place.x * 1e5), 5);
  text += ',';
  append_decimal(text, std::llround(place.y * 1e5), 5);
  text += '>';
}

void append_patch(std::string& text, const BezierPatch& patch, const std::array<vec2, 4>& texture_corners) {
  text += "bicubic_patch{type 0 flatness 0 u_steps K v_steps K uv_vectors";
  for (const vec2& corner : texture_corners) append_texture_place(text, corner);
  for (const vec3& point : patch.control_points) append_point(text, point);
  text += "}\n";
}

// ---- stones

int tone_of(const StoneDraws& draws) { return std::min(stone_tones - 1, static_cast<int>(draws.colour * stone_tones)); }

struct StoneText {
  int tone = 0;
  std::size_t patch_count = 0;
  std::string patches;
};

StoneText stone_text(const paving::Stone& stone, const StoneDraws& draws, double relief_side_mm) {
  StoneText result{tone_of(draws), 0, {}};
  const vec2 centre = geometry::centroid(stone.outline_mm);
  const auto texture_place = [&](const vec3& p) { return draws.relief_place + (vec2{p.x, p.y} - centre) / relief_side_mm; };
  for (const BezierPatch& patch : paving::surface_patches(stone.outline_mm, draws)) {
    const auto& points = patch.control_points;
    ++result.patch_count;
    append_patch(result.patches, patch,
                 {texture_place(points[0]), texture_place(points[3]), texture_place(points[15]), texture_place(points[12])});
  }
  return result;
}

std::vector<StoneText> stone_texts(const PavedArea& paved, std::uint64_t seed, double relief_side_mm) {
  const std::vector<paving::Stone>& stones = paved.layout.stones;
  std::vector<StoneText> texts(stones.size());
  parallel_for_chunks(stones.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      texts[i] = stone_text(stones[i], paving::stone_draws(paved.pavement, seed, stones[i].id), relief_side_mm);
    }
  });
  return texts;
}

// POV-Ray warns of a union of one object.
std::string_view group(std::size_t objects) { return objects == 1 ? "object" : "union"; }

// One group for each tone that has a stone. Where there is no stone at all, something that is not seen stands for them.
void append_stones(std::string& text, const std::string& prefix, std::span<const StoneText> stones) {
  std::array<std::size_t, stone_tones> patches{};
  for (const StoneText& stone : stones) patches[static_cast<std::size_t>(stone.tone)] += stone.patch_count;
  const auto groups = patches.size() - static_cast<std::size_t>(std::ranges::count(patches, 0U));
  text += fmt::format("#local K = {}_Steps;\n#declare {}_Stones =\n{} {{\n", prefix, prefix,
                      group(std::max<std::size_t>(groups, 1)));
  for (int tone = 0; tone < stone_tones; ++tone) {
    const std::size_t count = patches[static_cast<std::size_t>(tone)];
    if (count == 0) continue;
    text += fmt::format("{} {{\n", group(count));
    for (const StoneText& stone : stones) {
      if (stone.tone == tone) text += stone.patches;
    }
    text += fmt::format("{}_Stone_Texture({}) }}\n", prefix, (tone + 0.5) / stone_tones);
  }
  if (groups == 0) text += "sphere { 0, 1 no_image no_shadow no_reflection }\n";
  text += "}\n\n";
}

// ---- bed and bounds

// Thickness of the bed that is modelled, so that it can stand free. By eye: a twentieth of a metre of sand.
constexpr double bed_depth_mm = 50.0;

void append_ring(std::string& text, const geometry::Polygon& ring) {
  const auto append_vertex = [&](const vec2& vertex) {
    text += '<';
    append_decimal(text, geometry::to_lattice(vertex.x), 3);
    text += ',';
    append_decimal(text, geometry::to_lattice(vertex.y), 3);
    text += '>';
  };
  text += "   ";
  for (const vec2& vertex : ring) {
    append_vertex(vertex);
    text += ", ";
  }
  append_vertex(ring.front());
}

void append_bed(std::string& text, const std::string& prefix, const paving::Pavement& pavement) {
  std::size_t points = pavement.area.outline.size() + 1;
  for (const geometry::Polygon& hole : pavement.area.holes) points += hole.size() + 1;
  text += fmt::format("#declare {}_Bed =\nprism {{\n   linear_sweep linear_spline -{}, {}_Bed_Level, {},\n", prefix,
                      bed_depth_mm, prefix, points);
  append_ring(text, pavement.area.outline);
  for (const geometry::Polygon& hole : pavement.area.holes) {
    text += ",\n";
    append_ring(text, hole);
  }
  text += fmt::format("\n   {}_Bed_Texture()\n}}\n\n", prefix);
}

// The highest that any stone of the pavement can be.
double top_mm(const paving::StoneSurface& surface) { return 0.5625 * surface.height_mm * (1.0 + surface.height_spread); }

void append_bounds(std::string& text, const std::string& prefix, const paving::Pavement& pavement) {
  const geometry::Box box = geometry::bounding_box(pavement.area.outline);
  text += fmt::format("#declare {}_Bed_Level = {};\n#declare {}_Top = {};\n", prefix,
                      geometry::to_mm(geometry::to_lattice(paving::bed_level_mm(pavement.surface))), prefix,
                      geometry::to_mm(geometry::to_lattice(top_mm(pavement.surface))));
  text += fmt::format("#declare {}_Stone_Size = {};\n", prefix, geometry::to_mm(geometry::to_lattice(mean_size_mm(pavement))));
  text += fmt::format("#declare {}_Min = ", prefix);
  append_point(text, {box.low.x, box.low.y, -bed_depth_mm});
  text += fmt::format(";\n#declare {}_Max = ", prefix);
  append_point(text, {box.high.x, box.high.y, top_mm(pavement.surface)});
  text += ";\n\n";
}

// ---- the file

std::string header(const std::string& name, const std::string& prefix, std::size_t stones) {
  return fmt::format(
      R"(// Persistence of Vision Ray Tracer Include File
// File: {0}.inc
// Vers: 3.7
// Desc: Stone pavement "{0}": {2} stones on a bed of sand.
//       1 unit = 1 mm; y is up; the stones stand on the plane y = 0, within the outline of the pavement in x and z.
//
// Declares:
//    {1}_Pavement   stones and bed: object {{ {1}_Pavement }}
//    {1}_Stones     the stones alone, open below
//    {1}_Bed        the filling of the joints, a solid down to y = -50
//    {1}_Bed_Level  height of the filling
//    {1}_Top        height that no stone exceeds
//    {1}_Stone_Size root of the area of a whole stone's face
//    {1}_Min, {1}_Max  corners of the bounding box
// Reads, where they are declared before:
//    {1}_Steps      subdivisions of a patch as powers of two, 3 if not declared; 4 for close views
//    {1}_Relief     factor on the heights of the relief, 1 if not declared
//    {1}_Stone_Texture(Tone)  macro: the texture of the stones of one tone, Tone from 0 to 1
//    {1}_Bed_Texture()        macro: the texture of the filling

#ifndef({1}_Inc_Temp)
#declare {1}_Inc_Temp = version;
#version 3.7;

#include "shatterpave_stone.inc"

)",
      name, prefix, stones);
}

// Pattern and normal of the relief are declared once, so that POV-Ray reads the image once and not for every tone.
std::string settings(const std::string& prefix, const ReliefImage& relief, const std::string& image_name) {
  const std::string pattern =
      image_name.empty() ? "granite" : fmt::format("image_pattern {{ png \"{}\" gamma 1.0 interpolate 2 }}", image_name);
  const std::string normal =
      image_name.empty()
          ? "bumps 0"
          : fmt::format(
                "uv_mapping bump_map {{ png \"{}\" gamma 1.0 interpolate 2 bump_size {:.4f} * {}_Relief * Shatterpave_Bump }} "
                "transform {{ Shatterpave_Bump_Frame }}",
                image_name, relief.bump_size, prefix);
  return fmt::format(
      R"(#ifndef({0}_Steps) #declare {0}_Steps = 3; #end
#ifndef({0}_Relief) #declare {0}_Relief = 1; #end

// The heights of the relief, from 0 to 1 over the texture coordinates; 1 in those is {1} mm.
#declare {0}_Relief_Pattern = pigment {{ uv_mapping {2} }}
#declare {0}_Relief_Normal = normal {{ {3} }}

#ifndef({0}_Stone_Texture)
#macro {0}_Stone_Texture(Tone)
   Shatterpave_Stone(Tone, {0}_Top, {0}_Relief_Pattern, {0}_Relief_Normal, {1})
#end
#end

#ifndef({0}_Bed_Texture)
#macro {0}_Bed_Texture()
   Shatterpave_Sand({0}_Stone_Size)
#end
#end

)",
      prefix, relief.side_mm, pattern, normal);
}

}  // namespace

std::vector<OutputFile> pavement_files(const PavedArea& paved, const std::string& prefix, std::uint64_t seed) {
  const paving::Pavement& pavement = paved.pavement;
  const ReliefImage relief = relief_image(pavement, seed);
  const std::string image_name = relief.png.empty() ? "" : pavement.name + "_relief.png";
  const std::vector<StoneText> stones = stone_texts(paved, seed, relief.side_mm);

  std::size_t length = 8192;
  for (const StoneText& stone : stones) length += stone.patches.size();
  std::string text;
  text.reserve(length);
  text += header(pavement.name, prefix, stones.size());
  append_bounds(text, prefix, pavement);
  text += settings(prefix, relief, image_name);
  append_stones(text, prefix, stones);
  append_bed(text, prefix, pavement);
  text += fmt::format(
      "#declare {0}_Pavement =\nunion {{\n   object {{ {0}_Stones }}\n   object {{ {0}_Bed }}\n}}\n\n"
      "#version {0}_Inc_Temp;\n#end\n",
      prefix);

  std::vector<OutputFile> files;
  files.push_back({pavement.name + ".inc", std::move(text)});
  if (!relief.png.empty()) files.push_back({image_name, relief.png});
  return files;
}

}  // namespace shatterpave::exporting::povray
