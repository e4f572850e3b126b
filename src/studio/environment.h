// A picture of all that is around a scene.
#pragma once

#include <memory>
#include <string>

namespace shatterpave::studio {

// A lat-long picture (studio/light.h), as its file holds it.
struct Environment {
  std::string ending;                          // "exr", "hdr" or "png"
  std::shared_ptr<const std::string> content;  // not null

  bool operator==(const Environment& other) const { return ending == other.ending && *content == *other.content; }
};

}  // namespace shatterpave::studio
