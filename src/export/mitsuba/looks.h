// How Mitsuba is told what things are made of: its bsdfs, media and textures.
#pragma once

#include <string>
#include <vector>

#include "export/mitsuba/xml.h"
#include "export/shapes/bodies.h"

namespace shatterpave::exporting::mitsuba {

// Names of the media, and of the bsdf of cracks that are thinner than what rays of Mitsuba step over (scene_mitsuba.h).
inline constexpr const char* pane_medium = "glass";
inline constexpr const char* shard_medium = "glass_of_shards";
inline constexpr const char* film_bsdf = "glass_film";

// What is used of it all; only that is written. Bsdfs are called as their materials are.
class Looks {
 public:
  // `materials` must outlive this.
  explicit Looks(const shapes::Materials& materials) : materials_(materials), is_used_(materials.all.size(), false) {}

  // The number of a material, whose bsdf is used from now on.
  const std::string& use(std::size_t material) {
    is_used_[material] = true;
    return materials_.all[material].name;
  }
  void use_film() { uses_film_ = true; }
  void use_medium(bool of_shards) { (of_shards ? uses_shard_medium_ : uses_pane_medium_) = true; }
  // Whether light goes through anything.
  bool has_glass() const;

  // Adds the bsdfs and media to `xml`, and their pictures to `files`, as SCENE-NAME.jpg.
  void write(const std::string& scene, std::uint64_t seed, Xml& xml, std::vector<OutputFile>& files) const;

  // The pictures of a swatch that are in use: one base colour for each tint, since textures of Mitsuba cannot be multiplied.
  struct SwatchFiles {
    std::vector<shapes::Colour> tints;
    float roughness = 0.0F;  // sum over the materials
    std::size_t materials = 0;
  };

 private:
  void write_textured(const std::string& scene, const shapes::Material& look, std::vector<SwatchFiles>& used, Xml& xml) const;

  const shapes::Materials& materials_;
  std::vector<bool> is_used_;
  bool uses_film_ = false;
  bool uses_pane_medium_ = false;
  bool uses_shard_medium_ = false;
};

}  // namespace shatterpave::exporting::mitsuba
