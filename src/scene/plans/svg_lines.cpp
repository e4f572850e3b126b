#include "scene/plans/svg_lines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "core/disjoint_sets.h"

namespace shatterpave::scene {

namespace {

// End 2 i is where piece i starts, end 2 i + 1 where it stops.
using Ends = std::vector<vec2>;

// Numbers of places, the same for ends that hang together in steps of at most the tolerance.
class Places {
 public:
  Places(const Ends& ends, double tolerance_mm) : places_(ends.size()) {
    Cells cells;
    // Places beyond all plans, and those that are no numbers, which are refused later, share a cell.
    constexpr double farthest = 1e15;
    const auto along = [&](double mm) { return std::abs(mm / tolerance_mm) < farthest ? std::llround(mm / tolerance_mm) : 0; };
    const auto cell_of = [&](vec2 p) { return std::pair{along(p.x), along(p.y)}; };
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const auto [column, row] = cell_of(ends[i]);
      for (std::int64_t c = column - 1; c <= column + 1; ++c) {
        for (std::int64_t r = row - 1; r <= row + 1; ++r) {
          const auto found = cells.find({c, r});
          if (found != cells.end()) join(i, found->second, ends, tolerance_mm);
        }
      }
      // Of ends in one point the first stands for all; in a crowd some do.
      constexpr std::size_t crowd = 16;
      auto& here = cells[{column, row}];
      if (here.size() < crowd && std::ranges::none_of(here, [&](std::size_t other) { return ends[other] == ends[i]; }))
        here.push_back(i);
    }
  }

  std::size_t operator[](std::size_t end) { return places_.of(end); }

 private:
  using Cells = std::map<std::pair<std::int64_t, std::int64_t>, std::vector<std::size_t>>;

  // An end to those of the others that are near.
  void join(std::size_t end, const std::vector<std::size_t>& others, const Ends& ends, double tolerance_mm) {
    for (const std::size_t other : others) {
      if (glm::distance(ends[end], ends[other]) <= tolerance_mm) places_.join(end, other);
    }
  }

  DisjointSets places_;
};

// The ends at each place of pieces that are left when those that end nowhere are taken away, again and again.
std::vector<std::vector<std::size_t>> meeting_ends(std::size_t piece_count, Places& places) {
  std::vector<std::vector<std::size_t>> at(2 * piece_count);
  for (std::size_t end = 0; end < 2 * piece_count; ++end) at[places[end]].push_back(end);
  std::vector<std::size_t> loose;
  for (std::size_t place = 0; place < at.size(); ++place) {
    if (at[place].size() == 1) loose.push_back(place);
  }
  while (!loose.empty()) {
    const std::size_t place = loose.back();
    loose.pop_back();
    if (at[place].size() != 1) continue;
    const std::size_t end = at[place].front();
    at[place].clear();
    const std::size_t other = places[end ^ 1U];
    std::erase(at[other], end ^ 1U);
    if (at[other].size() == 1) loose.push_back(other);
  }
  return at;
}

// Rings as the ends at which their pieces are entered.
std::vector<std::vector<std::size_t>> rings_of(std::size_t piece_count, Places& places) {
  const auto at = meeting_ends(piece_count, places);
  std::vector<bool> used(piece_count, false);
  std::vector<std::vector<std::size_t>> rings;
  for (std::size_t piece = 0; piece < piece_count; ++piece) {
    const auto& here = at[places[2 * piece]];
    if (used[piece] || std::ranges::find(here, 2 * piece) == here.end()) continue;
    std::vector<std::size_t> ring;
    bool clear = true;
    for (std::size_t end = 2 * piece; !used[end / 2];) {
      used[end / 2] = true;
      ring.push_back(end);
      const std::size_t leaving = end ^ 1U;
      const auto& met = at[places[leaving]];
      if (met.size() != 2) {
        clear = false;
        break;
      }
      end = met[0] == leaving ? met[1] : met[0];
    }
    clear = clear && here.size() == 2;
    if (clear && ring.size() > 1) rings.push_back(std::move(ring));
  }
  return rings;
}

Ring joined_ring(const std::vector<std::size_t>& entered, const std::vector<const PlanShape*>& lines) {
  Ring ring{{}, lines[entered.front() / 2]->rings.front().place};
  for (const std::size_t end : entered) {
    std::vector<vec2> points = lines[end / 2]->rings.front().points_mm;
    if (end % 2 == 1) std::ranges::reverse(points);
    // Where it stops the next one starts.
    ring.points_mm.insert(ring.points_mm.end(), points.begin(), points.end() - 1);
  }
  return ring;
}

// The area of the pieces of one group, if they have one.
std::optional<PlanShape> joined_area(const std::vector<OutlinePiece>& pieces, double tolerance_mm, const Plan& plan) {
  std::vector<const PlanShape*> lines;
  Ends ends;
  for (const OutlinePiece& piece : pieces) {
    lines.push_back(&plan.shapes[piece.line]);
    const std::vector<vec2>& points = lines.back()->rings.front().points_mm;
    ends.push_back(points.front());
    ends.push_back(points.back());
  }
  Places places(ends, tolerance_mm);
  PlanShape area;
  area.filling = FillRule::evenodd;
  area.open = true;
  area.asked_for = AskedFor::areas_alone;
  std::vector<std::size_t> members;
  for (const auto& entered : rings_of(pieces.size(), places)) {
    Ring ring = joined_ring(entered, lines);
    if (!has_area(ring)) continue;
    area.rings.push_back(std::move(ring));
    for (const std::size_t end : entered) members.push_back(end / 2);
  }
  if (members.empty()) return std::nullopt;
  area.clips = lines[members.front()]->clips;
  for (const std::size_t member : members) {
    const PlanShape& line = *lines[member];
    if (pieces[member].area) area.parts.push_back(*pieces[member].area);
    if (line.unfollowed) area.unfollowed = line.unfollowed;
    if (line.clips != area.clips) {
      area.unfollowed = Note{line.rings.front().place, "expected lines of one outline with the same clip path, got others"};
    }
  }
  return area;
}

// Classes that all pieces have by themselves are those of the outline.
PlanFeature joined_feature(const std::vector<OutlinePiece>& pieces, const Plan& plan) {
  PlanFeature feature;
  feature.group = pieces.front().group;
  feature.classes = plan.features[plan.shapes[pieces.front().line].feature].classes;
  for (const OutlinePiece& piece : pieces) {
    const auto& classes = plan.features[plan.shapes[piece.line].feature].classes;
    std::erase_if(feature.classes, [&](const std::string& name) { return std::ranges::find(classes, name) == classes.end(); });
  }
  return feature;
}

}  // namespace

void join_lines(const std::vector<OutlinePiece>& pieces, double tolerance_mm, Plan& plan) {
  std::map<std::optional<std::size_t>, std::vector<OutlinePiece>> groups;
  for (const OutlinePiece& piece : pieces) groups[piece.group].push_back(piece);
  for (const auto& [group, members] : groups) {
    auto area = joined_area(members, tolerance_mm, plan);
    if (!area) continue;
    PlanFeature feature = joined_feature(members, plan);
    area->feature = plan.features.size();
    plan.features.push_back(std::move(feature));
    plan.shapes.push_back(std::move(*area));
  }
}

}  // namespace shatterpave::scene
