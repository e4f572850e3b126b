#include "export/povray/pavement_look.h"

#include <fmt/format.h>

#include <string_view>

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

bool has_plain_stones(const paving::Pavement& pavement) {
  const paving::Look& look = pavement.look;
  return look.material == Material::setts && pavement.body.finish == paving::Finish::none && look.wetness == 0.0 && !look.moss;
}

bool has_plain_bed(const paving::Look& look) { return !look.joint_fill && !look.moss && look.wetness == 0.0; }

std::string stone_texture(const paving::Pavement& pavement, const std::string& prefix, double side_mm) {
  const paving::Look& look = pavement.look;
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
