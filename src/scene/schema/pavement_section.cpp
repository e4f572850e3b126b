#include "scene/schema/pavement_section.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <utility>

#include "geometry/lattice.h"
#include "paving/bonds/table.h"
#include "paving/limits.h"
#include "scene/direction_file.h"
#include "scene/grey_map_file.h"
#include "scene/input_file.h"
#include "scene/schema/idle_keys.h"
#include "scene/schema/module_section.h"
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

// The file that a key names, sought from the scene's folder.
std::filesystem::path file_beside(const TomlTable& table, std::string_view key, std::string_view what) {
  const auto name = table.text(key);
  const Place place = table.place(key);
  if (!name) refuse(place, fmt::format("{} = \"…\", {}", key, what), "none");
  const auto folder = is_nameless(place.file) ? std::filesystem::path() : std::filesystem::path(place.file).parent_path();
  return folder / *name;
}

// Of a rectangle's lower left and upper right corner.
geometry::Box box_of(const TomlTable& table, std::string_view key) {
  const PlacedPoints corners = *table.points(key, coordinate_range);
  const bool is_box =
      corners.points.size() == 2 && corners.points[0].x < corners.points[1].x && corners.points[0].y < corners.points[1].y;
  if (!is_box) refuse(corners.place, "the lower left and the upper right corner", "other points");
  return {corners.points[0], corners.points[1]};
}

// `area` is what the pavements of the table cover together.
paving::GridDirection grid_of(const TomlTable& table, const geometry::Box& area, Plans& plans) {
  const std::filesystem::path file_name = file_beside(table, "grid_file", "a file of vectors");
  const bool has_area = table.has("grid_area_mm");
  if (has_area && !covers_area(file_name)) {
    refuse(table.place("grid_area_mm"), "a picture as grid_file beside it", "a file that tells where its vectors are");
  }
  DirectionFile file = direction_of_file(file_name, table.place("grid_file"), has_area ? box_of(table, "grid_area_mm") : area);
  plans.note_sum(file.sum);
  return std::move(file.grid);
}

// Keys of kinds other than the chosen one are checked like all others; that they have no effect is told (idle_keys.h).
paving::Direction direction_of(const TomlTable& pavement, const geometry::Box& area, Plans& plans) {
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
  if (asked.kind == Kind::grid || table->has("grid_file")) {
    paving::GridDirection grid = grid_of(*table, area, plans);
    if (asked.kind == Kind::grid) return grid;
  }
  if (asked.kind == Kind::boundary) return paving::BoundaryDirection{};
  if (asked.kind == Kind::radial) return paving::RadialDirection{geometry::on_lattice(asked.centre_mm)};
  return paving::ConstantDirection{asked.angle};
}

paving::SizesFromLines lines_of(const TomlTable& table, const paving::SizeRamp& ramp) {
  paving::SizesFromLines sizes{ramp, {}};
  const std::vector<PlacedPoints> lists = table.point_lists("lines_mm", coordinate_range);
  if (lists.empty()) refuse(table.place("lines_mm"), "one or more polylines", "none");
  limit_guides(lists.size(), table.place("lines_mm"));
  for (const PlacedPoints& list : lists) sizes.lines_mm.push_back(line_of({list.points, list.place}));
  return sizes;
}

// `area` is what the pavements of the table cover together.
paving::SizesOfMap map_of(const TomlTable& table, const SizeAsked& asked, const geometry::Box& area, Plans& plans) {
  GreyMapFile file = grey_map_of_file(file_beside(table, "map_file", "a grey picture"), table.place("map_file"));
  plans.note_sum(file.sum);
  const geometry::Box box = table.has("map_area_mm") ? box_of(table, "map_area_mm") : area;
  return {asked.dark, asked.light, box.low, box.high, file.columns, std::move(file.greys)};
}

// Keys of kinds other than the chosen one are checked, too.
paving::Sizes sizes_of(const TomlTable& pavement, const geometry::Box& area, Plans& plans) {
  using Kind = SizeAsked::Kind;
  SizeAsked asked;
  const auto table = size_keys.read_in(pavement, asked);
  if (!table) return paving::EqualSizes{};
  if (asked.kind == Kind::line || table->has("lines_mm")) {
    paving::SizesFromLines lines = lines_of(*table, asked.ramp);
    if (asked.kind == Kind::line) return lines;
  }
  if (asked.kind == Kind::map || table->has("map_file")) {
    paving::SizesOfMap map = map_of(*table, asked, area, plans);
    if (asked.kind == Kind::map) return map;
  }
  return paving::SizesFromEdge{asked.ramp};
}

void read_textures(const TomlTable& pavement, paving::TextureSet& textures) {
  const auto table = textures_keys.read_in(pavement, textures);
  if (!table) return;
  if (table->has("area_mm")) textures.area = box_of(*table, "area_mm");
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

// Shares as the scene gives them, made to be 1 together.
void read_colours(const TomlTable& pavement, paving::ColourMix& mix) {
  double total = 0.0;
  for (const TomlTable& table : colour_keys.tables_in(pavement, most_colours)) {
    ColourAsked asked;
    colour_keys.read(table, asked);
    if (!table.has("srgb")) refuse(table.place("srgb"), "srgb = [red, green, blue], each 0 to 1", "none");
    mix.colours.push_back(asked.srgb);
    mix.shares.push_back(asked.share);
    total += asked.share;
  }
  for (double& share : mix.shares) share /= total;
  if (const auto points = pavement.points("colour_gradient_mm", coordinate_range)) {
    if (points->points.size() != 2 || points->points[0] == points->points[1]) {
      refuse(points->place, "two points that differ", fmt::format("{} points", points->points.size()));
    }
    mix.gradient_mm = std::pair(points->points[0], points->points[1]);
  }
  if (const auto points = pavement.points("colour_attractors_mm", coordinate_range)) {
    if (mix.gradient_mm) refuse(points->place, "no colour_attractors_mm beside colour_gradient_mm", "both");
    if (points->points.empty() || points->points.size() > most_attractors) {
      refuse(points->place, fmt::format("1 to {} points", most_attractors), fmt::format("{}", points->points.size()));
    }
    mix.attractors_mm = points->points;
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

// Only stones that are packed one by one follow a field of vectors, and sizes that differ from place to place, and stand on
// their corners as scales do.
void require_packed(const TomlTable& table, const paving::Pavement& pavement) {
  const auto require = [&](bool asked, std::string_view what) {
    if (!asked) return;
    if (paving::type_of(pavement).bending != paving::Bending::packed) {
      refuse(table.place("bond"), fmt::format("bond = \"packed\" beside {}", what), "another one");
    }
    if (table.has("steps")) refuse(table.place("steps"), fmt::format("no steps beside {}", what), "steps");
  };
  require(std::holds_alternative<paving::GridDirection>(pavement.direction), "direction.kind = \"grid\"");
  require(paving::has_sizes(pavement), "size");
  require(pavement.cell.form == paving::CellForm::scale, "cell.form = \"scale\"");
}

// Cells have bodies of their own.
void require_plain_cells(const TomlTable& table, const paving::Pavement& pavement) {
  if (pavement.cell.form == paving::CellForm::stone) return;
  if (pavement.body.finish != paving::Finish::none) refuse(table.place("surface"), "no finish beside cell.form", "one");
  if (table.has("steps")) refuse(table.place("steps"), "no steps beside cell.form", "steps");
  if (pavement.border.course != paving::BorderCourse::none) {
    refuse(table.place("border_course"), "no border_course beside cell.form", "one");
  }
  if (pavement.cell.form == paving::CellForm::scale && pavement.stone_mm.x != pavement.stone_mm.y) {
    refuse(table.place("stone_mm"), "square stones beside cell.form = \"scale\"", "oblong ones");
  }
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
    if (glm::length(box.high - box.low) > static_cast<double>(paving::most_pavements) * flight.tread_mm) {
      refuse(steps->place("tread_mm"), fmt::format("treads so deep that there are at most {} steps", paving::most_pavements),
             fmt::format("up to {:.0f}", glm::length(box.high - box.low) / flight.tread_mm));
    }
    if (std::holds_alternative<paving::BoundaryDirection>(pavement.direction) && !area.holes.empty()) {
      refuse(steps->place(), "an area without holes where steps follow its boundary", "one with holes");
    }
  }
  return flight;
}

// The box about all of them, of which there is one or more.
geometry::Box box_about(const std::vector<geometry::Region>& areas) {
  geometry::Box all = geometry::bounding_box(areas.front().outline);
  for (const geometry::Region& area : areas) {
    const geometry::Box box = geometry::bounding_box(area.outline);
    all = {glm::min(all.low, box.low), glm::max(all.high, box.high)};
  }
  return all;
}

// All that a table says of a pavement but its area and its steps. `area` is the box about its areas.
paving::Pavement pavement_of(const TomlTable& table, const geometry::Box& area, Plans& plans) {
  paving::Pavement pavement;
  pavement.name = name_of(table);
  pavement_keys.read(table, pavement);
  pavement.direction = direction_of(table, area, plans);
  pavement.sizes = sizes_of(table, area, plans);
  surface_keys.read_in(table, pavement);
  cell_keys.read_in(table, pavement.cell);
  variation_keys.read_in(table, pavement.variation);
  hand_keys.read_in(table, pavement);
  read_colours(table, pavement.look.colours);
  relief_keys.read_in(table, pavement.relief);
  read_ground(table, pavement);
  pavement.detail = detail_of(table);
  read_module(table, plans, pavement);
  read_textures(table, pavement.textures);
  return pavement;
}

// A pavement for each of the areas of a table, all of the table's name.
void append_pavements(const TomlTable& table, Plans& plans, Names& names, Scene& scene) {
  names.add(name_of(table), table.path(), table.place("name"));
  std::vector<geometry::Region> areas = without_holes_of_plan(table, plans, outlines_of(table, plans));
  if (scene.pavements.size() + areas.size() > paving::most_pavements) {
    refuse(table.place(), fmt::format("at most {} areas in all", paving::most_pavements), "more");
  }
  paving::Pavement pavement = pavement_of(table, box_about(areas), plans);
  require_packed(table, pavement);
  require_plain_cells(table, pavement);
  pavement.flight = flight_of(table, pavement, areas);
  tell_idle_keys(table, pavement, plans.notes());
  const KeyPlaces places(table);
  for (geometry::Region& area : areas) {
    pavement.area = std::move(area);
    scene.pavements.push_back(pavement);
    scene.pavement_places.push_back(places);
  }
}

}  // namespace

void read_pavements(const TomlTable& root, Plans& plans, Names& names, Scene& scene) {
  for (const TomlTable& table : root.tables("pavement", paving::most_pavements, pavement_keys.names())) {
    append_pavements(table, plans, names, scene);
  }
}

}  // namespace shatterpave::scene
