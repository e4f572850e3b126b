// The member `crs` of GeoJSON (2008, section 3), and what programs write in its place.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "core/error.h"
#include "scene/plans/plan.h"

namespace shatterpave::scene {

// The name of the reference system that an object states: in `crs`, by `properties.name`, by `properties.code`, by a link, by
// `wkid`; or in `spatialReference`. Nothing where it states none, or null. Throws InputError where there is one that has no
// name.
//   record, path   where the object is
std::optional<std::string> crs_name(const nlohmann::json& object, const Place& record, const std::string& path);

// Sets the units of a plan, whose shapes are read, by the reference system that it names at `place`, or why it gives none; a
// map that is somewhat off is told in the plan's notes. Throws InputError for what no units can help.
void take_reference_system(const std::string& name, const Place& place, Plan& plan);

}  // namespace shatterpave::scene
