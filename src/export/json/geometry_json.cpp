// Written straight into a buffer rather than through a document: 100,000 stones are a million numbers. Each crack and each
// stone stands on a line of its own, so that two files can be compared by eye.
#include "export/json/geometry_json.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <iterator>
#include <string_view>

#include "export/names.h"
#include "studio/camera.h"
#include "studio/light.h"
#include "studio/world.h"

namespace shatterpave::exporting::json {

namespace {

using Buffer = fmt::memory_buffer;

// Adding 0 turns −0, which reads as a slip, into 0.
void put(Buffer& out, double value) { fmt::format_to(std::back_inserter(out), "{}", value + 0.0); }
void put(Buffer& out, std::string_view text) { out.append(text.data(), text.data() + text.size()); }

void put_text(Buffer& out, std::string_view text) {
  put(out, "\"");
  for (const char c : text) {
    if (c == '"' || c == '\\') out.push_back('\\');
    if (static_cast<unsigned char>(c) < 0x20) {
      fmt::format_to(std::back_inserter(out), "\\u{:04x}", static_cast<unsigned char>(c));
    } else {
      out.push_back(c);
    }
  }
  put(out, "\"");
}

void put_point(Buffer& out, vec2 p) {
  put(out, "[");
  put(out, p.x);
  put(out, ",");
  put(out, p.y);
  put(out, "]");
}

void put_place(Buffer& out, vec3 p) { fmt::format_to(std::back_inserter(out), "[{},{},{}]", p.x + 0.0, p.y + 0.0, p.z + 0.0); }

void put_degrees(Buffer& out, Angle angle) { put(out, std::round(angle.degrees() * 1e6) / 1e6); }

// A list in brackets, its elements written by `put_element`, `separator` between them.
template <typename List, typename PutElement>
void put_list(Buffer& out, const List& list, std::string_view separator, const PutElement& put_element) {
  put(out, "[");
  bool first = true;
  for (const auto& element : list) {
    put(out, first && separator.starts_with(',') ? separator.substr(1) : separator);
    first = false;
    put_element(element);
  }
  put(out, "]");
}

void put_points(Buffer& out, const std::vector<vec2>& points) {
  put_list(out, points, ",", [&](vec2 p) { put_point(out, p); });
}

void put_end(Buffer& out, const glass::CrackEnd& end) {
  fmt::format_to(std::back_inserter(out), "{{\"at\":\"{}\"", name_of(end.at));
  if (end.crack) fmt::format_to(std::back_inserter(out), ",\"crack\":{}", *end.crack);
  put(out, "}");
}

void put_impact(Buffer& out, const glass::ImpactCounts& impact) {
  put(out, "{\"at_mm\":");
  put_point(out, impact.at_mm);
  fmt::format_to(std::back_inserter(out), ",\"radial_count\":{},\"large_count\":{},\"circular_count\":{}", impact.radial_count,
                 impact.large_count, impact.circular_count);
  if (const auto& crater = impact.crater) {
    fmt::format_to(std::back_inserter(out),
                   ",\"crater\":{{\"crushed_radius_mm\":{},\"near_radius_mm\":{},\"far_radius_mm\":{},\"milky_radius_mm\":{}}}",
                   crater->crushed_radius_mm, crater->near_radius_mm, crater->far_radius_mm, crater->milky_radius_mm);
  }
  put(out, "}");
}

void put_crack(Buffer& out, const glass::Crack& crack) {
  fmt::format_to(std::back_inserter(out), "{{\"id\":{},\"impact\":{},\"kind\":\"{}\",\"points_mm\":", crack.id, crack.impact,
                 name_of(crack.kind));
  put_points(out, crack.points_mm);
  put(out, ",\"start\":");
  put_end(out, crack.start);
  put(out, ",\"end\":");
  put_end(out, crack.end);
  if (!crack.through) put(out, ",\"through\":false");
  put(out, "}");
}

// The motion as the rows of a 3 × 4 matrix. Its turn is rounded far below what a shard of a metre shows.
void put_motion(Buffer& out, const glass::Motion& motion) {
  put(out, "[");
  for (std::size_t row = 0; row < 3; ++row) {
    const vec3& turn = motion.rows[row];
    for (const double value : {turn.x, turn.y, turn.z}) {
      put(out, value);
      put(out, ",");
    }
    put(out, motion.shift_mm[row]);
    if (row < 2) put(out, ",");
  }
  put(out, "]");
}

void put_shard(Buffer& out, const glass::Shard& shard) {
  fmt::format_to(std::back_inserter(out), "{{\"id\":\"{}\",\"state\":\"{}\",\"outline_mm\":", shard.id, name_of(shard.state));
  put_points(out, shard.face.outline);
  put(out, ",\"holes_mm\":");
  put_list(out, shard.face.holes, ",", [&](const geometry::Polygon& hole) { put_points(out, hole); });
  if (shard.state != glass::ShardState::missing) {
    put(out, ",\"transform\":");
    put_motion(out, shard.motion);
  }
  if (!shard.joined.empty()) {
    put(out, ",\"joined\":");
    put_list(out, shard.joined, ",", [&](const std::string& id) { fmt::format_to(std::back_inserter(out), "\"{}\"", id); });
  }
  put(out, "}");
}

void put_stone(Buffer& out, const paving::Stone& stone) {
  fmt::format_to(std::back_inserter(out), "{{\"id\":{},\"part\":\"{}\",\"kind\":\"{}\",\"outline_mm\":", stone.id,
                 name_of(stone.part), name_of(stone.kind));
  put_points(out, stone.outline_mm);
  put(out, ",\"angle_deg\":");
  put_degrees(out, stone.angle);
  if (stone.sunk_mm > 0.0) fmt::format_to(std::back_inserter(out), ",\"sunk_mm\":{}", stone.sunk_mm);
  if (stone.colour >= 0) fmt::format_to(std::back_inserter(out), ",\"colour\":{}", stone.colour);
  put(out, "}");
}

// As the scene's own keys have it.
void put_camera(Buffer& out, const studio::Camera& camera) {
  put(out, " \"camera\":{\"at_mm\":");
  put_place(out, camera.at_mm);
  put(out, ",\"look_at_mm\":");
  put_place(out, camera.look_at_mm);
  put(out, ",\"field_of_view_deg\":");
  put_degrees(out, camera.field_of_view);
  if (camera.f_number) {
    fmt::format_to(std::back_inserter(out), ",\"focus_mm\":{},\"f_number\":{}", *camera.focus_mm, *camera.f_number);
  }
  if (camera.size_px) {
    fmt::format_to(std::back_inserter(out), ",\"size_px\":[{},{}]", (*camera.size_px)[0], (*camera.size_px)[1]);
  }
  put(out, "},\n");
}

// The same; of a picture beside the scene its name alone, since where it lies is no one else's.
void put_light(Buffer& out, const studio::Light& light) {
  put(out, " \"light\":{");
  if (!light.environment.empty()) {
    put(out, "\"environment\":");
    put_text(out, std::filesystem::path(light.environment).filename().string());
    put(out, ",");
  }
  put(out, "\"environment_turn_deg\":");
  put_degrees(out, light.environment_turn);
  if (light.environment_blur > Angle()) {
    put(out, ",\"environment_blur_deg\":");
    put_degrees(out, light.environment_blur);
  }
  fmt::format_to(std::back_inserter(out), ",\"environment_gain\":{}", light.environment_gain);
  if (light.sun) {
    put(out, ",\"sun_azimuth_deg\":");
    put_degrees(out, light.sun->azimuth);
    put(out, ",\"sun_elevation_deg\":");
    put_degrees(out, light.sun->elevation);
    fmt::format_to(std::back_inserter(out), ",\"sun_gain\":{}", light.sun->gain);
  }
  fmt::format_to(std::back_inserter(out), ",\"exposure_ev\":{}}},\n", light.exposure_ev + 0.0);
}

void put_placement(Buffer& out, const studio::Placement& placement) {
  if (placement == studio::Placement{}) return;
  put(out, ",\"place_mm\":");
  put_place(out, placement.at_mm);
  put(out, ",\"place_turn_deg\":");
  put_degrees(out, placement.turn);
}

void put_photograph(Buffer& out, const Photograph& photograph) {
  fmt::format_to(std::back_inserter(out),
                 ",\n  \"photograph\":{{\"size_px\":[{},{}],\"mm_per_px\":{},\"impact_px\":", photograph.width_px,
                 photograph.height_px, photograph.mm_per_px);
  put_point(out, photograph.impact_px);
  put(out, ",\"corners_px\":");
  put_list(out, photograph.corners_px, ",", [&](vec2 p) { put_point(out, p); });
  fmt::format_to(std::back_inserter(out), ",\"radial_interval\":[{},{}]}}", photograph.radial_interval[0],
                 photograph.radial_interval[1]);
}

void put_pane(Buffer& out, const BrokenPane& broken) {
  put(out, "{\"name\":");
  put_text(out, broken.pane.name);
  put(out, ",\"outline_mm\":");
  put_points(out, broken.pane.outline_mm);
  put(out, ",\"thickness_mm\":");
  put(out, broken.pane.thickness_mm);
  if (broken.pane.bow_mm != vec2{0.0, 0.0}) {
    put(out, ",\"bow_mm\":");
    put_point(out, broken.pane.bow_mm);
  }
  put_placement(out, broken.pane.placement);
  if (broken.photograph) put_photograph(out, *broken.photograph);
  put(out, ",\n  \"impacts\":");
  put_list(out, broken.network.impacts, ",\n   ", [&](const glass::ImpactCounts& impact) { put_impact(out, impact); });
  put(out, ",\n  \"cracks\":");
  const auto put_cracks = [&](const glass::CrackNetwork& network) {
    put_list(out, network.cracks, ",\n   ", [&](const glass::Crack& crack) { put_crack(out, crack); });
  };
  put_cracks(broken.network);
  if (!broken.far_network.cracks.empty()) {
    put(out, ",\n  \"far_cracks\":");
    put_cracks(broken.far_network);
  }
  if (broken.pane.shards) {
    put(out, ",\n  \"shards\":");
    put_list(out, broken.shards, ",\n   ", [&](const glass::Shard& shard) { put_shard(out, shard); });
  }
  put(out, "}");
}

void put_pavement(Buffer& out, const PavedArea& paved) {
  put(out, "{\"name\":");
  put_text(out, paved.pavement.name);
  put(out, ",\"outline_mm\":");
  put_points(out, paved.pavement.area.outline);
  put(out, ",\"holes_mm\":");
  put_list(out, paved.pavement.area.holes, ",", [&](const geometry::Polygon& hole) { put_points(out, hole); });
  put_placement(out, paved.pavement.placement);
  put(out, ",\n  \"stones\":");
  put_list(out, paved.layout.stones, ",\n   ", [&](const paving::Stone& stone) { put_stone(out, stone); });
  if (!paved.layout.missing.empty()) {
    put(out, ",\n  \"missing\":");
    put_list(out, paved.layout.missing, ",\n   ", [&](const paving::Stone& stone) { put_stone(out, stone); });
  }
  put(out, "}");
}

}  // namespace

OutputFile json_file(const Model& model) {
  Buffer out;
  fmt::format_to(std::back_inserter(out), "{{\"format\":\"shatterpave-geometry\",\"version\":1,\"seed\":{},\n", model.seed);
  if (model.camera) put_camera(out, *model.camera);
  if (model.light) put_light(out, *model.light);
  put(out, " \"panes\":");
  put_list(out, model.panes, ",\n  ", [&](const BrokenPane& pane) { put_pane(out, pane); });
  put(out, ",\n \"pavements\":");
  put_list(out, model.pavements, ",\n  ", [&](const PavedArea& paved) { put_pavement(out, paved); });
  put(out, "}\n");
  return {model.name + ".json", fmt::to_string(out)};
}

void append(const Model& model, Outputs& outputs) { outputs.files.push_back(json_file(model)); }

}  // namespace shatterpave::exporting::json
