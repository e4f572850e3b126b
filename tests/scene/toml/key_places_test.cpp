#include "scene/toml/key_places.h"

#include <gtest/gtest.h>

#include "scene/read_scene.h"

namespace shatterpave::scene {
namespace {

// Of a member that the file does not give, the place is that of the table where it would stand.
TEST(KeyPlaces, AreOfTheMemberOrOfItsTable) {
  const Scene scene = scene_of_text(
      "[[pavement]]\nname = \"p\"\nsize_mm = [900, 900]\n\n[pavement.textures]\nsize_px = 256\n\n[[pane]]\nname = "
      "\"w\"\nsize_mm = [90, 90]\n"
      "impact = [{at_mm = [9, 9]},\n  {at_mm = [5, 5]}]\n",
      "s.toml");
  const KeyPlaces& pavement = scene.pavement_places.front();
  EXPECT_EQ(pavement.place("textures.size_px"), (Place{"s.toml", 6, 11, "pavement[0].textures.size_px"}));
  EXPECT_EQ(pavement.place("textures.tile_mm"), (Place{"s.toml", 5, 1, "pavement[0].textures.tile_mm"}));
  EXPECT_EQ(pavement.place("surface.height_mm"), (Place{"s.toml", 1, 1, "pavement[0].surface.height_mm"}));
  EXPECT_EQ(pavement.place("bond"), (Place{"s.toml", 1, 1, "pavement[0].bond"}));
  EXPECT_EQ(pavement.place(""), (Place{"s.toml", 1, 1, "pavement[0]"}));
  const KeyPlaces& pane = scene.pane_places.front();
  EXPECT_EQ(pane.place("impact[1].at_mm"), (Place{"s.toml", 12, 12, "pane[0].impact[1].at_mm"}));
  EXPECT_EQ(pane.place("impact[1].speed_m_s"), (Place{"s.toml", 12, 3, "pane[0].impact[1].speed_m_s"}));
}

}  // namespace
}  // namespace shatterpave::scene
