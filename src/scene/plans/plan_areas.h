// Areas of plans as regions.
#pragma once

#include "scene/plans/plan_frame.h"

namespace shatterpave::scene {

// The regions of shapes of a plan, in their order: areas as they are, lines as bands of `width_mm` > 0 that end square, points
// as discs of that diameter. Rings that make no region are read as what they enclose, as `regions_of_polygon` and
// `filled_regions` say; those are told in `notes`. Of a shape that makes none at all the error goes to `left_out`; without it,
// it is thrown.
std::vector<geometry::Region> regions_of(const Plan& plan, const std::vector<std::size_t>& shapes, const PlanFrame& frame,
                                         double width_mm, std::vector<Note>* notes = nullptr,
                                         std::vector<InputError>* left_out = nullptr);

// The regions, of which those that overlap or adjoin are one, in the order of their first parts.
std::vector<geometry::Region> merged(const std::vector<geometry::Region>& regions);

// The areas of the only feature of a file, in a frame of its own.
std::vector<geometry::Region> areas_of_file(const std::filesystem::path& file);

// What of the regions lies in one of `limits`, which are as `merged` makes them.
std::vector<geometry::Region> within(const std::vector<geometry::Region>& areas, const std::vector<geometry::Region>& limits);

// The regions without what lies in `holes`, which may overlap and lie anywhere: one region may become several or none.
std::vector<geometry::Region> without(const std::vector<geometry::Region>& areas, const std::vector<geometry::Region>& holes);

}  // namespace shatterpave::scene
