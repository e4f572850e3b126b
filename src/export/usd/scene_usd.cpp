#include "export/usd/scene_usd.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "core/error.h"
#include "core/parallel.h"
#include "export/shapes/stage.h"
#include "export/swatches/environment.h"
#include "export/swatches/swatches.h"
#include "export/usd/element_text.h"
#include "export/usd/material_text.h"
#include "export/usd/prim_text.h"
#include "export/usd/stage_text.h"

namespace shatterpave::exporting::usd {

namespace {

constexpr std::size_t bodies_at_once = 512;

class Writer {
 public:
  explicit Writer(const Model& model)
      : model_(model),
        materials_(shapes::materials_of(model)),
        root_(root_name(model.name)),
        swatches_(materials_.swatches.size()) {
    const shapes::Stage stage = shapes::stage_of(model);
    PrimText text(out_, 0);
    begin_layer(text, stage);
    shapes::for_each_body(
        model, materials_, [&](const std::string& name, bool) { begin(name); },
        [&](shapes::Body&& body) { take(std::move(body)); });
    end_thing();
    text.end();  // geometry
    put_stage(text, stage, first_frame());
    text.end();  // the scene
    put_render_settings(text, stage, fmt::format("/{}/camera", root_));
    if (body_count_ == 0) throw InputError("target usd: expected a body, got none: every piece is gone");
  }

  // The layer, and the pictures beside it.
  std::vector<OutputFile> files() && {
    std::vector<OutputFile> result{{model_.name + ".usda", fmt::to_string(out_)}};
    std::ranges::move(pictures_, std::back_inserter(result));
    return result;
  }

 private:
  // What is asked of renderers stands beside the scene, by that name.
  static std::string root_name(const std::string& scene) {
    const std::string name = identifier(scene);
    return name == "Render" ? "Render_" : name;
  }

  void begin_layer(PrimText& text, const shapes::Stage& stage) {
    text.line("#usda 1.0");
    text.line("(");
    text.line("    defaultPrim = \"{}\"", root_);
    if (model_.shot) {
      text.line("    endTimeCode = {}", model_.shot->last_frame);
      text.line("    framesPerSecond = {}", model_.shot->per_second);
      text.line("    startTimeCode = {}", model_.shot->first_frame);
      text.line("    timeCodesPerSecond = {}", model_.shot->per_second);
    }
    text.line("    metersPerUnit = 1");
    if (stage.camera.size_px) text.line("    renderSettingsPrimPath = \"/Render/settings\"");
    text.line("    upAxis = \"Y\"");
    text.line(")\n");
    text.begin("def Xform", root_, with_name({"kind = \"assembly\""}, model_.name, root_));
    text.begin("def Xform", "geometry", {"kind = \"group\""});
  }

  // With the name that the identifier stands for, where it is another.
  static std::vector<std::string> with_name(std::vector<std::string> metadata, const std::string& name,
                                            const std::string& identifier) {
    if (name != identifier) metadata.push_back(fmt::format("displayName = {}", in_usd_quotes(name)));
    return metadata;
  }

  int first_frame() const { return model_.shot ? model_.shot->first_frame : 1; }

  void begin(const std::string& name) {
    end_thing();
    const std::string own = identifier(name);
    place_ = {fmt::format("/{}/geometry/{}", root_, own), 3, &materials_.all, first_frame()};
    PrimText(out_, 2).begin("def Xform", own, with_name({"kind = \"component\""}, name, own));
    is_used_.assign(materials_.all.size(), false);
    prototypes_.clear();
  }

  void end_thing() {
    put_bodies();
    if (is_used_.empty()) return;
    PrimText text(out_, place_.depth);
    if (prototypes_.size() > 0) {
      text.begin("class Scope", "prototypes");
      out_.append(prototypes_.data(), prototypes_.data() + prototypes_.size());
      text.end();
    }
    text.begin("def Scope", "materials");
    for (std::size_t i = 0; i < is_used_.size(); ++i) {
      if (is_used_[i]) put_material(text, place_.path + "/materials", materials_.all[i], swatch_of(materials_.all[i]));
    }
    text.end();
    text.end();  // the thing
    is_used_.clear();
  }

  // Null of a material without.
  const SwatchFiles* swatch_of(const shapes::Material& material) {
    if (!material.swatch) return nullptr;
    std::optional<SwatchFiles>& files = swatches_[material.swatch->swatch];
    if (!files) {
      const shapes::Swatch& asked = materials_.swatches[material.swatch->swatch];
      swatches::Files made =
          swatches::files(swatches::drawn(asked, model_.seed), fmt::format("{}_{}", model_.name, asked.name));
      files = {made.base_color.name, made.normal.name, made.occlusion_roughness_metallic.name, asked.side_m};
      for (swatches::PictureFile* picture : {&made.base_color, &made.normal, &made.occlusion_roughness_metallic}) {
        pictures_.push_back({std::move(picture->name), std::move(picture->bytes)});
      }
    }
    return &*files;
  }

  void take(shapes::Body&& body) {
    for (const shapes::Piece& piece : body.pieces) is_used_[piece.material] = true;
    bodies_.push_back(std::move(body));
    if (bodies_.size() == bodies_at_once) put_bodies();
  }

  void put_bodies() {
    std::vector<std::pair<std::string, std::string>> texts(bodies_.size());
    parallel_for(bodies_.size(), [&](std::size_t i) {
      const shapes::Body& body = bodies_[i];
      texts[i].first = element_text(body, place_);
      if (body.shared && !body.pieces.empty()) texts[i].second = prototype_text(body, place_);
    });
    for (const auto& [element, prototype] : texts) {
      if (!element.empty()) ++body_count_;
      out_.append(element.data(), element.data() + element.size());
      prototypes_.append(prototype.data(), prototype.data() + prototype.size());
    }
    bodies_.clear();
  }

  const Model& model_;
  shapes::Materials materials_;
  std::string root_;                                  // the scene's identifier
  std::vector<std::optional<SwatchFiles>> swatches_;  // those of which something is made
  std::vector<OutputFile> pictures_;                  // of these
  Buffer out_;
  Buffer prototypes_;  // of the thing
  ThingPlace place_;
  std::vector<bool> is_used_;         // of the materials by the thing; empty outside of things
  std::vector<shapes::Body> bodies_;  // not yet written
  std::size_t body_count_ = 0;
};

}  // namespace

std::vector<OutputFile> usd_files(const Model& model) { return Writer(model).files(); }

void append(const Model& model, Outputs& outputs) {
  std::ranges::move(usd_files(model), std::back_inserter(outputs.files));
  swatches::append_environment(shapes::stage_of(model), outputs);
}

}  // namespace shatterpave::exporting::usd
