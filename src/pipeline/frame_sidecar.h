// What is kept beside each frame of a shot: what it was made from, and the sums of its files. So the next run can tell whether
// it is there, whole, and the same.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shatterpave::pipeline {

struct FrameFile {
  std::string name;
  std::uint64_t bytes = 0;
  std::string sum;  // SHA-256

  bool operator==(const FrameFile&) const = default;
};

// What a frame's pixels follow from.
struct FrameOrigin {
  std::string version;      // of this program
  std::string scene;        // its name
  std::string fingerprint;  // of the scene at this frame (scene/shot.h): with its plans and pictures, and with what options set
  std::uint64_t seed = 0;
  int frame = 0;
  std::string quality;
  int width = 0;  // px
  int height = 0;

  // The name is not compared: it is the file's, in JSON without bytes that are not UTF-8.
  bool operator==(const FrameOrigin& other) const {
    return version == other.version && fingerprint == other.fingerprint && seed == other.seed && frame == other.frame &&
           quality == other.quality && width == other.width && height == other.height;
  }
};

// What it cost on the host that made it: the only part of a sidecar that differs between hosts.
struct FrameCost {
  double seconds = 0.0;               // from its begin to its end
  double renderer_seconds = 0.0;      // of these, the renderer's run
  double renderer_cpu_seconds = 0.0;  // its time on all processors
  std::int64_t most_memory_kib = 0;   // of the renderer or of this program, whichever had more
};

struct FrameRecord {
  FrameOrigin origin;
  std::vector<FrameFile> files;
  FrameCost cost;
};

// The name of a frame's file without its ending: "yard.0007".
std::string frame_stem(const std::string& scene, int frame);
std::string sidecar_name(const std::string& scene, int frame);

// JSON: {"format": "shatterpave-frame", "version": 1, …, "files": […], "cost": {…}}.
std::string sidecar_text(const FrameRecord& record);
// Nothing where the text is no sidecar of this form.
std::optional<FrameRecord> record_of(std::string_view text);

}  // namespace shatterpave::pipeline
