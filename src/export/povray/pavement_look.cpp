#include "export/povray/pavement_look.h"

#include <fmt/format.h>

#include <string_view>

#include "export/shapes/palette.h"

namespace shatterpave::exporting::povray {

namespace {

using paving::Material;

std::string_view macro_of(Material material) {
  switch (material) {
    case Material::granite:
      return "Granite";
    case Material::basalt:
      return "Basalt";
    case Material::sandstone:
      return "Sandstone";
    case Material::limestone:
      return "Limestone";
    case Material::brick:
      return "Brick";
    case Material::setts:
      break;
  }
  return "Setts";
}

// What a material makes of the colour of a stone where it is worn and where it is light, and how its relief is worn: as in
// templates/includes/shatterpave_materials.inc.
struct Shading {
  std::string_view worn;
  double light = 1.0;
  double polish = 0.2;
};

Shading shading_of(Material material) {
  switch (material) {
    case Material::granite:
      return {"<0.70, 0.67, 0.62>", 1.10, 0.20};
    case Material::basalt:
      return {"<0.72, 0.68, 0.62>", 1.30, 0.26};
    case Material::sandstone:
      return {"<0.70, 0.66, 0.60>", 1.10, 0.06};
    case Material::limestone:
      return {"<0.74, 0.71, 0.66>", 1.06, 0.12};
    case Material::brick:
      return {"<0.72, 0.70, 0.68>", 1.12, 0.05};
    case Material::setts:
      break;
  }
  return {"<0.62, 0.58, 0.52>", 1.22, 0.22};
}

// Whole parts of a tone are the numbers of the user's own colours.
std::string own_texture(const paving::Pavement& pavement, const std::string& prefix, double side_mm) {
  const paving::Look& look = pavement.look;
  const Shading shading = shading_of(look.material);
  const auto& colours = look.colours.colours;
  std::string text = fmt::format("   #local Own = array[{}] {{ ", colours.size());
  const shapes::Palette palette(look);
  for (int k = 0; k < static_cast<int>(colours.size()); ++k) {
    const shapes::Colour colour = palette.stone(0.0, k).colour;
    text += fmt::format("{}rgb <{:.5f}, {:.5f}, {:.5f}>", k == 0 ? "" : ", ", colour.red, colour.green, colour.blue);
  }
  text += " }\n";
  text += fmt::format(
      "   #local Of_Stone = mod(Tone, 1);\n"
      "   #local C = Shatterpave_Wetted(Own[floor(Tone)], {0});\n"
      "   Shatterpave_Finished(Shatterpave_{1}_Pigment(C * {2}, {3}, Of_Stone), Shatterpave_{1}_Pigment(C, {3}, Of_Stone),\n"
      "      Shatterpave_{1}_Pigment(C * {4}, {3}, Of_Stone), {5}_Relief_Pattern, {5}_Relief_Normal, {0}, {6}, {7}, "
      "{5}_Bed_Level, {5}_Top)\n",
      look.wetness, macro_of(look.material), shading.worn, side_mm, shading.light, prefix, look.moss.value_or(0.0),
      shading.polish);
  return text;
}

bool has_plain_stones(const paving::Pavement& pavement) {
  const paving::Look& look = pavement.look;
  if (!look.colours.colours.empty()) return false;
  return look.material == Material::setts && pavement.body.finish == paving::Finish::none && look.wetness == 0.0 && !look.moss;
}

bool has_plain_bed(const paving::Look& look) { return !look.joint_fill && !look.moss && look.wetness == 0.0; }

std::string stone_texture(const paving::Pavement& pavement, const std::string& prefix, double side_mm) {
  const paving::Look& look = pavement.look;
  if (!look.colours.colours.empty()) return own_texture(pavement, prefix, side_mm);
  if (has_plain_stones(pavement)) {
    return fmt::format("   Shatterpave_Stone(Tone, {0}_Top, {0}_Relief_Pattern, {0}_Relief_Normal, {1})\n", prefix, side_mm);
  }
  return fmt::format("   Shatterpave_{1}(Tone, {0}_Bed_Level, {0}_Top, {0}_Relief_Pattern, {0}_Relief_Normal, {2}, {3}, {4})\n",
                     prefix, macro_of(look.material), side_mm, look.wetness, look.moss.value_or(0.0));
}

std::string bed_texture(const paving::Pavement& pavement, const std::string& prefix) {
  const paving::Look& look = pavement.look;
  if (has_plain_bed(look)) return fmt::format("   Shatterpave_Sand({}_Stone_Size)\n", prefix);
  const bool mortar = look.joint_fill == paving::JointFill::mortar;
  return fmt::format("   Shatterpave_Joint_{}({}_Stone_Size, {}, {})\n", mortar ? "Mortar" : "Sand", prefix, look.wetness,
                     look.moss.value_or(mortar ? 0.0 : 0.25));
}

}  // namespace

bool uses_materials(const paving::Pavement& pavement) { return !has_plain_stones(pavement) || !has_plain_bed(pavement.look); }

std::string texture_macros(const paving::Pavement& pavement, const std::string& prefix, double relief_side_mm) {
  return fmt::format(
      R"(#ifndef({0}_Stone_Texture)
#macro {0}_Stone_Texture(Tone)
{1}#end
#end

#ifndef({0}_Bed_Texture)
#macro {0}_Bed_Texture()
{2}#end
#end

)",
      prefix, stone_texture(pavement, prefix, relief_side_mm), bed_texture(pavement, prefix));
}

}  // namespace shatterpave::exporting::povray
