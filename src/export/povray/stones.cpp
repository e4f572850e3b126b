#include "export/povray/stones.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <string_view>

#include "export/povray/pavement_ground.h"
#include "export/povray/pavement_look.h"
#include "export/povray/stone_text.h"
#include "export/shapes/stone_relief.h"
#include "export/shapes/tones.h"
#include "relief/raster.h"

namespace shatterpave::exporting::povray {

namespace {

// ---- the relief

struct ReliefImage {
  std::string png;
  double side_mm = 1.0;    // of the periodic image
  double bump_size = 0.0;  // range of the heights over the spacing of the pixels
};

// Where stones differ in wear, or have their relief as geometry.
bool has_many_normals(const paving::Pavement& pavement) {
  return pavement.body.wear_mm > 0.0 || (pavement.detail && pavement.detail->close_mm > 0.0);
}

// `field` is given the heights.
ReliefImage relief_image(const paving::Pavement& pavement, std::uint64_t seed, relief::HeightField& field) {
  const relief::FractalSurface surface = shapes::stone_relief(pavement);
  ReliefImage image;
  image.side_mm = surface.spacing_mm * static_cast<double>(surface.size);
  if (pavement.relief.rms_mm == 0.0) return image;
  field = shapes::stone_relief_heights(pavement, seed);
  const relief::HeightImage heights = relief::height_image(field);
  image.bump_size = heights.range_mm / surface.spacing_mm;
  image.png = relief::encoded(heights.raster, relief::RasterFormat::png16);
  return image;
}

// ---- stones

// POV-Ray warns of a union of one object.
std::string_view group(std::size_t objects) { return objects == 1 ? "object" : "union"; }

// The stones that share a texture.
struct Group {
  int tone = 0;
  int wear = 0;
  bool displaced = false;

  bool holds(const StoneText& stone) const { return stone.tone == tone && stone.wear == wear && stone.displaced == displaced; }
};

// One mesh of all far stones of the group; nothing where there are none.
std::string far_mesh(std::span<const StoneText> stones, const Group& group) {
  std::string vertices;
  std::string places;
  std::string faces;
  std::size_t vertex_count = 0;
  std::size_t face_count = 0;
  for (const StoneText& stone : stones) {
    if (!group.holds(stone) || stone.vertex_count == 0) continue;
    vertices += stone.vertices;
    places += stone.places;
    const auto index = [&](std::size_t i) { return stone.triangles[i] + vertex_count; };
    for (std::size_t i = 0; i < stone.triangles.size(); i += 3) {
      faces += fmt::format("<{},{},{}>", index(i), index(i + 2), index(i + 1));
    }
    face_count += stone.triangles.size() / 3;
    vertex_count += stone.vertex_count;
  }
  if (vertex_count == 0) return {};
  return fmt::format("mesh2{{vertex_vectors{{{},{}}}\nuv_vectors{{{},{}}}\nface_indices{{{},{}}}}}\n", vertex_count, vertices,
                     vertex_count, places, face_count, faces);
}

// The number of the normal in PREFIX_Relief_Normals: by wear, and last the one for stones whose relief is geometry.
int normal_of(const Group& group) { return group.displaced ? wear_classes : group.wear; }

void append_group(std::string& text, const std::string& prefix, std::span<const StoneText> stones, const Group& group,
                  bool many_normals) {
  const std::string far = far_mesh(stones, group);
  std::size_t count = far.empty() ? 0 : 1;
  for (const StoneText& stone : stones) {
    if (group.holds(stone)) count += stone.objects;
  }
  text += fmt::format("{} {{\n", povray::group(count));
  for (const StoneText& stone : stones) {
    if (group.holds(stone)) text += stone.text;
  }
  text += far;
  if (many_normals) text += fmt::format("#declare {0}_Relief_Normal = {0}_Relief_Normals[{1}]\n", prefix, normal_of(group));
  text += fmt::format("{}_Stone_Texture({}) }}\n", prefix, shapes::colour_of(group.tone));
}

// One group for each tone, wear and kind that has a stone. Where there is no stone at all, something that is not seen stands
// for them.
void append_stones(std::string& text, const std::string& prefix, const std::string& place, std::span<const StoneText> stones,
                   bool many_normals) {
  std::vector<Group> groups;
  int tones = 0;
  for (const StoneText& stone : stones) tones = std::max(tones, stone.tone + 1);
  for (int tone = 0; tone < tones; ++tone) {
    for (int wear = 0; wear < wear_classes; ++wear) {
      for (const bool displaced : {false, true}) {
        const Group group{tone, wear, displaced};
        if (std::ranges::any_of(stones, [&](const StoneText& stone) { return group.holds(stone); })) groups.push_back(group);
      }
    }
  }
  text += fmt::format("#local K = {}_Steps;\n#declare {}_Stones =\n{} {{\n", prefix, prefix,
                      group(std::max<std::size_t>(groups.size(), 1)));
  for (const Group& group : groups) append_group(text, prefix, stones, group, many_normals);
  if (groups.empty()) text += "sphere { 0, 1 no_image no_shadow no_reflection }\n";
  text += place + "}\n\n";
}

// ---- the file

std::string header(const std::string& stem, const std::string& prefix, std::size_t stones, const paving::Pavement& pavement) {
  return fmt::format(
      R"(// Persistence of Vision Ray Tracer Include File
// File: {0}.inc
// Vers: 3.7
// Desc: Stone pavement "{6}": {2} stones on a bed of sand.
//       1 unit = 1 mm; y is up; the stones stand on the plane y = 0, within the outline of the pavement in x and z.
//
// Declares:
//    {1}_Pavement   stones and bed: object {{ {1}_Pavement }}
//    {1}_Stones     the stones alone, open below
//    {1}_Bed        the filling of the joints, a solid down to y = -{5}
{3}//    {1}_Bed_Level  height of the filling
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
{4}
)",
      stem, prefix, stones,
      pavement.look.wetness > 0.5 ? fmt::format("//    {}_Water      what stands in the low spots, a solid\n", prefix) : "",
      uses_materials(pavement) ? "#include \"shatterpave_materials.inc\"\n" : "", pavement.ground.depth_mm, pavement.name);
}

// Pattern and normal of the relief are declared once, so that POV-Ray reads the image once and not for every tone.
std::string settings(const std::string& prefix, const ReliefImage& relief, const std::string& image_name,
                     const paving::Pavement& pavement) {
  const std::string pattern =
      image_name.empty() ? "granite" : fmt::format("image_pattern {{ png \"{}\" gamma 1.0 interpolate 2 }}", image_name);
  const auto normal = [&](const std::string& factor) {
    if (image_name.empty()) return std::string("bumps 0");
    return fmt::format(
        "uv_mapping bump_map {{ png \"{}\" gamma 1.0 interpolate 2 bump_size {:.4f} * {}_Relief * Shatterpave_Bump{} }} "
        "transform {{ Shatterpave_Bump_Frame }}",
        image_name, relief.bump_size, prefix, factor);
  };
  std::string text = fmt::format(
      R"(#ifndef({0}_Steps) #declare {0}_Steps = 3; #end
#ifndef({0}_Relief) #declare {0}_Relief = 1; #end

// The heights of the relief, from 0 to 1 over the texture coordinates; 1 in those is {1} mm.
#declare {0}_Relief_Pattern = pigment {{ uv_mapping {2} }}
#declare {0}_Relief_Normal = normal {{ {3} }}
)",
      prefix, relief.side_mm, pattern, normal(""));
  if (has_many_normals(pavement)) {
    text += "// By wear, and last for stones that have the relief as geometry: what is finer than their triangles.\n";
    text += fmt::format("#declare {}_Relief_Normals = array[{}] {{\n", prefix, wear_classes + 1);
    for (int wear = 0; wear < wear_classes; ++wear) {
      text += fmt::format("   normal {{ {} }}\n", normal(fmt::format(" * {:.4f}", relief_of_wear(wear))));
    }
    text += fmt::format("   normal {{ {} }}\n}}\n", normal(" * 0.35"));
  }
  return text + "\n" + texture_macros(pavement, prefix, relief.side_mm);
}

}  // namespace

std::vector<OutputFile> pavement_files(const PavedArea& paved, const std::string& prefix, std::uint64_t seed) {
  const paving::Pavement& pavement = paved.pavement;
  relief::HeightField field;
  const ReliefImage relief = relief_image(pavement, seed, field);
  const std::string image_name = relief.png.empty() ? "" : stem_of(paved) + "_relief.png";
  const std::vector<StoneText> stones = stone_texts(paved, seed, relief.side_mm, field.heights_mm.empty() ? nullptr : &field);
  const std::string place = ground_transform(pavement);

  std::size_t length = 8192;
  for (const StoneText& stone : stones) length += stone.text.size() + 2 * stone.vertices.size();
  std::string text;
  text.reserve(length);
  text += header(stem_of(paved), prefix, stones.size(), pavement);
  append_bounds(text, prefix, pavement, shapes::mean_size_mm(pavement));
  text += settings(prefix, relief, image_name, pavement);
  append_stones(text, prefix, place, stones, has_many_normals(pavement));
  append_bed(text, prefix, pavement, seed);
  const std::string water = water_text(pavement, prefix, stones);
  text += water;
  text += fmt::format("#declare {0}_Pavement =\nunion {{\n   object {{ {0}_Stones }}\n   object {{ {0}_Bed }}\n{1}}}\n\n",
                      prefix, water.empty() ? "" : fmt::format("   object {{ {}_Water }}\n", prefix));
  text += fmt::format("#version {}_Inc_Temp;\n#end\n", prefix);

  std::vector<OutputFile> files;
  files.push_back({stem_of(paved) + ".inc", std::move(text)});
  if (!relief.png.empty()) files.push_back({image_name, relief.png});
  return files;
}

}  // namespace shatterpave::exporting::povray
