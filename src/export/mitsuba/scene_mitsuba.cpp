#include "export/mitsuba/scene_mitsuba.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "core/error.h"
#include "export/mitsuba/looks.h"
#include "export/mitsuba/mesh_file.h"
#include "export/mitsuba/view.h"
#include "export/mitsuba/xml.h"
#include "export/shapes/open_slab.h"
#include "export/swatches/environment.h"
#include "relief/raster.h"

namespace shatterpave::exporting::mitsuba {

namespace {

using shapes::Substance;

// Pavements of as many stones have those that are alike as instances, since their meshes would take hundreds of megabytes. Of
// fewer, one shape a material: 4,000 instances take the variants that compile their kernels (llvm, cuda) minutes.
constexpr std::size_t stones_for_instances = 50'000;
// How often light is turned before it counts no more. By eye: cracks are looked through by the dozen.
constexpr const char* glass_depth = "64";
constexpr const char* stone_depth = "16";

// Pictures of skies hold values a little below 0, as lenses leave them, of which Mitsuba warns at each ray: a picture that a
// scene names is given without them. The plain sky has none.
bool has_own_picture(const Model& model) { return model.light && !model.light->environment.empty(); }

shapes::Stage stage_for(const Model& model) {
  shapes::Stage stage = shapes::stage_of(model);
  if (!has_own_picture(model) || stage.light.environment_blur > Angle()) return stage;
  stage.environment_name = shared_stem_of(model) + "-environment.exr";
  return stage;
}

class Writer {
 public:
  explicit Writer(const Model& model) : model_(model), materials_(shapes::materials_of(model)), looks_(materials_) {
    shapes::for_each_body(
        model, materials_, [&](const std::string& name, bool is_pane) { begin(name, is_pane); },
        [&](shapes::Body&& body) {
          if (is_pane_) open_up(body);
          add(body);
        });
    end();
    if (files_.empty()) throw InputError("target mitsuba: expected a body, got none: every piece is gone");
  }

  std::vector<OutputFile> files() {
    const shapes::Stage stage = stage_for(model_);
    Xml xml;
    xml.comment(
        "Metres, y up. mitsuba -m scalar_rgb SCENE.xml; -Dspp=256, -Dwidth=1920 and -Dheight=1080 set what stands here first.");
    xml.open("scene", {{"version", "3.0.0"}});
    write_defaults(xml, stage);
    const bool has_glass = looks_.has_glass();
    xml.open("integrator", {{"type", has_glass ? "volpath" : "path"}});
    xml.value("integer", "max_depth", has_glass ? glass_depth : stone_depth);
    if (has_glass) xml.value("integer", "rr_depth", stone_depth);
    xml.close();
    write_camera(xml, stage);
    write_lights(xml, stage, extent_mm());
    looks_.write(model_.name, model_.seed, xml, files_);
    xml.append(shapes_);
    if (has_own_picture(model_)) {
      files_.push_back(
          {stage.environment_name, relief::encoded(swatches::seen_environment(stage), relief::RasterFormat::exr_half)});
    }
    xml.close();
    std::vector<OutputFile> files;
    files.push_back({model_.name + ".xml", "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n" + xml.text()});
    std::ranges::move(files_, std::back_inserter(files));
    return files;
  }

 private:
  // What is of one material in a thing. Cracks that are gaps have one of their own.
  struct Part {
    std::size_t material = 0;
    bool is_film = false;
    auto operator<=>(const Part&) const = default;
  };

  void begin(const std::string& name, bool is_pane) {
    end();
    thing_ = name;
    is_pane_ = is_pane;
    if (is_pane) {
      const glass::Pane& pane = model_.panes[panes_++].pane;
      of_shards_ = pane.shards.has_value();
      open_ = {};
      holes_ = 0;
      if (!of_shards_ && !model_.panes[panes_ - 1].surfaces.shot_holes.empty())
        open_ = shapes::open_slab(model_.panes[panes_ - 1]);
      has_films_ = !of_shards_ && pane.crack_body == glass::CrackBody::sheet;
    } else {
      has_instances_ = model_.pavements[pavements_++].layout.stones.size() >= stones_for_instances;
    }
  }

  // Writes what the thing is of.
  void end() {
    for (auto& [part, mesh] : meshes_) {
      const std::string name = part_name(part);
      write_shape(shapes_, fmt::format("{}.{}", thing_, name), name, part, mesh.taken());
    }
    meshes_.clear();
    kept_.clear();
    groups_.clear();
  }

  // Unique in the thing. The material of a pavement begins with its name.
  std::string part_name(const Part& part) const {
    if (part.is_film) return "cracks";
    const std::string& material = materials_.all[part.material].name;
    return is_pane_ ? material : material.substr(thing_.size() + 1);
  }

  void add(const shapes::Body& body) {
    const std::uint32_t number = bodies_++;
    if (body.shared && has_instances_) {
      add_instance(body, number);
      return;
    }
    if (body.shared) kept_.try_emplace(*body.shared, body.pieces);
    for (const shapes::Piece& piece : body.shared ? kept_.at(*body.shared) : body.pieces) {
      MeshFile& file = meshes_[{piece.material, is_film(body)}];
      file.begin_body(number, body);
      file.add(piece.mesh, body.placing);
    }
  }

  // A pane that was shot through has openings.
  void open_up(shapes::Body& body) {
    if (open_.walls.empty()) return;
    if (body.kind == "pane") body.pieces.front().mesh = std::move(open_.slab);
    if (body.kind == "hole") body.pieces.front().mesh = std::move(open_.walls[holes_++]);
  }

  bool is_film(const shapes::Body& body) const { return is_pane_ && has_films_ && body.kind.starts_with("crack "); }

  // The first of those that are alike brings the meshes of the group.
  void add_instance(const shapes::Body& body, std::uint32_t number) {
    const auto [found, is_new] = groups_.try_emplace(*body.shared, groups_.size());
    const std::string group = fmt::format("{}.group_{}", thing_, found->second);
    if (is_new) {
      shapes_.open("shape", {{"type", "shapegroup"}, {"id", group}});
      for (std::size_t k = 0; k < body.pieces.size(); ++k) {
        const shapes::Piece& piece = body.pieces[k];
        MeshFile file;
        file.begin_body(number, body);
        file.add(piece.mesh, {});
        write_shape(shapes_, fmt::format("{}.{}", group, k), fmt::format("group_{}_{}", found->second, k), {piece.material},
                    file.taken());
      }
      shapes_.close();
    }
    shapes_.open("shape", {{"type", "instance"}, {"id", body.name}});
    shapes_.leaf("ref", {{"id", group}});
    shapes_.open("transform", {{"name", "to_world"}});
    shapes_.leaf("matrix", {{"value", matrix(body.placing)}});
    shapes_.close();
    shapes_.close();
  }

  static std::string matrix(const shapes::Placing& placing) {
    std::string text;
    for (std::size_t row = 0; row < 3; ++row) {
      const vec3& r = placing.turn.at(row);
      for (const double value : {r.x, r.y, r.z, placing.at_mm[row] / 1000.0}) text += number(value) + " ";
    }
    return text + "0 0 0 1";
  }

  void write_shape(Xml& xml, const std::string& id, const std::string& name, const Part& part, std::string mesh) {
    std::string file = fmt::format("{}-{}-{}.ply", model_.name, thing_, name);
    xml.open("shape", {{"type", "ply"}, {"id", id}});
    xml.value("string", "filename", file);
    if (part.is_film) {
      looks_.use_film();
      xml.leaf("ref", {{"id", film_bsdf}});
    } else {
      xml.leaf("ref", {{"id", looks_.use(part.material)}});
      if (materials_.all[part.material].substance == Substance::glass ||
          materials_.all[part.material].substance == Substance::broken_glass) {
        looks_.use_medium(of_shards_);
        xml.leaf("ref", {{"name", "interior"}, {"id", of_shards_ ? shard_medium : pane_medium}});
      }
    }
    xml.close();
    files_.push_back({std::move(file), std::move(mesh)});
  }

  double extent_mm() const {
    double extent = 0.0;
    for (const vec3& p : shapes::extents_mm(model_)) extent = std::max(extent, glm::length(p));
    return extent;
  }

  const Model& model_;
  shapes::Materials materials_;
  Looks looks_;
  Xml shapes_{1};
  std::vector<OutputFile> files_;
  std::uint32_t bodies_ = 0;
  // Of the thing:
  std::string thing_;
  bool is_pane_ = false;
  bool of_shards_ = false;
  bool has_films_ = false;
  shapes::OpenSlab open_;  // of a pane with holes
  std::size_t holes_ = 0;  // so many have come
  bool has_instances_ = false;
  std::size_t panes_ = 0;  // so many have begun
  std::size_t pavements_ = 0;
  std::map<Part, MeshFile> meshes_;
  std::map<std::size_t, std::vector<shapes::Piece>> kept_;  // that bodies share, where they are no instances
  std::map<std::size_t, std::size_t> groups_;               // number of the group of those that share
};

}  // namespace

std::vector<OutputFile> mitsuba_files(const Model& model) { return Writer(model).files(); }

void append(const Model& model, Outputs& outputs) {
  std::ranges::move(mitsuba_files(model), std::back_inserter(outputs.files));
  if (!has_own_picture(model)) swatches::append_environment(shapes::stage_of(model), outputs);
}

}  // namespace shatterpave::exporting::mitsuba
