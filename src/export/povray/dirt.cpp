#include "export/povray/dirt.h"

#include <fmt/format.h>

#include "core/random.h"
#include "export/povray/sdl.h"
#include "geometry/polygon.h"

namespace shatterpave::exporting::povray {

std::string dirt_text(const glass::Pane& pane, const std::string& prefix, std::uint64_t seed) {
  if (pane.dirt == 0.0) return {};
  const geometry::Box box = geometry::bounding_box(pane.outline_mm);
  // The pattern goes on for ever; 1000 is far more than the 50 that the two sides are apart in it.
  const double place = 1000.0 * uniform(seed, {Stream::dirt, Id(pane.name)});
  return fmt::format(
      "#include \"shatterpave_dirt.inc\"\n"
      "#declare {0}_Dirt =\ntexture {{\n   pigment {{\n"
      "      function {{ {1} * Shatterpave_Dirt_On(x, y, z, {2}, {3}, {4}, {5}, {6}) }}\n"
      "      color_map {{ Shatterpave_Dirt_Colours }}\n   }}\n   finish {{ Shatterpave_Dirt_Finish }}\n}}\n\n",
      prefix, number(pane.dirt), number(box.low.x), number(box.low.y), number(box.high.x), number(box.high.y), number(place));
}

std::vector<std::string> dirt_lines(const glass::Pane& pane, const std::string& prefix) {
  if (pane.dirt == 0.0) return {};
  std::vector<std::string> lines{
      fmt::format("   {0}_Dirt       texture of the dirt that lies over the faces of {0}_Pane", prefix)};
  if (pane.shards) lines.push_back(fmt::format("   {0}_Old        texture of these faces with it: Old of {0}_Pane", prefix));
  return lines;
}

}  // namespace shatterpave::exporting::povray
