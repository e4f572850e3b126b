#include "scene/schema/pavement_section.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "geometry/lattice.h"
#include "paving/bonds/table.h"
#include "paving/catalogue/stone_sizes.h"
#include "paving/derived/steps.h"
#include "scene/schema/idle_keys.h"
#include "scene/schema/keys.h"
#include "scene/schema/section.h"
#include "scene/schema/stone_keys.h"

namespace shatterpave::scene {

namespace {

constexpr std::size_t most_pavements = 1000;
constexpr std::size_t most_guides = 10'000;
// Stones of one pavement, by area; a million takes about a minute and 1 GB.
constexpr double most_stones = 4e6;

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
  const auto table = pavement.table("direction", direction_keys);
  if (!table) return paving::ConstantDirection{};
  const Angle angle = Angle::degrees(table->number("angle_deg", {-360.0, 360.0}).value_or(0.0));
  const vec2 centre = geometry::on_lattice(table->point("centre_mm", coordinate_range).value_or(vec2{0.0, 0.0}));
  const std::size_t kind = table->choice("kind", {"constant", "boundary", "radial", "guides"}).value_or(0);
  if (has_guides_of_plan(*table)) {
    if (table->has("guides_mm")) refuse(table->place("guides_mm"), "guides of one kind", "guides_mm beside those of a plan");
    paving::GuidesDirection guides{guides_of_plan(*table, pavement, plans)};
    limit_guides(guides.guides_mm.size(), table->place());
    if (kind == 3) return guides;
  } else if (kind == 3 || table->has("guides_mm")) {
    paving::GuidesDirection guides = guides_of(*table);
    if (kind == 3) return guides;
  }
  if (kind == 1) return paving::BoundaryDirection{};
  if (kind == 2) return paving::RadialDirection{centre};
  return paving::ConstantDirection{angle};
}

paving::Bonding bonding_of(const TomlTable& pavement) {
  paving::Bonding bonding;
  const std::vector<std::string_view> names = paving::names_of_bonds([](const paving::BondType&) { return true; });
  if (const auto chosen = pavement.choice("bond", names)) {
    for (const paving::BondType* type : paving::bond_types()) {
      if (type->name == names[*chosen]) bonding.bond = type->id;
    }
  }
  pavement.read("bond_offset", {0.0, 1.0}, bonding.offset);
  bonding.turn = Angle::degrees(pavement.number("bond_turn_deg", {-360.0, 360.0}).value_or(0.0));
  pavement.read("bond_span_mm", {0.0, 1'000'000.0}, bonding.span_mm);
  return bonding;
}

void read_stone_preset(const TomlTable& table, paving::Pavement& pavement) {
  const auto chosen =
      table.choice("stone_preset", {"mosaic_sett", "small_sett", "large_sett", "brick", "clinker", "waal", "flagstone"});
  if (!chosen) return;
  const paving::StonePreset& preset = paving::stone_presets.at(*chosen);
  pavement.stone_mm = preset.stone_mm;
  pavement.joint_mm = preset.joint_mm;
}

paving::Border border_of(const TomlTable& pavement) {
  using paving::BorderCourse;
  constexpr std::array courses = {BorderCourse::none, BorderCourse::soldier, BorderCourse::stretcher};
  paving::Border border;
  border.course = courses.at(pavement.choice("border_course", {"none", "soldier", "stretcher"}).value_or(0));
  border.stone_mm = pavement.point("border_stone_mm", {1.0, 100'000.0}).value_or(border.stone_mm);
  return border;
}

geometry::Box texture_area(const TomlTable& table) {
  const PlacedPoints corners = *table.points("area_mm", coordinate_range);
  const bool is_box =
      corners.points.size() == 2 && corners.points[0].x < corners.points[1].x && corners.points[0].y < corners.points[1].y;
  if (!is_box) refuse(corners.place, "the lower left and the upper right corner", "other points");
  return {corners.points[0], corners.points[1]};
}

void read_textures(const TomlTable& pavement, paving::TextureSet& textures) {
  using paving::TextureFormat;
  constexpr std::array formats = {TextureFormat::png, TextureFormat::exr, TextureFormat::tiled_exr};
  const auto table = pavement.table("textures", textures_keys);
  if (!table) return;
  const auto size = table->whole_number("size_px", 256, 16384);
  if (size) textures.size_px = static_cast<std::size_t>(*size);
  textures.seamless = table->flag("seamless").value_or(false);
  if (table->has("area_mm")) textures.area = texture_area(*table);
  if (textures.area && textures.seamless) refuse(table->place("area_mm"), "no area_mm beside seamless", "one");
  textures.tile_mm = table->point("tile_mm", {1.0, 100'000.0});
  if (textures.tile_mm && !textures.seamless) refuse(table->place("tile_mm"), "seamless = true beside it", "none");
  textures.format = formats.at(table->choice("format", {"png", "exr", "tiled_exr"}).value_or(0));
}

// Steps make sense of rows alone, and have no border of their own.
void require_rows(const TomlTable& table, const paving::Pavement& pavement) {
  const auto refuse_key = [&](std::string_view key) {
    refuse(table.place(key), fmt::format("no {} beside steps", key), "one");
  };
  if (table.has("bond") && paving::type_of(pavement).bending != paving::Bending::rows) {
    const auto rows =
        paving::names_of_bonds([](const paving::BondType& type) { return type.bending == paving::Bending::rows; });
    refuse(table.place("bond"), fmt::format("{} beside steps", fmt::join(rows, " or ")), "another one");
  }
  if (table.has("bond_turn_deg")) refuse_key("bond_turn_deg");
  if (pavement.border.course != paving::BorderCourse::none) refuse_key("border_course");
  if (pavement.kerb.width_mm > 0.0) refuse(table.place("ground"), "no kerb beside steps", "one");
  if (pavement.textures.seamless) refuse(table.place("textures"), "no seamless textures beside steps", "seamless = true");
}

std::optional<paving::Flight> flight_of(const TomlTable& table, const paving::Pavement& pavement,
                                        const std::vector<geometry::Region>& areas) {
  const auto steps = table.table("steps", steps_keys);
  if (!steps) return std::nullopt;
  paving::Flight flight;
  steps->read("riser_mm", {-1000.0, 1000.0}, flight.riser_mm);
  steps->read("tread_mm", {1.0, 100'000.0}, flight.tread_mm);
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

void limit_stones(const TomlTable& table, const paving::Pavement& pavement, const std::vector<geometry::Region>& areas) {
  const vec2 pitch = pavement.stone_mm + vec2(pavement.joint_mm);
  double count = 0.0;
  for (const geometry::Region& area : areas) count += geometry::area(area) / (pitch.x * pitch.y);
  if (count <= most_stones) return;
  refuse(table.place("stone_mm"), fmt::format("stones so large that at most {} are needed", most_stones),
         fmt::format("about {:.0f}", count));
}

// All that a table says of a pavement but its area.
paving::Pavement pavement_of(const TomlTable& table, Plans& plans) {
  paving::Pavement pavement;
  pavement.name = name_of(table);
  read_stone_preset(table, pavement);
  pavement.stone_mm = table.point("stone_mm", {1.0, 100'000.0}).value_or(pavement.stone_mm);
  table.read("joint_mm", {0.0, 1000.0}, pavement.joint_mm);
  pavement.direction = direction_of(table, plans);
  pavement.bonding = bonding_of(table);
  pavement.border = border_of(table);
  read_stones(table, pavement);
  pavement.look = look_of(table);
  pavement.ground = ground_of(table);
  pavement.kerb = kerb_of(table);
  pavement.detail = detail_of(table);
  read_textures(table, pavement.textures);
  return pavement;
}

// A pavement for each of the areas of a table, or for each step of those.
void append_pavements(const TomlTable& table, Plans& plans, Names& names, Scene& scene) {
  name_of(table);
  std::vector<geometry::Region> areas = without_holes_of_plan(table, plans, outlines_of(table, plans));
  paving::Pavement pavement = pavement_of(table, plans);
  limit_stones(table, pavement, areas);
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
  for (const TomlTable& table : root.tables("pavement", most_pavements, pavement_keys)) {
    append_pavements(table, plans, names, scene);
  }
}

}  // namespace shatterpave::scene
