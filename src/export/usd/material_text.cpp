#include "export/usd/material_text.h"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "export/shapes/optics.h"

namespace shatterpave::exporting::usd {

namespace {

using shapes::Substance;

// Of the standard_surface: what the renderer is to make the network with.
constexpr std::string_view material_x = "1.38";

constexpr double stone_ior = 1.5;  // of minerals, as UsdPreviewSurface has it by itself

// In a UsdPreviewSurface opacity is what does not go through. Where importers take it for what is there at all, as Blender's
// does, a face of glass then covers as much of what is behind it as a real one throws back.
double opacity(Substance substance) {
  switch (substance) {
    case Substance::glass:
    case Substance::broken_glass:
      return shapes::reflectance(shapes::glass_ior);
    case Substance::crushed_glass:
      return 0.5;  // by eye: powder throws half of the light back
    case Substance::water:
      return shapes::reflectance(shapes::water_ior);
    case Substance::stone:
    case Substance::joint:
      break;
  }
  return 1.0;
}

bool is_clear(Substance substance) { return substance != Substance::stone && substance != Substance::joint; }

double number(double value) { return static_cast<double>(in_parts(value, parts_of_one)) / parts_of_one; }

std::string colour_text(const shapes::Colour& colour) {
  return vector_text({static_cast<double>(colour.red), static_cast<double>(colour.green), static_cast<double>(colour.blue)},
                     parts_of_one);
}

double ior(Substance substance) {
  if (!is_clear(substance)) return stone_ior;
  return substance == Substance::water ? shapes::water_ior : shapes::glass_ior;
}

void put_preview(PrimText& text, const shapes::Material& material) {
  text.begin("def Shader", "preview");
  text.line("uniform token info:id = \"UsdPreviewSurface\"");
  text.line("color3f inputs:diffuseColor = {}", colour_text(material.colour));
  text.line("float inputs:ior = {}", ior(material.substance));
  text.line("float inputs:metallic = 0");
  if (is_clear(material.substance)) text.line("float inputs:opacity = {}", number(opacity(material.substance)));
  text.line("float inputs:roughness = {}", number(static_cast<double>(material.roughness)));
  text.line("token outputs:surface");
  text.end();
}

// ---- textures

// A picture, whose values are multiplied by `scale` and moved by `bias`.
struct Picture {
  std::string_view name;  // of the shader
  std::string_view file;
  std::string_view colour_space;
  std::string scale;
  std::string_view bias;
};

void put_picture(PrimText& text, const std::string& material, const Picture& picture,
                 const std::vector<std::string_view>& outputs) {
  text.begin("def Shader", picture.name);
  text.line("uniform token info:id = \"UsdUVTexture\"");
  if (!picture.bias.empty()) text.line("float4 inputs:bias = {}", picture.bias);
  text.line("asset inputs:file = {}", asset(picture.file));
  text.line("float4 inputs:scale = {}", picture.scale);
  text.line("token inputs:sourceColorSpace = {}", in_usd_quotes(picture.colour_space));
  text.line("float2 inputs:st.connect = <{}/places.outputs:result>", material);
  text.line("token inputs:wrapS = \"repeat\"");
  text.line("token inputs:wrapT = \"repeat\"");
  for (const std::string_view output : outputs) text.line("{}", output);
  text.end();
}

// Places in textures are in metres, and are divided by the side of the swatch here.
void put_places(PrimText& text, const std::string& material, double side_m) {
  text.begin("def Shader", "metres");
  text.line("uniform token info:id = \"UsdPrimvarReader_float2\"");
  text.line("string inputs:varname = \"st\"");
  text.line("float2 outputs:result");
  text.end();
  text.begin("def Shader", "places");
  text.line("uniform token info:id = \"UsdTransform2d\"");
  text.line("float2 inputs:in.connect = <{}/metres.outputs:result>", material);
  text.line("float2 inputs:scale = ({0}, {0})", 1.0 / side_m);
  text.line("float2 outputs:result");
  text.end();
}

void put_textured(PrimText& text, const std::string& own, const shapes::SwatchUse& use, const SwatchFiles& swatch) {
  text.begin("def Shader", "preview");
  text.line("uniform token info:id = \"UsdPreviewSurface\"");
  text.line("color3f inputs:diffuseColor.connect = <{}/base_color.outputs:rgb>", own);
  text.line("float inputs:ior = {}", stone_ior);
  text.line("float inputs:metallic = 0");
  text.line("normal3f inputs:normal.connect = <{}/normal.outputs:rgb>", own);
  text.line("float inputs:occlusion.connect = <{}/surface.outputs:r>", own);
  text.line("float inputs:roughness.connect = <{}/surface.outputs:g>", own);
  text.line("token outputs:surface");
  text.end();
  put_places(text, own, swatch.side_m);
  const shapes::Colour& tint = use.tint;
  put_picture(text, own,
              {"base_color", swatch.base_color, "sRGB",
               fmt::format("({}, {}, {}, 1)", number(static_cast<double>(tint.red)), number(static_cast<double>(tint.green)),
                           number(static_cast<double>(tint.blue))),
               ""},
              {"float3 outputs:rgb"});
  put_picture(text, own, {"normal", swatch.normal, "raw", "(2, 2, 2, 1)", "(-1, -1, -1, 0)"}, {"float3 outputs:rgb"});
  put_picture(text, own,
              {"surface", swatch.occlusion_roughness_metallic, "raw",
               fmt::format("(1, {}, 1, 1)", number(static_cast<double>(use.roughness))), ""},
              {"float outputs:r", "float outputs:g"});
}

void put_dielectric(PrimText& text, const shapes::Material& material) {
  const auto& colour = shapes::attenuation_colour;
  text.begin("def Shader", "dielectric");
  text.line("uniform token info:id = \"ND_standard_surface_surfaceshader\"");
  text.line("float inputs:base = 0");
  text.line("float inputs:metalness = 0");
  text.line("float inputs:specular = 1");
  text.line("float inputs:specular_IOR = {}", ior(material.substance));
  text.line("float inputs:specular_roughness = {}", number(static_cast<double>(material.roughness)));
  text.line("float inputs:transmission = 1");
  text.line("color3f inputs:transmission_color = {}", vector_text({colour[0], colour[1], colour[2]}, parts_of_one));
  text.line("float inputs:transmission_depth = {}", shapes::attenuation_m);
  text.line("token outputs:out");
  text.end();
}

}  // namespace

void put_material(PrimText& text, const std::string& path, const shapes::Material& material, const SwatchFiles* swatch) {
  const std::string own = fmt::format("{}/{}", path, material.name);
  const bool clear = is_clear(material.substance);
  if (clear) {
    text.begin("def Material", material.name, {"prepend apiSchemas = [\"MaterialXConfigAPI\"]"});
    text.line("string config:mtlx:version = {}", in_usd_quotes(material_x));
    text.line("token outputs:mtlx:surface.connect = <{}/dielectric.outputs:out>", own);
  } else {
    text.begin("def Material", material.name);
  }
  text.line("token outputs:surface.connect = <{}/preview.outputs:surface>", own);
  if (swatch != nullptr && material.swatch) {
    put_textured(text, own, *material.swatch, *swatch);
  } else {
    put_preview(text, material);
  }
  if (clear) put_dielectric(text, material);
  text.end();
}

}  // namespace shatterpave::exporting::usd
