#include <gtest/gtest.h>
#include <shatterpave/generate.h>
#include <shatterpave/version.h>

#include <algorithm>
#include <atomic>
#include <locale>
#include <stdexcept>
#include <thread>

#include "face/scenes.h"

namespace shatterpave {

namespace {

Scene both() {
  Scene scene = small_pane();
  scene.add_pavement("court", {{0, 0}, {900, 0}, {900, 700}, {0, 700}});
  return scene;
}

TEST(FaceGenerate, TellsItsProgressToTheEnd) {
  std::vector<double> parts;
  generate(both(), {.threads = 1, .progress = [&](std::string_view what, double done) {
                      EXPECT_FALSE(what.empty());
                      parts.push_back(done);
                    }});
  ASSERT_GE(parts.size(), 3U);
  EXPECT_EQ(parts.back(), 1.0);
  EXPECT_TRUE(std::ranges::is_sorted(parts));
}

TEST(FaceGenerate, StopsWhereItIsAskedTo) {
  EXPECT_THROW(generate(both(), {.cancelled = [] { return true; }}), Interrupted);
  std::atomic<int> calls{0};
  EXPECT_THROW(generate(both(), {.cancelled = [&] { return ++calls > 3; }}), Interrupted);
  EXPECT_GT(calls, 3);
  generate(both(), {.cancelled = [] { return false; }});
}

struct Own : std::runtime_error {
  using std::runtime_error::runtime_error;
};

TEST(FaceGenerate, ExceptionsOfCallbacksLeaveIt) {
  EXPECT_THROW(generate(both(), {.progress = [](std::string_view, double) { throw Own("progress"); }}), Own);
  EXPECT_THROW(generate(both(), {.cancelled = []() -> bool { throw Own("cancelled"); }}), Own);
  EXPECT_THROW(generate(both(), {.progress =
                                     [](std::string_view, double done) {
                                       if (done == 1.0) throw Own("end");
                                     }}),
               Own);
}

TEST(FaceGenerate, RefusesThreadsOutOfTheirRange) {
  for (const int threads : {-1, 1025}) EXPECT_THROW(generate(both(), {.threads = threads}), InputError) << threads;
}

TEST(FaceGenerate, IsTheSameWithAnyNumberOfThreads) {
  const Scene scene = both();
  const std::string one = json_of(generate(scene, {.threads = 1}));
  for (const int threads : {0, 2, 7}) EXPECT_EQ(json_of(generate(scene, {.threads = threads})), one) << threads;
}

// As a program that uses the library may have set it.
TEST(FaceGenerate, IsTheSameInAnyLocale) {
  const std::string here = json_of(generate(both()));
  const std::locale before = std::locale::global(std::locale("de_DE.UTF-8"));
  const std::string there = json_of(generate(both()));
  Scene scene = both();
  scene.set("pane.window.thickness_mm", 4.5);
  EXPECT_EQ(Value(1234.5).toml(), "1234.5");
  EXPECT_EQ(Value(1234567).toml(), "1234567");
  const Model thick = generate(scene);
  std::locale::global(before);
  EXPECT_EQ(there, here);
  EXPECT_EQ(thick.panes().at(0).thickness_mm, 4.5);
}

// Each call has its own options: that one is stopped does not show in the others.
TEST(FaceGenerate, CallsFromSeveralThreadsKnowNothingOfOneAnother) {
  const Scene scene = both();
  const std::string alone = json_of(generate(scene));
  std::atomic<int> right{0};
  std::atomic<int> stopped{0};
  {
    std::vector<std::jthread> callers;
    callers.reserve(6);
    for (int caller = 0; caller < 6; ++caller) {
      callers.emplace_back([&, caller] {
        for (int repeat = 0; repeat < 3; ++repeat) {
          std::atomic<int> calls{0};
          try {
            const Model model =
                generate(scene, {.threads = 1 + caller % 2, .cancelled = [&] { return caller % 3 == 0 && ++calls > 2; }});
            if (json_of(model) == alone && model.stone_mesh(0, 0).triangles.size() > 3) ++right;
          } catch (const Interrupted&) {
            ++stopped;
          }
        }
      });
    }
  }
  EXPECT_EQ(right, 12);
  EXPECT_EQ(stopped, 6);
}

TEST(FaceGenerate, OneModelServesSeveralThreads) {
  const Model model = generate(both());
  std::atomic<std::size_t> cracks{0};
  std::atomic<std::size_t> triangles{0};
  {
    std::vector<std::jthread> callers;
    callers.reserve(4);
    for (int caller = 0; caller < 4; ++caller) {
      callers.emplace_back([&] {
        cracks += model.panes().at(0).cracks.size();
        triangles += model.stone_mesh(0, 1).triangles.size();
      });
    }
  }
  EXPECT_EQ(cracks, 4 * model.panes().at(0).cracks.size());
  EXPECT_EQ(triangles, 4 * model.stone_mesh(0, 1).triangles.size());
}

TEST(FaceVersion, IsThatOfTheHeader) { EXPECT_STREQ(version(), SHATTERPAVE_VERSION); }

}  // namespace

}  // namespace shatterpave
