// What a scene takes of a plan.
#pragma once

#include "scene/plans/plan_areas.h"
#include "tests/fuzz/harness.h"

namespace shatterpave::fuzz {

// The areas of the only feature, with lines and points widened.
inline void take_areas(const scene::Plan& plan) {
  const auto shapes = scene::chosen_shapes(plan, {scene::ShapeKind::area, scene::ShapeKind::line, scene::ShapeKind::point}, {},
                                           scene::ByDefault::the_only_feature);
  scene::merged(scene::regions_of(plan, shapes, scene::frame_of(plan, shapes, std::nullopt, std::nullopt), 100.0));
}

}  // namespace shatterpave::fuzz
