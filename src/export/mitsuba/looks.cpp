#include "export/mitsuba/looks.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/parallel.h"
#include "export/shapes/optics.h"
#include "export/swatches/swatches.h"

namespace shatterpave::exporting::mitsuba {

namespace {

using shapes::Colour;
using shapes::Substance;

// Mitsuba's own is that of air.
constexpr double air_ior = 1.0;

// What a metre of glass takes of the light, as its negative logarithm: that of Shatterpave_Glass (templates/includes/
// shatterpave_glass.inc) and of Shatterpave_Shard_Interior (shatterpave_shards.inc), where light falls to exp(−(1 −
// fade_color)) within fade_distance.
constexpr double of_pane_per_m[] = {0.25 / 0.060, 0.08 / 0.060, 0.16 / 0.060};
constexpr double of_shard_per_m[] = {0.34 / 0.024, 0.10 / 0.024, 0.20 / 0.024};

bool is_transparent(Substance substance) {
  switch (substance) {
    case Substance::glass:
    case Substance::broken_glass:
    case Substance::crushed_glass:
    case Substance::water:
      return true;
    case Substance::stone:
    case Substance::joint:
      return false;
  }
  return false;
}

void write_medium(Xml& xml, const char* id, const double (&per_m)[3]) {
  xml.open("medium", {{"type", "homogeneous"}, {"id", id}});
  xml.value("float", "albedo", "0");
  // Colours of media are 0 … 1, times a scale.
  const double scale = std::max({per_m[0], per_m[1], per_m[2]});
  xml.value("rgb", "sigma_t", numbers(vec3{per_m[0], per_m[1], per_m[2]} / scale));
  xml.value("float", "scale", number(scale));
  xml.close();
}

void write_dielectric(Xml& xml, const shapes::Material& look, double ior) {
  // Roughness as glTF and others mean it is the root of what a microfacet distribution calls alpha.
  const double alpha = static_cast<double>(look.roughness) * static_cast<double>(look.roughness);
  // By eye: a face that scatters less looks smooth, and smooth ones converge sooner.
  constexpr double smooth = 0.001;
  xml.open("bsdf", {{"type", alpha > smooth ? "roughdielectric" : "dielectric"}, {"id", look.name}});
  xml.value("float", "int_ior", number(ior));
  xml.value("float", "ext_ior", number(air_ior));
  if (alpha > smooth) {
    xml.value("string", "distribution", "ggx");
    xml.value("float", "alpha", number(alpha));
  }
  xml.close();
}

// By eye, as in the POV-Ray target: powder of glass is white, and lets a part of the light through between its grains.
constexpr const char* powder_opacity = "0.6";
constexpr const char* powder_colour = "0.94, 0.97, 0.98";

void write_powder(Xml& xml, const shapes::Material& look) {
  xml.open("bsdf", {{"type", "mask"}, {"id", look.name}});
  xml.value("float", "opacity", powder_opacity);
  xml.open("bsdf", {{"type", "principledthin"}});
  xml.value("rgb", "base_color", powder_colour);
  xml.value("float", "roughness", number(static_cast<double>(look.roughness)));
  xml.value("float", "diff_trans", "1");  // of 2: as much is thrown back as goes on
  xml.close();
  xml.close();
}

// A layer of air in glass.
void write_film(Xml& xml) {
  xml.open("bsdf", {{"type", "thindielectric"}, {"id", film_bsdf}});
  xml.value("float", "int_ior", number(air_ior));
  xml.value("float", "ext_ior", number(shapes::glass_ior));
  xml.close();
}

// ---- stones

std::string file_stem(const std::string& scene, const shapes::Swatch& swatch) { return scene + "-" + swatch.name; }
std::string colour_stem(const std::string& stem, std::size_t tint) { return fmt::format("{}-{}_BaseColor", stem, tint); }
std::string file_name(const std::string& stem) { return stem + ".jpg"; }

void write_picture(Xml& xml, const char* name, const std::string& file, bool is_data, double side_m) {
  if (is_data) {
    xml.open("texture", {{"type", "bitmap"}, {"name", name}});
    xml.value("boolean", "raw", "true");
  } else {
    xml.open("texture", {{"type", "bitmap"}, {"name", name}});
  }
  xml.value("string", "filename", file);
  // Places are in metres, v up; rows of a picture run down.
  xml.open("transform", {{"name", "to_uv"}});
  xml.leaf("scale", {{"x", number(1.0 / side_m)}, {"y", number(-1.0 / side_m)}});
  xml.close();
  xml.close();
}

// `stem` and `tint` of its pictures; without a swatch null.
void write_principled(Xml& xml, const shapes::Material& look, const shapes::Swatch* swatch, const std::string& stem,
                      std::size_t tint) {
  xml.open("bsdf", {{"type", "twosided"}, {"id", look.name}});
  if (swatch != nullptr) {
    xml.open("bsdf", {{"type", "normalmap"}});
    write_picture(xml, "normalmap", file_name(stem + "_Normal"), true, swatch->side_m);
  }
  xml.open("bsdf", {{"type", "principled"}});
  if (swatch != nullptr) {
    write_picture(xml, "base_color", file_name(colour_stem(stem, tint)), false, swatch->side_m);
    write_picture(xml, "roughness", file_name(stem + "_Roughness"), true, swatch->side_m);
  } else {
    xml.value("rgb", "base_color", numbers(look.colour));
    xml.value("float", "roughness", number(static_cast<double>(look.roughness)));
  }
  xml.close();
  if (swatch != nullptr) xml.close();
  xml.close();
}

// What a principled bsdf is rough by.
relief::Raster roughness_of(const relief::Raster& occlusion_roughness_metallic, float factor) {
  relief::Raster made{occlusion_roughness_metallic.width, occlusion_roughness_metallic.height, 1, {}};
  made.values.reserve(made.width * made.height);
  for (std::size_t i = 1; i < occlusion_roughness_metallic.values.size(); i += occlusion_roughness_metallic.channels) {
    made.values.push_back(std::clamp(factor * occlusion_roughness_metallic.values[i], 0.0F, 1.0F));
  }
  return made;
}

void append_pictures(const shapes::Swatch& swatch, const Looks::SwatchFiles& used, const std::string& stem, std::uint64_t seed,
                     std::vector<OutputFile>& files) {
  const swatches::Pictures pictures = swatches::drawn(swatch, seed);
  std::vector<swatches::PictureFile> made(used.tints.size() + 2);
  parallel_for(made.size(), [&](std::size_t i) {
    if (i < used.tints.size()) {
      made[i] = swatches::colour_file(swatches::tinted(pictures.base_color, used.tints[i]), colour_stem(stem, i));
    } else if (i == used.tints.size()) {
      made[i] = swatches::data_file(pictures.normal, stem + "_Normal");
    } else {
      made[i] = swatches::data_file(
          roughness_of(pictures.occlusion_roughness_metallic, used.roughness / static_cast<float>(used.materials)),
          stem + "_Roughness");
    }
  });
  for (swatches::PictureFile& file : made) files.push_back({std::move(file.name), std::move(file.bytes)});
}

}  // namespace

bool Looks::has_glass() const {
  for (std::size_t i = 0; i < is_used_.size(); ++i) {
    if (is_used_[i] && is_transparent(materials_.all[i].substance)) return true;
  }
  return uses_film_;
}

void Looks::write_textured(const std::string& scene, const shapes::Material& look, std::vector<SwatchFiles>& used,
                           Xml& xml) const {
  const shapes::Swatch& swatch = materials_.swatches[look.swatch->swatch];
  SwatchFiles& pictures = used[look.swatch->swatch];
  const auto known = std::ranges::find(pictures.tints, look.swatch->tint);
  const auto tint = static_cast<std::size_t>(known - pictures.tints.begin());
  if (known == pictures.tints.end()) pictures.tints.push_back(look.swatch->tint);
  pictures.roughness += look.swatch->roughness;
  ++pictures.materials;
  write_principled(xml, look, &swatch, file_stem(scene, swatch), tint);
}

void Looks::write(const std::string& scene, std::uint64_t seed, Xml& xml, std::vector<OutputFile>& files) const {
  if (uses_pane_medium_) write_medium(xml, pane_medium, of_pane_per_m);
  if (uses_shard_medium_) write_medium(xml, shard_medium, of_shard_per_m);
  if (uses_film_) write_film(xml);
  std::vector<SwatchFiles> used(materials_.swatches.size());
  for (std::size_t i = 0; i < is_used_.size(); ++i) {
    if (!is_used_[i]) continue;
    const shapes::Material& look = materials_.all[i];
    if (look.substance == Substance::crushed_glass) {
      write_powder(xml, look);
    } else if (is_transparent(look.substance)) {
      write_dielectric(xml, look, look.substance == Substance::water ? shapes::water_ior : shapes::glass_ior);
    } else if (!look.swatch) {
      write_principled(xml, look, nullptr, {}, 0);
    } else {
      write_textured(scene, look, used, xml);
    }
  }
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (used[i].materials == 0) continue;
    append_pictures(materials_.swatches[i], used[i], file_stem(scene, materials_.swatches[i]), seed, files);
  }
}

}  // namespace shatterpave::exporting::mitsuba
