#include "pipeline/frame_sidecar.h"

#include <fmt/format.h>

#include <cmath>
#include <exception>
#include <nlohmann/json.hpp>

#include "scene/frame_range.h"

namespace shatterpave::pipeline {

namespace {

using SidecarJson = nlohmann::ordered_json;

constexpr std::string_view sidecar_format = "shatterpave-frame";
constexpr int sidecar_version = 1;

// Names are bytes, which JSON takes in UTF-8 alone.
SidecarJson text_json(const std::string& bytes) {
  return SidecarJson::parse(SidecarJson(bytes).dump(-1, ' ', false, SidecarJson::error_handler_t::replace));
}

double in_milliseconds(double seconds) { return std::round(1e3 * seconds) / 1e3; }

}  // namespace

std::string frame_stem(const std::string& scene, int frame) { return fmt::format("{}.{}", scene, scene::frame_digits(frame)); }

std::string sidecar_name(const std::string& scene, int frame) { return frame_stem(scene, frame) + ".frame.json"; }

std::string sidecar_text(const FrameRecord& record) {
  const FrameOrigin& origin = record.origin;
  SidecarJson files = SidecarJson::array();
  for (const FrameFile& file : record.files) {
    files.push_back({{"name", text_json(file.name)}, {"bytes", file.bytes}, {"sha256", file.sum}});
  }
  const SidecarJson json{{"format", sidecar_format},
                         {"version", sidecar_version},
                         {"program", origin.version},
                         {"scene", text_json(origin.scene)},
                         {"fingerprint", origin.fingerprint},
                         {"seed", origin.seed},
                         {"frame", origin.frame},
                         {"quality", origin.quality},
                         {"size_px", {origin.width, origin.height}},
                         {"files", files},
                         {"cost",
                          {{"seconds", in_milliseconds(record.cost.seconds)},
                           {"renderer_seconds", in_milliseconds(record.cost.renderer_seconds)},
                           {"renderer_cpu_seconds", in_milliseconds(record.cost.renderer_cpu_seconds)},
                           {"most_memory_kib", record.cost.most_memory_kib}}}};
  return json.dump(1) + "\n";
}

std::optional<FrameRecord> record_of(std::string_view text) {
  try {
    const SidecarJson json = SidecarJson::parse(text);
    if (json.at("format") != sidecar_format || json.at("version") != sidecar_version) return std::nullopt;
    FrameRecord record;
    record.origin = {json.at("program"), json.at("scene"),   json.at("fingerprint"),   json.at("seed"),
                     json.at("frame"),   json.at("quality"), json.at("size_px").at(0), json.at("size_px").at(1)};
    for (const SidecarJson& file : json.at("files"))
      record.files.push_back({file.at("name"), file.at("bytes"), file.at("sha256")});
    const SidecarJson& cost = json.at("cost");
    record.cost = {cost.at("seconds"), cost.at("renderer_seconds"), cost.at("renderer_cpu_seconds"),
                   cost.at("most_memory_kib")};
    return record;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace shatterpave::pipeline
