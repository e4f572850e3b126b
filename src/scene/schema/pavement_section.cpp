#include "scene/schema/pavement_section.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include "geometry/lattice.h"
#include "paving/bonds/table.h"
#include "paving/derived/steps.h"
#include "paving/limits.h"
#include "scene/schema/idle_keys.h"
#include "scene/schema/pavement_keys.h"
#include "scene/schema/ranges.h"
#include "scene/schema/section.h"

namespace shatterpave::scene {

namespace {

void limit_guides(std::size_t count, const Place& place) {
  if (count > most_guides) refuse(place, fmt::format("at most {} polylines", most_guides), fmt::format("{}", count));
}

paving::GuidesDirection guides_of(const TomlTable& table) {
  paving::GuidesDirection direction;
  const std::vector<PlacedPoints> lists = table.point_lists("guides_mm", coordinate_range);
  if (lists.empty()) refuse(table.place("guides_mm"), "one or more polylines", "none");
  limit_guides(lists.size(), table.place("guides_mm"));
  for (const PlacedPoints& list : lists) direction.guides_mm.push_back(line_of({list.points, list.place}));
  return direction;
}

// Keys of kinds other than the chosen one are checked like all others; that they have no effect is told (idle_keys.h).
paving::Direction direction_of(const TomlTable& pavement, Plans& plans) {
  using Kind = DirectionAsked::Kind;
  DirectionAsked asked;
  const auto table = direction_keys.read_in(pavement, asked);
  if (!table) return paving::ConstantDirection{};
  const bool is_guides = asked.kind == Kind::guides;
  if (has_guides_of_plan(*table)) {
    if (table->has("guides_mm")) refuse(table->place("guides_mm"), "guides of one kind", "guides_mm beside those of a plan");
    paving::GuidesDirection guides{guides_of_plan(*table, pavement, plans)};
    limit_guides(guides.guides_mm.size(), table->place());
    if (is_guides) return guides;
  } else if (is_guides || table->has("guides_mm")) {
    paving::GuidesDirection guides = guides_of(*table);
    if (is_guides) return guides;
  }
  if (asked.kind == Kind::boundary) return paving::BoundaryDirection{};
  if (asked.kind == Kind::radial) return paving::RadialDirection{geometry::on_lattice(asked.centre_mm)};
  return paving::ConstantDirection{asked.angle};
}

geometry::Box texture_area(const TomlTable& table) {
  const PlacedPoints corners = *table.points("area_mm", coordinate_range);
  const bool is_box =
      corners.points.size() == 2 && corners.points[0].x < corners.points[1].x && corners.points[0].y < corners.points[1].y;
  if (!is_box) refuse(corners.place, "the lower left and the upper right corner", "other points");
  return {corners.points[0], corners.points[1]};
}

void read_textures(const TomlTable& pavement, paving::TextureSet& textures) {
  const auto table = textures_keys.read_in(pavement, textures);
  if (!table) return;
  if (table->has("area_mm")) textures.area = texture_area(*table);
  if (textures.area && textures.seamless) refuse(table->place("area_mm"), "no area_mm beside seamless", "one");
  if (textures.tile_mm && !textures.seamless) refuse(table->place("tile_mm"), "seamless = true beside it", "none");
}

void read_ground(const TomlTable& pavement, paving::Pavement& result) {
  const auto table = ground_keys.read_in(pavement, result);
  if (!table) return;
  const double width = result.kerb.width_mm;
  if (width > 0.0 && width < paving::kerb_bounds_mm.low) {
    refuse(table->place("kerb_width_mm"), fmt::format("0, or {} or more", paving::kerb_bounds_mm.low),
           fmt::format("{}", width));
  }
}

std::optional<paving::Detail> detail_of(const TomlTable& pavement) {
  paving::Detail detail;
  return detail_keys.read_in(pavement, detail) ? std::optional(detail) : std::nullopt;
}

// Steps make sense of rows alone, and have no border of their own.
void require_rows(const TomlTable& table, const paving::Pavement& pavement) {
  if (table.has("bond") && paving::type_of(pavement).bending != paving::Bending::rows) {
    const auto rows =
        paving::names_of_bonds([](const paving::BondType& type) { return type.bending == paving::Bending::rows; });
    refuse(table.place("bond"), fmt::format("{} beside steps", fmt::join(rows, " or ")), "another one");
  }
  if (pavement.border.course != paving::BorderCourse::none) {
    refuse(table.place("border_course"), "no border_course beside steps", "one");
  }
  if (pavement.kerb.width_mm > 0.0) refuse(table.place("ground"), "no kerb beside steps", "one");
  if (pavement.textures.seamless) refuse(table.place("textures"), "no seamless textures beside steps", "seamless = true");
}

std::optional<paving::Flight> flight_of(const TomlTable& table, const paving::Pavement& pavement,
                                        const std::vector<geometry::Region>& areas) {
  paving::Flight flight;
  const auto steps = steps_keys.read_in(table, flight);
  if (!steps) return std::nullopt;
  if (flight.riser_mm == 0.0) refuse(steps->place("riser_mm"), "a height other than 0", "0");
  require_rows(table, pavement);
  for (const geometry::Region& area : areas) {
    const geometry::Box box = geometry::bounding_box(area.outline);
    if (glm::length(box.high - box.low) > static_cast<double>(most_pavements) * flight.tread_mm) {
      refuse(steps->place("tread_mm"), fmt::format("treads so deep that there are at most {} steps", most_pavements),
             fmt::format("up to {:.0f}", glm::length(box.high - box.low) / flight.tread_mm));
    }
    if (std::holds_alternative<paving::BoundaryDirection>(pavement.direction) && !area.holes.empty()) {
      refuse(steps->place(), "an area without holes where steps follow its boundary", "one with holes");
    }
  }
  return flight;
}

// All that a table says of a pavement but its area.
paving::Pavement pavement_of(const TomlTable& table, Plans& plans) {
  paving::Pavement pavement;
  pavement.name = name_of(table);
  pavement_keys.read(table, pavement);
  pavement.direction = direction_of(table, plans);
  surface_keys.read_in(table, pavement);
  variation_keys.read_in(table, pavement.variation);
  relief_keys.read_in(table, pavement.relief);
  read_ground(table, pavement);
  pavement.detail = detail_of(table);
  read_textures(table, pavement.textures);
  return pavement;
}

// A pavement for each of the areas of a table, or for each step of those.
void append_pavements(const TomlTable& table, Plans& plans, Names& names, Scene& scene) {
  name_of(table);
  std::vector<geometry::Region> areas = without_holes_of_plan(table, plans, outlines_of(table, plans));
  paving::Pavement pavement = pavement_of(table, plans);
  const std::optional<paving::Flight> flight = flight_of(table, pavement, areas);
  tell_idle_keys(table, pavement, flight.has_value(), plans.notes());
  const std::string name = pavement.name;
  std::vector<paving::Pavement> parts;
  for (geometry::Region& area : areas) {
    pavement.area = std::move(area);
    if (flight) {
      std::ranges::move(paving::steps(pavement, *flight), std::back_inserter(parts));
    } else {
      parts.push_back(pavement);
    }
    if (scene.pavements.size() + parts.size() > most_pavements) {
      refuse(table.place(), fmt::format("at most {} areas in all", most_pavements), "more");
    }
  }
  const KeyPlaces places(table);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    paving::Pavement& part = parts[i];
    part.name = i == 0 ? name : fmt::format("{}_{}", name, i + 1);
    names.add(part.name, i == 0 ? table.path() : fmt::format("part {} of {}", i + 1, table.path()), table.place("name"));
    if (part.kerb.width_mm > 0.0) names.add(paving::kerb_name(part), table.path(), table.place("name"));
    scene.pavements.push_back(std::move(part));
    scene.pavement_places.push_back(places);
  }
}

}  // namespace

void read_pavements(const TomlTable& root, Plans& plans, Names& names, Scene& scene) {
  for (const TomlTable& table : root.tables("pavement", most_pavements, pavement_keys.names())) {
    append_pavements(table, plans, names, scene);
  }
}

}  // namespace shatterpave::scene
