// What CrackMap says of regions, against faces walked from the polylines: random cracks grow in turns, and whenever one ends,
// the tips that are surrounded by now and were not before must be those within the region that it reports.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/angle.h"
#include "core/random.h"
#include "geometry/polygon.h"
#include "glass/gaps/crack_faces.h"
#include "glass/map/crack_map.h"

namespace shatterpave::glass {
namespace {

using geometry::LatticePoint;

const geometry::Polygon unit_square = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};

// Cracks that wander over a small square, from several places at once.
class Wandering {
 public:
  explicit Wandering(std::uint64_t seed) : seed_(seed), map_(unit_square, 0.05) {
    for (int hub = number(3); hub >= 0; --hub) start_at({200 + number(600), 200 + number(600)});
  }

  // Cracks from a new place, which may be a vertex of a crack, but not a tip.
  void start_more() {
    const auto on = map_.points(cracks_[static_cast<std::size_t>(number(static_cast<int>(cracks_.size())))]);
    const LatticePoint vertex = on[static_cast<std::size_t>(number(static_cast<int>(on.size()) - 1))];
    start_at(fraction() < 0.5 ? LatticePoint{200 + number(600), 200 + number(600)} : vertex);
  }

  // Lets one crack go on. Returns what was wrong with the report, if anything.
  std::vector<std::string> step() {
    const auto i = static_cast<std::size_t>(number(static_cast<int>(cracks_.size())));
    const int crack = cracks_[i];
    if (!map_.is_growing(crack)) return {};
    headings_[i] += 1.2 * (fraction() - 0.5);
    const double slowness = i % 2 == 0 ? 1.0 : 0.2;  // the slow ones are there to be enclosed
    const vec2 way = slowness * (5.0 + 40.0 * fraction()) * Angle::radians(headings_[i]).direction();
    const LatticePoint tip = map_.tip(crack);
    const std::vector<bool> before = surrounded();
    const auto arrest = map_.extend(crack, {tip.x + std::llround(way.x), tip.y + std::llround(way.y)});
    return arrest ? faults(before, *arrest) : std::vector<std::string>{};
  }

  int closings = 0;
  int enclosed = 0;

 private:
  double fraction() { return uniform(seed_, {Stream::turn, Id("wandering"), next_++}); }
  int number(int limit) { return static_cast<int>(limit * fraction()); }

  void start_at(LatticePoint at) {
    const CrackMap::Hub place = map_.add_hub(at);
    const int cracks = 1 + number(8);
    for (int i = 0; i < cracks; ++i) {
      headings_.push_back(2.0 * pi * (i + fraction()) / cracks);
      cracks_.push_back(map_.start(place, CrackKind::radial, 0, CrackEnd::At::impact));
    }
  }
  CrackFaces faces() const {
    std::vector<CrackFaces::Polyline> polylines;
    for (const int crack : cracks_) polylines.push_back(map_.points(crack));
    return CrackFaces(polylines);
  }
  std::vector<bool> surrounded() const {
    const CrackFaces all = faces();
    std::vector<bool> result;
    for (const int crack : cracks_) {
      result.push_back(map_.is_growing(crack) && !map_.pieces(crack).empty() && all.surround(map_.tip(crack)));
    }
    return result;
  }
  std::vector<std::string> faults(const std::vector<bool>& before, const Arrest& arrest) {
    geometry::Polygon region(arrest.closed_region.size());
    std::ranges::transform(arrest.closed_region, region.begin(), [](LatticePoint p) { return geometry::to_mm(p); });
    if (!region.empty()) ++closings;
    const std::vector<bool> after = surrounded();
    std::vector<std::string> found;
    for (std::size_t i = 0; i < cracks_.size(); ++i) {
      if (!map_.is_growing(cracks_[i]) || map_.pieces(cracks_[i]).empty() || before[i]) continue;
      const bool inside = !region.empty() && geometry::contains(region, geometry::to_mm(map_.tip(cracks_[i])));
      if (inside && !after[i]) found.emplace_back("a tip within the region that nothing surrounds");
      if (!inside && after[i]) found.emplace_back("a tip that is surrounded but not within the region");
      if (after[i]) ++enclosed;
    }
    return found;
  }

  std::uint64_t seed_;
  std::uint32_t next_ = 0;
  CrackMap map_;
  std::vector<int> cracks_;
  std::vector<double> headings_;
};

TEST(ClosedRegion, HoldsWhatCracksSurroundByNow) {
  int closings = 0;
  int enclosed = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    Wandering cracks(seed);
    for (int step = 0; step < 300; ++step) {
      if (step % 100 == 99) cracks.start_more();
      ASSERT_EQ(cracks.step(), std::vector<std::string>{}) << seed << ", step " << step;
    }
    closings += cracks.closings;
    enclosed += cracks.enclosed;
  }
  EXPECT_GT(closings, 500);
  EXPECT_GT(enclosed, 50);
}

}  // namespace
}  // namespace shatterpave::glass
