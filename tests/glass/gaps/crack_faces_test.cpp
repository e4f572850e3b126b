#include "glass/gaps/crack_faces.h"

#include <gtest/gtest.h>

namespace shatterpave::glass {
namespace {

using Polylines = std::vector<CrackFaces::Polyline>;

// A square with a crack that hangs into it, an island inside it that is closed itself, and a crack outside it.
const Polylines nested = {
    {{0, 0}, {100, 0}, {100, 100}, {0, 100}, {0, 0}},
    {{0, 50}, {10, 50}},
    {{40, 40}, {60, 40}, {60, 60}, {40, 40}},
    {{40, 40}, {30, 30}},
    {{58, 50}, {57, 50}},
    {{100, 50}, {120, 50}},
    {{150, 0}, {150, 90}},
};

TEST(CrackFaces, KnowWhatIsSurrounded) {
  const CrackFaces faces(nested);
  EXPECT_EQ(faces.count(), 2);
  EXPECT_TRUE(faces.surround({10, 50}));    // hangs into the square
  EXPECT_TRUE(faces.surround({30, 30}));    // of the island, in the square
  EXPECT_TRUE(faces.surround({58, 50}));    // by itself, in the island
  EXPECT_FALSE(faces.surround({120, 50}));  // hangs out of the square
  EXPECT_FALSE(faces.surround({150, 90}));
  EXPECT_TRUE(faces.surround({20, 20}));
  EXPECT_FALSE(faces.surround({110, 20}));
  EXPECT_TRUE(faces.surround_middle({0, 98}, {1, 99}));
  EXPECT_FALSE(faces.surround_middle({0, 98}, {-1, 99}));
}

TEST(CrackFaces, NeedAWholeWall) {
  Polylines broken = nested;
  broken[0] = {{0, 0}, {100, 0}, {100, 100}, {0, 100}, {0, 1}};
  const CrackFaces faces(broken);
  EXPECT_EQ(faces.count(), 1);
  EXPECT_FALSE(faces.surround({10, 50}));
  EXPECT_FALSE(faces.surround({30, 30}));
  EXPECT_TRUE(faces.surround({58, 50}));
}

}  // namespace
}  // namespace shatterpave::glass
