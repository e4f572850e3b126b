// What a target says of itself. Each stands in a folder of its own, whose header holds its description; the table is in
// targets.cpp.
#pragma once

#include <string_view>
#include <vector>

#include "export/model.h"

namespace shatterpave::exporting {

// Adds what the target makes of the model.
using AppendFiles = void (*)(const Model& model, Outputs& outputs);

struct Target {
  std::string_view name;      // as `--target` takes it
  std::string_view sentence;  // what it writes, for help and pages; without a full stop
  // Null of a target that draws or reads pictures: such a function stands in raster_targets.h, apart, since to load what
  // pictures need takes longer than most exports.
  AppendFiles append = nullptr;
  // Throws InputError, with NAME.MEMBER as its place, where the target would be refused for what a scene holds; null where it
  // takes every scene.
  void (*require)(const Things& things) = nullptr;

  // Whether it holds how things move over a shot, in one file for all frames.
  bool holds_motion = false;

  // Whether it has the glass of panes as meshes, whose materials know no dirt: that is told.
  bool glass_is_clean = false;

  bool has_rasters() const { return append == nullptr; }
};

}  // namespace shatterpave::exporting
