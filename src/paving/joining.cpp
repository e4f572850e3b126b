// A paviour who meets the border a few centimetres after a whole stone cuts longer stones for the last row, so that joints run
// straight to the border. So a small piece is either given to one neighbour, or shared out among those that lie along one of
// its sides, with the joints between them prolonged through it. What leaves the stones most nearly convex is done.
#include "paving/joining.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <tuple>

#include "core/parallel.h"
#include "geometry/clip.h"
#include "geometry/hull.h"
#include "geometry/lattice.h"
#include "paving/contact.h"

namespace shatterpave::paving {

namespace {

using geometry::Polygon;

// Joined stones grow to this many whole ones at most, if there is another way; by eye.
constexpr double largest_joined = 1.5;
// Hollows that differ by less than this part of a stone are alike to the eye; by eye.
constexpr double least_hollow = 0.02;
// Sides that turn by less than this are one row of neighbours: cosine of 25°, beyond which a bend is a corner.
constexpr double row_cosine = 0.906;

// A neighbour of a small piece, and where on the outline of that the two touch.
struct Touch {
  std::size_t host = 0;
  Contact contact;
};

// What becomes of a neighbour.
struct Grown {
  std::size_t host = 0;
  Polygon outline_mm;
};

struct Joining {
  std::vector<Grown> grown;
  bool falls_apart = false;  // one of them, since it would hold by a neck that the joint takes
  bool too_large = false;    // one of them
  double hollow_mm2 = 0.0;   // between them and their convex hulls, more than before
  double shared_mm = 0.0;    // joints that are no more
};

vec2 direction(const Polygon& polygon, std::size_t side) {
  return glm::normalize(polygon[(side + 1) % polygon.size()] - polygon[side]);
}

double length(const Polygon& polygon, std::size_t side) {
  return glm::length(polygon[(side + 1) % polygon.size()] - polygon[side]);
}

// Whether contact `b` begins where `a` ends, and the outline does not turn a corner there.
bool adjoin(const Polygon& outline, const Contact& a, const Contact& b) {
  constexpr double same_place_mm = 2.0 * same_line_mm;
  if (a.side == b.side) return std::abs(b.from_mm - a.to_mm) <= same_place_mm;
  return b.side == (a.side + 1) % outline.size() && a.to_mm >= length(outline, a.side) - same_place_mm &&
         b.from_mm <= same_place_mm && glm::dot(direction(outline, a.side), direction(outline, b.side)) >= row_cosine;
}

// Neighbours in a row along the outline, in its order.
std::vector<std::vector<Touch>> rows_of(const Polygon& outline, std::vector<Touch> touches) {
  std::ranges::sort(touches, {}, [](const Touch& t) { return std::tuple(t.contact.side, t.contact.from_mm, t.host); });
  const std::size_t n = touches.size();
  std::vector<std::vector<Touch>> rows;
  for (std::size_t i = 0; i < n; ++i) {
    if (adjoin(outline, touches[(i + n - 1) % n].contact, touches[i].contact)) continue;
    auto& row = rows.emplace_back();
    row.push_back(touches[i]);
    for (std::size_t j = (i + 1) % n; adjoin(outline, row.back().contact, touches[j].contact); j = (j + 1) % n) {
      row.push_back(touches[j]);
    }
  }
  return rows;
}

// A line across the outline, at a point of it, where a joint between neighbours meets it.
struct Cut {
  vec2 at{0.0, 0.0};
  vec2 along{1.0, 0.0};  // the outline, unit
};

// What lies between two cuts; `reach` from the points of them.
Polygon slab(const Cut& from, const Cut& to, double reach) {
  const vec2 across_from = reach * left_of(from.along);
  const vec2 across_to = reach * left_of(to.along);
  return {geometry::on_lattice(from.at - across_from), geometry::on_lattice(to.at - across_to),
          geometry::on_lattice(to.at + across_to), geometry::on_lattice(from.at + across_from)};
}

// The outline in parts, one for each host of the row. Nothing if joints cross within it, or a host comes twice.
std::optional<std::vector<Grown>> shared_out(const Polygon& outline, const std::vector<Touch>& row) {
  const geometry::Box box = geometry::bounding_box(outline);
  const double reach = glm::length(box.high - box.low) + 1.0;
  std::vector<std::size_t> hosts{row.front().host};
  std::vector<Cut> cuts(1);
  for (std::size_t i = 0; i + 1 < row.size(); ++i) {
    if (row[i].host == row[i + 1].host) continue;
    if (std::ranges::find(hosts, row[i + 1].host) != hosts.end()) return std::nullopt;
    hosts.push_back(row[i + 1].host);
    const Contact& before = row[i].contact;
    const vec2 along = direction(outline, before.side);
    cuts.push_back(
        {outline[before.side] + before.to_mm * along, glm::normalize(along + direction(outline, row[i + 1].contact.side))});
  }
  if (hosts.size() < 2) return std::nullopt;
  cuts.front() = {cuts[1].at - reach * cuts[1].along, cuts[1].along};
  cuts.push_back({cuts.back().at + reach * cuts.back().along, cuts.back().along});
  std::vector<Grown> parts;
  for (std::size_t i = 0; i < hosts.size(); ++i) {
    const Polygon within = slab(cuts[i], cuts[i + 1], reach);
    if (!geometry::is_simple(within) || geometry::area(within) <= 0.0) return std::nullopt;
    auto part = geometry::intersection(outline, {within, {}});
    if (part.size() != 1 || !part.front().holes.empty()) return std::nullopt;
    parts.push_back({hosts[i], std::move(part.front().outline)});
  }
  return parts;
}

class Joiner {
 public:
  Joiner(std::vector<Piece> pieces, const Cells& cells, const StoneSize& size)
      : pieces_(std::move(pieces)), cells_(cells), stone_area_(size.whole_face_mm2), joint_mm_(size.joint_mm) {
    of_cell_.resize(cells.count());
    cells_of_.resize(pieces_.size());
    waits_.resize(pieces_.size());
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      of_cell_[pieces_[p].cell].push_back(p);
      cells_of_[p] = {pieces_[p].cell};
    }
  }

  std::vector<Piece> join_small() && {
    std::vector<double> face(pieces_.size(), stone_area_);
    parallel_for(pieces_.size(), [&](std::size_t p) {
      // Of the others only the odd ones at irregular spots can be small; to look at all would take as long as laying them.
      if (pieces_[p].cut || geometry::area(pieces_[p].outline_mm) < stone_area_) face[p] = face_area(pieces_[p]);
    });
    std::vector<std::size_t> small;
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      if (is_small(face[p])) small.push_back(p);
    }
    std::ranges::stable_sort(small, [&](std::size_t a, std::size_t b) { return face[a] < face[b]; });
    for (const std::size_t p : small) waits_[p] = true;
    for (const std::size_t p : small) {
      waits_[p] = false;
      // It may have grown by another that joined it.
      if (!pieces_[p].outline_mm.empty() && is_small(face_area(pieces_[p]))) join(p);
    }
    std::erase_if(pieces_, [](const Piece& piece) { return piece.outline_mm.empty(); });
    return std::move(pieces_);
  }

 private:
  bool is_small(double face_area) const { return face_area < least_piece * stone_area_; }

  double face_area(const Piece& piece) const {
    double largest = 0.0;
    for (const Polygon& face : faces_of(piece.outline_mm, joint_mm_)) largest = std::max(largest, geometry::area(face));
    return largest;
  }

  // The other pieces of its cells and of those beside them.
  std::vector<std::size_t> neighbours(std::size_t piece) const {
    std::vector<std::size_t> near;
    for (const std::uint32_t cell : cells_of_[piece]) {
      near.insert(near.end(), of_cell_[cell].begin(), of_cell_[cell].end());
      for (const std::uint32_t next : cells_.neighbours(cell)) {
        near.insert(near.end(), of_cell_[next].begin(), of_cell_[next].end());
      }
    }
    std::ranges::sort(near);
    near.erase(std::unique(near.begin(), near.end()), near.end());
    std::erase_if(near, [&](std::size_t p) { return p == piece || pieces_[p].outline_mm.empty(); });
    return near;
  }

  std::vector<Touch> touches(std::size_t small) const {
    std::vector<Touch> found;
    for (const std::size_t p : neighbours(small)) {
      for (const Contact& contact : contacts(pieces_[small].outline_mm, pieces_[p].outline_mm)) found.push_back({p, contact});
    }
    return found;
  }

  // What `outline` lacks to its convex hull, but for what small pieces beside the host will give.
  double hollow_mm2(const Polygon& outline, std::size_t host, std::size_t small) const {
    const Polygon hull = geometry::convex_hull(outline);
    double hollow = geometry::area(hull) - geometry::area(outline);
    if (hollow < least_hollow * stone_area_) return hollow;
    for (const std::size_t p : neighbours(host)) {
      if (p == small || !waits_[p]) continue;
      for (const geometry::Region& filled : geometry::intersection(hull, {pieces_[p].outline_mm, {}})) {
        hollow -= geometry::area(filled);
      }
    }
    return hollow;
  }

  // Each part joined to its host. Nothing if one cannot be.
  std::optional<Joining> joining(std::vector<Grown> parts, std::size_t small) const {
    Joining result;
    for (Grown& part : parts) {
      const Polygon& host = pieces_[part.host].outline_mm;
      auto together = joined(part.outline_mm, host);
      if (!together) return std::nullopt;
      result.too_large |= geometry::area(*together) > largest_joined * stone_area_;
      const double shared_mm = shared_length(part.outline_mm, host);
      // A straight neck is as wide as its joint is long; one that leans on it is narrower.
      result.falls_apart |= shared_mm < 4.0 * joint_mm_ && faces_of(*together, joint_mm_).size() > 1;
      result.hollow_mm2 += hollow_mm2(*together, part.host, small) - hollow_mm2(host, part.host, small);
      result.shared_mm += shared_mm;
      part.outline_mm = std::move(*together);
    }
    result.grown = std::move(parts);
    return result;
  }

  std::optional<Joining> best_joining(std::size_t small) const {
    const Polygon& outline = pieces_[small].outline_mm;
    const std::vector<Touch> found = touches(small);
    std::optional<Joining> best;
    const auto rank = [&](const Joining& j) {
      return std::tuple(j.falls_apart, j.too_large, std::floor(j.hollow_mm2 / (least_hollow * stone_area_)), -j.shared_mm);
    };
    const auto consider = [&](std::vector<Grown> parts) {
      auto candidate = joining(std::move(parts), small);
      if (candidate && (!best || rank(*candidate) < rank(*best))) best = std::move(candidate);
    };
    for (std::size_t t = 0; t < found.size(); ++t) {
      if (t == 0 || found[t].host != found[t - 1].host) consider({{found[t].host, outline}});
    }
    for (const auto& row : rows_of(outline, found)) {
      if (auto parts = shared_out(outline, row)) consider(std::move(*parts));
    }
    return best;
  }

  void join(std::size_t small) {
    auto best = best_joining(small);
    if (!best) return;
    for (Grown& grown : best->grown) {
      Piece& into = pieces_[grown.host];
      const bool larger =
          best->grown.size() == 1 && geometry::area(pieces_[small].outline_mm) > geometry::area(into.outline_mm);
      if (larger) into.cell = pieces_[small].cell;
      into.outline_mm = std::move(grown.outline_mm);
      into.cut = true;
      for (const std::uint32_t cell : cells_of_[small]) {
        of_cell_[cell].push_back(grown.host);
        cells_of_[grown.host].push_back(cell);
      }
    }
    for (const std::uint32_t cell : cells_of_[small]) std::erase(of_cell_[cell], small);
    pieces_[small].outline_mm.clear();
  }

  std::vector<Piece> pieces_;
  const Cells& cells_;
  double stone_area_;
  double joint_mm_;
  std::vector<std::vector<std::size_t>> of_cell_;     // pieces of a cell
  std::vector<std::vector<std::uint32_t>> cells_of_;  // cells of a piece
  std::vector<bool> waits_;                           // of a piece: it is small and will be joined
};

}  // namespace

std::vector<Piece> without_small(std::vector<Piece> pieces, const Cells& cells, const StoneSize& size) {
  return Joiner(std::move(pieces), cells, size).join_small();
}

}  // namespace shatterpave::paving
