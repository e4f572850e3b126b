#include "studio/camera.h"

#include <gtest/gtest.h>

#include <cmath>

namespace shatterpave::studio {
namespace {

Camera looking(vec3 at_mm, vec3 look_at_mm) {
  Camera camera;
  camera.at_mm = at_mm;
  camera.look_at_mm = look_at_mm;
  return camera;
}

TEST(Camera, LooksWithTheUprightUp) {
  const View view = view_of(looking({0.0, -1000.0, 0.0}, {0.0, 0.0, 0.0}));
  EXPECT_EQ(view.forward, (vec3{0.0, 1.0, 0.0}));
  EXPECT_EQ(view.right, (vec3{1.0, 0.0, 0.0}));
  EXPECT_EQ(view.up, (vec3{0.0, 0.0, 1.0}));
}

TEST(Camera, StraightDownShowsAPlanAsItIsDrawn) {
  const View view = view_of(looking({5.0, 5.0, 900.0}, {5.0, 5.0, 0.0}));
  EXPECT_EQ(view.forward, (vec3{0.0, 0.0, -1.0}));
  EXPECT_EQ(view.right, (vec3{1.0, 0.0, 0.0}));
  EXPECT_EQ(view.up, (vec3{0.0, 1.0, 0.0}));
}

TEST(Camera, AxesAreUnitAtRightAnglesAndRightHandedAnywhere) {
  for (const vec3 at : {vec3{1, 2, 3}, vec3{-7, 1, -2}, vec3{0, 0, -5}, vec3{1e-9, 0, 5}, vec3{1e6, -1e6, 1}}) {
    const View view = view_of(looking(at, {0.0, 0.0, 0.0}));
    EXPECT_NEAR(glm::length(view.forward), 1.0, 1e-14);
    EXPECT_LT(glm::length(glm::cross(view.right, view.forward) - view.up), 1e-14);
    EXPECT_LT(glm::length(glm::cross(view.forward, view.up) - view.right), 1e-14);
    EXPECT_GE(view.up.z, 0.0);
  }
}

TEST(Camera, FieldOfViewUpThePictureFollowsFromItsShape) {
  EXPECT_NEAR(upright_field_of_view(Angle::degrees(90.0), 2.0).degrees(), 2.0 * std::atan(0.5) * 180.0 / pi, 1e-12);
  EXPECT_NEAR(upright_field_of_view(Angle::degrees(40.0), 1.0).degrees(), 40.0, 1e-12);
  Camera camera;
  EXPECT_EQ(aspect_of(camera), 4.0 / 3.0);
  camera.size_px = {1920, 1080};
  EXPECT_EQ(aspect_of(camera), 16.0 / 9.0);
}

TEST(Camera, LensIsThatOfFilm36MmWide) {
  Camera camera;
  camera.field_of_view = Angle::radians(2.0 * std::atan(18.0 / 50.0));
  EXPECT_NEAR(focal_length_mm(camera), 50.0, 1e-12);
  EXPECT_EQ(lens_radius_mm(camera), 0.0);
  camera.f_number = 2.0;
  EXPECT_NEAR(lens_radius_mm(camera), 12.5, 1e-12);
}

}  // namespace
}  // namespace shatterpave::studio
