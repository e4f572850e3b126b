// Lays random pavements and writes each as a line of JSON, for judge_layouts.py.
//
//    random_layouts --first N --count M [--rare|--sized] [FILE.geojson …]    numbers N … N + M − 1, with the areas of these
//    files among
//                                            theirs; --rare: stones larger than their area, joints wider than stones, and the
//                                            like; --sized: packed stones whose sizes follow a field
//    random_layouts --scene FILE.toml …      the pavements of these scenes
//
// With --measured before them lines also hold what the scorer finds.
// A line is a pure function of its number, of the files and of the program. It holds the scene file that makes it.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "geometry/lattice.h"
#include "geometry/region_index.h"
#include "layouts/random_pavement.h"
#include "measure/bare_spot.h"
#include "measure/stone_index.h"
#include "paving/bonds/border.h"
#include "paving/bonds/table.h"
#include "paving/laying.h"
#include "pipeline/parts.h"
#include "scene/plans/plan_areas.h"
#include "scene/read_scene.h"

namespace {

using namespace shatterpave;

constexpr std::uint64_t most_attempts = 30;

std::string json_text(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    if (c == '\n') {
      result += "\\n";
    } else {
      result += c;
    }
  }
  return result + "\"";
}

// In micrometres.
void put_ring(std::string& out, const geometry::Polygon& ring) {
  out += '[';
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto p = geometry::to_lattice(ring[i]);
    fmt::format_to(std::back_inserter(out), "{}[{},{}]", i > 0 ? "," : "", p.x, p.y);
  }
  out += ']';
}

std::string_view name_of(const paving::Direction& direction) {
  constexpr std::string_view names[] = {"constant", "boundary", "radial", "guides", "grid"};
  return names[direction.index()];
}

std::string_view name_of(paving::BorderCourse course) {
  if (course == paving::BorderCourse::none) return "none";
  return course == paving::BorderCourse::soldier ? "soldier" : "stretcher";
}

void put_pavement(std::string& out, const paving::Pavement& pavement) {
  const auto to = std::back_inserter(out);
  fmt::format_to(to, ",\"bond\":\"{}\",\"field\":\"{}\",\"stone_mm\":[{},{}],\"joint_mm\":{}",
                 std::string_view(paving::type_of(pavement).name), name_of(pavement.direction), pavement.stone_mm.x,
                 pavement.stone_mm.y, pavement.joint_mm);
  const vec2 border = paving::border_stone_mm(pavement);
  fmt::format_to(to, ",\"border\":\"{}\",\"border_stone_mm\":[{},{}],\"missing\":{},\"by_hand\":{},",
                 name_of(pavement.border.course), border.x, border.y, pavement.variation.missing, pavement.hand.amount);
  if (pavement.hand.rounded) fmt::format_to(to, "\"rounded\":{},", *pavement.hand.rounded);
  if (pavement.hand.nibbled) fmt::format_to(to, "\"nibbled\":{},", *pavement.hand.nibbled);
  if (paving::has_sizes(pavement)) {
    const paving::SizeRange sizes = paving::size_range(pavement);
    fmt::format_to(to, "\"sizes\":[{},{}],", sizes.smallest, sizes.largest);
  }
  out += "\"outline_um\":";
  put_ring(out, pavement.area.outline);
  out += ",\"holes_um\":[";
  for (std::size_t h = 0; h < pavement.area.holes.size(); ++h) {
    if (h > 0) out += ',';
    put_ring(out, pavement.area.holes[h]);
  }
  out += ']';
}

void put_layout(std::string& out, const paving::StoneLayout& layout) {
  out += ",\"stones\":[";
  for (std::size_t s = 0; s < layout.stones.size(); ++s) {
    const paving::Stone& stone = layout.stones[s];
    fmt::format_to(std::back_inserter(out),
                   "{}{{\"kind\":\"{}\",\"part\":\"{}\",\"angle_deg\":{:.6f},\"outline_um\":", s > 0 ? "," : "",
                   stone.kind == paving::StoneKind::whole ? "whole" : "cut",
                   stone.part == paving::StonePart::field ? "field" : "border", stone.angle.degrees());
    put_ring(out, stone.outline_mm);
    out += '}';
  }
  out += ']';
}

void put_measured(std::string& out, const paving::Pavement& pavement, const paving::StoneLayout& layout) {
  const measure::StoneIndex index(layout, std::max(pavement.stone_mm.x, pavement.stone_mm.y) + pavement.joint_mm);
  const geometry::Circle spot = measure::widest_bare_spot(pavement, layout, index, geometry::RegionIndex(pavement.area));
  fmt::format_to(std::back_inserter(out), ",\"measured_bare_mm\":{},\"measured_at_mm\":[{},{}]", 2.0 * spot.radius,
                 spot.middle.x, spot.middle.y);
}

// The line of one pavement of a scene; `head` is the start of its JSON.
void print_line(std::string head, const paving::Pavement& pavement, std::uint64_t seed, bool with_measures) {
  put_pavement(head, pavement);
  try {
    const paving::StoneLayout layout = paving::laid_stones(pavement, seed);
    put_layout(head, layout);
    if (with_measures) put_measured(head, pavement, layout);
  } catch (const InputError& error) {
    head += ",\"refused\":" + json_text(error.what());
  } catch (const std::exception& error) {
    head += ",\"failed\":" + json_text(error.what());
  }
  fmt::print("{}}}\n", head);
}

void print_scene(const std::string& file, bool with_measures) {
  const scene::Scene scene = scene::scene_of_file(file);
  for (const pipeline::PavementPart& part : pipeline::pavement_parts(scene)) {
    const std::string head =
        fmt::format("{{\"number\":{},\"shape\":\"own\",\"toml\":\"\"", json_text(file + ": " + part.pavement.name));
    print_line(head, part.pavement, scene.seed, with_measures);
  }
}

struct Wanted {
  layouts::Kind kind = layouts::Kind::usual;
  std::vector<geometry::Region> places;
  bool measures = false;
};

void print_number(std::uint64_t number, const Wanted& wanted) {
  std::string why;
  for (std::uint64_t attempt = 0; attempt < most_attempts; ++attempt) {
    const layouts::DrawnScene drawn = layouts::random_scene(number, attempt, wanted.kind, wanted.places);
    scene::Scene scene;
    try {
      scene = scene::scene_of_text(drawn.toml, "layout.toml");
    } catch (const InputError& error) {  // an outline that crosses itself, or a hole that leaves it
      why = error.what();
      continue;
    }
    print_line(fmt::format("{{\"number\":{},\"attempt\":{},\"shape\":\"{}\",\"toml\":{}", number, attempt, drawn.shape,
                           json_text(drawn.toml)),
               scene.pavements.front(), scene.seed, wanted.measures);
    return;
  }
  throw std::runtime_error(fmt::format("number {}: no scene in {} attempts: {}", number, most_attempts, why));
}

std::uint64_t number_of(std::string_view text) {
  std::uint64_t number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc{} || read.ptr != text.data() + text.size()) {
    throw std::runtime_error(fmt::format("expected a number, got '{}'", text));
  }
  return number;
}

void print_all(std::span<char*> arguments) {
  std::uint64_t first = 1;
  std::uint64_t count = 0;
  bool scenes = false;
  Wanted wanted;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string_view argument = arguments[i];
    if ((argument == "--first" || argument == "--count") && i + 1 < arguments.size()) {
      (argument == "--first" ? first : count) = number_of(arguments[++i]);
    } else if (argument == "--rare") {
      wanted.kind = layouts::Kind::rare;
    } else if (argument == "--sized") {
      wanted.kind = layouts::Kind::sized;
    } else if (argument == "--measured") {
      wanted.measures = true;
    } else if (argument == "--scene") {
      scenes = true;
    } else if (scenes) {
      print_scene(arguments[i], wanted.measures);
    } else {
      for (geometry::Region& area : scene::areas_of_file(argument)) wanted.places.push_back(std::move(area));
    }
  }
  for (std::uint64_t number = first; number < first + count; ++number) print_number(number, wanted);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    print_all(std::span(argv, static_cast<std::size_t>(argc)).subspan(1));
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "random_layouts: {}\n", error.what());
    return 1;
  }
}
