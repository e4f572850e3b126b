// Models of a scene's frames, of which nothing is made twice that stays as it is.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "core/progress.h"
#include "export/model.h"
#include "pipeline/generate.h"
#include "pipeline/parts.h"
#include "scene/shot.h"

namespace shatterpave::pipeline {

// What each thing of a scene of a shot is made from, panes first, in the order of its model: with equal sums they are equal,
// but for where they stand.
std::vector<std::string> thing_sums(const scene::Scene& scene, const std::vector<PavementPart>& parts);

// Which things of the model change over the shot. Asks at the stops of its keys: between two that are equal nothing changes.
class ChangingThings {
 public:
  explicit ChangingThings(scene::Shot& shot);
  // Whether the thing of the scene at a frame is the same at all frames.
  bool is_fixed(const std::vector<std::string>& sums, std::size_t thing) const {
    return !all_change_ && thing < fixed_.size() && !fixed_[thing].empty() && fixed_[thing] == sums[thing];
  }

 private:
  std::vector<std::string> fixed_;  // its sum, or empty
  bool all_change_ = false;         // their number does
};

class FrameModels {
 public:
  // The model of the scene at a frame; valid until the next. Things that are not wanted are without what would be made of them.
  exporting::Model& model(const scene::Scene& scene, const Wanted& wanted, const Progress& progress);

 private:
  exporting::Model model_;
  std::vector<std::string> made_;  // the sum of each thing that was made; else empty
};

}  // namespace shatterpave::pipeline
