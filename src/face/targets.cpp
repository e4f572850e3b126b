#include "face/targets.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "core/error.h"
#include "core/words.h"
#include "export/json/geometry_json.h"
#include "export/obj/shards_obj.h"
#include "export/povray/povray.h"
#include "export/svg/drawing_svg.h"
#include "export/textures/textures.h"
#include "scene/input_file.h"

namespace shatterpave::face {

namespace {

using exporting::Model;
using exporting::Outputs;

void append(std::vector<exporting::OutputFile> files, Outputs& outputs) {
  std::ranges::move(files, std::back_inserter(outputs.files));
}

void append_povray(const Model& model, Outputs& outputs) { append(exporting::povray::povray_files(model), outputs); }
void append_json(const Model& model, Outputs& outputs) { outputs.files.push_back(exporting::json_file(model)); }
void append_svg(const Model& model, Outputs& outputs) { append(exporting::svg_files(model), outputs); }
void append_textures(const Model& model, Outputs& outputs) {
  std::ranges::move(exporting::textures::texture_files(model), std::back_inserter(outputs.sets));
}
void append_obj(const Model& model, Outputs& outputs) {
  std::vector<glass::Pane> panes;
  for (const exporting::BrokenPane& broken : model.panes) panes.push_back(broken.pane);
  exporting::require_shards(panes);
  append(exporting::obj_files(model), outputs);
}

}  // namespace

const std::vector<TargetRow>& target_rows() {
  static const std::vector<TargetRow> rows = {
      {"povray", "POV-Ray: an include file for each pane and pavement, and a scene that shows them", append_povray},
      {"json", "geometry: cracks, shards and stones as polygons, in JSON", append_json},
      {"svg", "a drawing to scale of each pane and pavement", append_svg},
      {"textures", "texture sets of pavements, seamless where that is asked for", append_textures},
      {"obj", "shards as solids, in Wavefront OBJ", append_obj},
  };
  return rows;
}

const TargetRow& target_row(std::string_view name) {
  std::vector<std::string_view> names;
  for (const TargetRow& row : target_rows()) {
    if (row.name == name) return row;
    names.push_back(row.name);
  }
  const std::string_view meant = nearest(name, names);
  throw InputError(Place{{}, 0, 0, "target"},
                   fmt::format("expected {}, got {}{}", listed(names, "or"), scene::in_quotes(name),
                               meant.empty() ? std::string() : fmt::format("; did you mean {}?", meant)));
}

}  // namespace shatterpave::face
