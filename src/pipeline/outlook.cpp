#include "pipeline/outlook.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "core/error.h"
#include "core/overloaded.h"
#include "geometry/clip.h"
#include "paving/bonds/border.h"
#include "paving/bonds/table.h"
#include "pipeline/parts.h"
#include "pipeline/placed.h"

namespace shatterpave::pipeline {

namespace {

using paving::Pavement;

// Of so many things a summary gives the names; more are only counted.
constexpr std::size_t most_named = 4;
// How many stones more than by area there are for each stone's length of border: by counting those of scenes/bonds.toml.
constexpr double cut_more = 0.2;

// Whole stones by area. Along the border half a stone more is cut than by area, but small pieces are joined to their
// neighbours.
double expected_stones(const Pavement& pavement) {
  const double one = paving::type_of(pavement).mean_area_mm2(pavement);
  double count = 0.0;
  std::vector<geometry::Region> field = {pavement.area};
  if (pavement.border.course != paving::BorderCourse::none) {
    const vec2 border = paving::border_stone_mm(pavement) + vec2(pavement.joint_mm);
    count += geometry::perimeter(pavement.area) / border.x;
    field = geometry::offset(pavement.area, -border.y);
  }
  for (const geometry::Region& region : field) {
    count += geometry::area(region) / one + cut_more * geometry::perimeter(region) / std::sqrt(one);
  }
  return count * (1.0 - pavement.variation.missing);
}

// Rounded to two digits.
std::string rounded_count(double count) {
  double unit = 1.0;
  while (count >= 100.0 * unit) unit *= 10.0;
  return fmt::format("{:.0f}", std::round(count / unit) * unit);
}

std::string counted(std::size_t count, std::string_view thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

std::string area_text(double mm2) {
  if (mm2 < 1e5) return fmt::format("{:.0f} mm²", mm2);
  return fmt::format("{:.{}f} m²", mm2 * 1e-6, mm2 < 1e8 ? 1 : 0);
}

std::string text_of(const glass::Pane& pane) {
  const geometry::Box box = geometry::bounding_box(pane.outline_mm);
  const std::string kind = std::visit(Overloaded{[](const glass::Annealed&) { return std::string(); },
                                                 [](const auto& special) { return fmt::format(", {}", special.name); }},
                                      pane.glass);
  return fmt::format("{}, {:.6g} × {:.6g} mm{}, {}{}", pane.name, box.high.x - box.low.x, box.high.y - box.low.y, kind,
                     counted(pane.impacts.size(), "impact"), pane.shards ? ", shards" : "");
}

std::string text_of(const Pavement& pavement) {
  return fmt::format("{}, {}, about {} stones{}", pavement.name, area_text(geometry::area(pavement.area)),
                     rounded_count(expected_stones(pavement)), pavement.kerb.width_mm > 0.0 ? ", a kerb" : "");
}

std::string text_of_rest(std::size_t count, const std::vector<glass::Pane>& /*panes*/) { return fmt::format("{} more", count); }

std::string text_of_rest(std::size_t count, const std::vector<Pavement>& pavements) {
  double area = 0.0;
  double stones = 0.0;
  for (const Pavement& pavement : pavements) {
    area += geometry::area(pavement.area);
    stones += expected_stones(pavement);
  }
  return fmt::format("{} more; in all {}, about {} stones", count, area_text(area), rounded_count(stones));
}

template <typename Thing>
void append(std::string_view name, const std::vector<Thing>& things, std::string& text) {
  if (things.empty()) return;
  text += fmt::format("{}{} (", text.empty() ? "" : ", ", counted(things.size(), name));
  const std::size_t named = things.size() <= most_named ? things.size() : most_named - 1;
  for (std::size_t i = 0; i < named; ++i) text += (i > 0 ? "; " : "") + text_of(things[i]);
  if (named < things.size()) text += "; " + text_of_rest(things.size() - named, things);
  text += ")";
}

Note nothing_laid(const scene::Scene& scene, const PavementPart& part) {
  const Pavement& pavement = part.pavement;
  if (pavement.variation.missing == 1.0) {
    return {place_of(scene, part, "variation.missing"), "leaves no stone of " + pavement.name};
  }
  const geometry::Box box = geometry::bounding_box(pavement.area.outline);
  return {place_of(scene, part, "stone_mm"),
          fmt::format("no stone of {} is laid: none fits in its {:.6g} × {:.6g} mm with joints of {} mm", pavement.name,
                      box.high.x - box.low.x, box.high.y - box.low.y, pavement.joint_mm)};
}

Note nothing_within(const scene::Scene& scene, const PavementPart& part) {
  return {place_of(scene, part, "border_course"),
          fmt::format("leaves nothing within: of {} the border course alone is laid", part.pavement.name)};
}

Note no_kerb_laid(const scene::Scene& scene, const PavementPart& kerb, const PavementPart& pavement) {
  return {place_of(scene, kerb, ""), fmt::format("no kerb stone of {} is laid", pavement.pavement.name)};
}

bool is_all_border(const Pavement& pavement) {
  if (pavement.border.course == paving::BorderCourse::none) return false;
  return geometry::offset(pavement.area, -(paving::border_stone_mm(pavement).y + pavement.joint_mm)).empty();
}

bool has_no_room(const Pavement& pavement) {
  return pavement.variation.missing == 1.0 ||
         (pavement.joint_mm > 0.0 && geometry::offset(pavement.area, -0.5 * pavement.joint_mm).empty());
}

}  // namespace

std::string summary(const scene::Scene& scene) {
  std::vector<Pavement> pavements;
  for (PavementPart& part : pavement_parts(scene)) {
    if (!part.is_kerb()) pavements.push_back(std::move(part.pavement));
  }
  std::string text;
  append("pane", scene.panes, text);
  append("pavement", pavements, text);
  return text;
}

std::vector<Note> emptiness(const scene::Scene& scene) {
  std::vector<Note> notes;
  for (const PavementPart& part : pavement_parts(scene)) {
    if (part.is_kerb()) continue;
    if (has_no_room(part.pavement)) {
      notes.push_back(nothing_laid(scene, part));
    } else if (is_all_border(part.pavement)) {
      notes.push_back(nothing_within(scene, part));
    }
  }
  return notes;
}

std::vector<Note> unseen(const scene::Scene& scene, const std::vector<const exporting::Target*>& targets) {
  std::vector<std::string_view> clean;
  for (const exporting::Target* target : targets) {
    if (target->glass_is_clean) clean.push_back(target->name);
  }
  std::vector<Note> notes;
  if (clean.empty()) return notes;
  for (std::size_t i = 0; i < scene.panes.size(); ++i) {
    const glass::Pane& pane = scene.panes[i];
    if (pane.dirt == 0.0) continue;
    notes.push_back({known_place(places_at(scene.pane_places, i), pane.name, "dirt"),
                     fmt::format("has no effect on {}: dirt is a texture for POV-Ray", fmt::join(clean, ", "))});
  }
  return notes;
}

std::vector<Note> emptiness(const scene::Scene& scene, const exporting::Model& model) {
  std::vector<Note> notes;
  for (std::size_t i = 0; i < model.panes.size(); ++i) {
    const exporting::BrokenPane& broken = model.panes[i];
    const auto is_there = [](const glass::Shard& shard) { return shard.state != glass::ShardState::missing; };
    if (!broken.pane.shards || std::ranges::any_of(broken.shards, is_there)) continue;
    notes.push_back(
        {known_place(places_at(scene.pane_places, i), broken.pane.name, "shards"),
         fmt::format("leave nothing of {}: every piece is missing or smaller than splinter_mm2", broken.pane.name)});
  }
  const std::vector<PavementPart> parts = pavement_parts(scene);
  ENSURE(parts.size() == model.pavements.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const bool is_empty = model.pavements[i].layout.stones.empty();
    if (parts[i].is_kerb()) {
      if (is_empty) notes.push_back(no_kerb_laid(scene, parts[i], parts[i - 1]));
    } else if (is_empty) {
      notes.push_back(nothing_laid(scene, parts[i]));
    } else if (is_all_border(parts[i].pavement)) {
      notes.push_back(nothing_within(scene, parts[i]));
    }
  }
  return notes;
}

}  // namespace shatterpave::pipeline
