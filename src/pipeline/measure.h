// A scene broken and paved over and over, and measured.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "core/progress.h"
#include "measure/survey.h"
#include "scene/scene.h"

namespace shatterpave::pipeline {

inline constexpr std::size_t most_seeds = 100'000;
// Seeds times panes of the scene: each takes some 500 bytes of memory, and milliseconds.
inline constexpr std::size_t most_measured_panes = 1'000'000;

struct MeasureOptions {
  std::string scene_file;               // how messages name the scene
  std::size_t seeds = 1;                // 1 … most_seeds
  std::optional<measure::Sweep> sweep;  // M in place of what the scene says; N and R then follow from it
  bool both_laws = false;               // the other law of growth beside the scene's, also where no pane has law = "printed"
};

// Breaks every pane of `scene` and lays every pavement with `options.seeds` seeds, from the scene's own on. Throws InputError
// for a scene without either, and for too many seeds.
measure::Survey surveyed(const scene::Scene& scene, const MeasureOptions& options, const Progress& progress = {});

}  // namespace shatterpave::pipeline
