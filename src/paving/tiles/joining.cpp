// A paviour who meets the border a few centimetres after a whole stone cuts longer stones for the last row, so that joints run
// straight to the border. So a small piece is either given to one neighbour, or shared out among those that lie along one of
// its sides, with the joints between them prolonged through it. What leaves the stones most nearly convex is done.
#include "paving/tiles/joining.h"

#include <algorithm>
#include <boost/geometry/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <tuple>

#include "core/parallel.h"
#include "geometry/clip.h"
#include "geometry/hull.h"
#include "geometry/lattice.h"
#include "paving/tiles/contact.h"

namespace shatterpave::paving {

namespace {

namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;
using geometry::Polygon;

// Hollows that differ by less than this part of a stone are alike to the eye; by eye.
constexpr double least_hollow = 0.02;
// Where halves of a third of a stone cannot be, they are at least so much larger than what the small piece would be; by eye.
constexpr double less_small = 2.0;
// A piece smaller than this part of a stone counts as one of this size.
constexpr double least_kept = 0.01;
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
  vec2 axis{1.0, 0.0};
};

struct Joining {
  std::vector<Grown> grown;
  std::vector<Grown> more;                                        // further parts of those that were cut anew
  int cut_anew = 0;                                               // how many were, since they would not fit the stock
  double stoutness_mm = std::numeric_limits<double>::infinity();  // of the weakest of their halves
  int falls_apart = 0;      // how many of them do, or leave the bed bare, since the joint takes a neck or an end of them
  double hollow_mm2 = 0.0;  // between them and their convex hulls, more than before
  double shared_mm = 0.0;   // joints that vanish
};

vec2 direction(const Polygon& polygon, std::size_t side) {
  return glm::normalize(polygon[(side + 1) % polygon.size()] - polygon[side]);
}

double length(const Polygon& polygon, std::size_t side) {
  return glm::length(polygon[(side + 1) % polygon.size()] - polygon[side]);
}

double hollow_mm2(const Polygon& outline) { return geometry::area(geometry::convex_hull(outline)) - geometry::area(outline); }

vec2 longest_side(const Polygon& polygon) {
  std::size_t longest = 0;
  for (std::size_t i = 1; i < polygon.size(); ++i) {
    if (length(polygon, i) > length(polygon, longest)) longest = i;
  }
  return direction(polygon, longest);
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
    parts.push_back({hosts[i], std::move(part.front().outline), {}});
  }
  return parts;
}

// Finds pieces by place.
class PieceIndex {
 public:
  explicit PieceIndex(const std::vector<Piece>& pieces) {
    std::vector<Entry> entries;
    entries.reserve(pieces.size());
    for (std::size_t p = 0; p < pieces.size(); ++p) entries.emplace_back(box_of(pieces[p].outline_mm), p);
    tree_ = Tree(entries);
  }

  // Those whose boxes come near to that of the outline, ascending.
  std::vector<std::size_t> near(const Polygon& outline) const {
    std::vector<std::size_t> found;
    const Box box = box_of(outline);
    for (auto entry = tree_.qbegin(bgi::intersects(box)); entry != tree_.qend(); ++entry) found.push_back(entry->second);
    std::ranges::sort(found);
    return found;
  }
  void add(std::size_t piece, const Polygon& outline) { tree_.insert({box_of(outline), piece}); }
  void remove(std::size_t piece, const Polygon& outline) { tree_.remove({box_of(outline), piece}); }

 private:
  using Corner = bg::model::point<double, 2, bg::cs::cartesian>;
  using Box = bg::model::box<Corner>;
  using Entry = std::pair<Box, std::size_t>;
  using Tree = bgi::rtree<Entry, bgi::linear<16>>;

  // With room for borders that were rounded apart.
  static Box box_of(const Polygon& outline) {
    const geometry::Box box = geometry::bounding_box(outline);
    return {{box.low.x - same_line_mm, box.low.y - same_line_mm}, {box.high.x + same_line_mm, box.high.y + same_line_mm}};
  }

  Tree tree_;
};

class Joiner {
 public:
  Joiner(std::vector<Piece> pieces, const StoneSize& size)
      : pieces_(std::move(pieces)), size_(size), index_(pieces_), waits_(pieces_.size(), false) {}

  std::vector<Piece> join_small() && {
    std::vector<double> face(pieces_.size());
    parallel_for(pieces_.size(), [&](std::size_t p) {
      // Of the others only the odd ones at irregular spots can be small; to look at all would take as long as laying them.
      face[p] = whole_face_mm2(p);
      if (pieces_[p].cut || geometry::area(pieces_[p].outline_mm) < 2.0 * least_piece * whole_face_mm2(p))
        face[p] = face_area(pieces_[p].outline_mm);
    });
    std::vector<std::size_t> small;
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      if (is_small(p, face[p])) small.push_back(p);
    }
    std::ranges::stable_sort(small, {}, [&](std::size_t p) { return face[p]; });
    for (const std::size_t p : small) waits_[p] = true;
    // Parts of what was cut anew may be small themselves, and are looked at again; a few rounds leave nothing to be gained.
    constexpr int most_rounds = 3;
    for (int round = 0; round < most_rounds && !small.empty(); ++round) {
      changed_.clear();
      for (const std::size_t p : small) {
        waits_[p] = false;
        // It may have grown by another that joined it.
        if (!pieces_[p].outline_mm.empty() && is_small(p, face_area(pieces_[p].outline_mm))) join(p);
      }
      std::ranges::sort(changed_);
      changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
      std::erase_if(changed_, [&](std::size_t p) {
        return pieces_[p].outline_mm.empty() || !is_small(p, face_area(pieces_[p].outline_mm));
      });
      small = changed_;
    }
    std::erase_if(pieces_, [](const Piece& piece) { return piece.outline_mm.empty(); });
    return std::move(pieces_);
  }

 private:
  StoneSize size_of(std::size_t piece) const { return size_.times(pieces_[piece].size); }
  double whole_face_mm2(std::size_t piece) const { return size_of(piece).whole_face_mm2; }
  bool is_small(std::size_t piece, double face_area) const { return face_area < least_piece * whole_face_mm2(piece); }

  double face_area(const Polygon& outline) const {
    double largest = 0.0;
    for (const Polygon& face : faces_of(outline, size_.joint_mm)) largest = std::max(largest, geometry::area(face));
    return largest;
  }

  bool fits_stock(const Polygon& outline, vec2 axis, const Stock& stock) const {
    return std::ranges::all_of(faces_of(outline, size_.joint_mm), [&](const Polygon& face) { return fits(face, axis, stock); });
  }

  std::vector<std::size_t> neighbours(std::size_t piece) const {
    std::vector<std::size_t> near = index_.near(pieces_[piece].outline_mm);
    std::erase(near, piece);
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
  double hollow_beside(const Polygon& outline, std::size_t host, std::size_t small) const {
    double hollow = hollow_mm2(outline);
    if (hollow < least_hollow * whole_face_mm2(host)) return hollow;
    const Polygon hull = geometry::convex_hull(outline);
    for (const std::size_t p : neighbours(host)) {
      if (p == small || !waits_[p]) continue;
      for (const geometry::Region& filled : geometry::intersection(hull, {pieces_[p].outline_mm, {}})) {
        hollow -= geometry::area(filled);
      }
    }
    return hollow;
  }

  // A grown host that is larger than the stock, in parts that fit it along an axis of theirs.
  struct Anew {
    std::vector<Polygon> parts;
    vec2 axis{1.0, 0.0};
    double stoutness_mm = 0.0;  // of the weakest
  };

  // What parts must be: cut from this stock, and no smaller than that.
  struct Parts {
    Stock stock;
    double least_mm2 = 0.0;
  };

  // In halves, or halves of halves where one does not fit, first cut across the axis (`by_length`) or along it. Nothing where a
  // part would fall apart or be too small.
  std::optional<Anew> in_halves(const Polygon& grown, vec2 axis, bool by_length, const Parts& asked, bool again) const {
    const vec2 size = asked.stock.size_for(axis);
    const double stock = by_length ? size.x : size.y;
    // Of halves that are halved again only their sum is asked for.
    const auto pair = halves(grown, axis, by_length, again ? 2.0 * (stock + size_.joint_mm) : stock + size_.joint_mm);
    if (!pair) return std::nullopt;
    Anew result{{}, axis, std::numeric_limits<double>::infinity()};
    for (const Polygon* half : {&pair->first, &pair->second}) {
      const auto faces = faces_of(*half, size_.joint_mm);
      if (faces.size() != 1 || geometry::area(faces.front()) < asked.least_mm2) return std::nullopt;
      if (fits(faces.front(), axis, asked.stock)) {
        result.stoutness_mm = std::min(result.stoutness_mm, stoutness_mm(faces.front()));
        result.parts.push_back(*half);
        continue;
      }
      if (!again) return std::nullopt;
      auto quarters = in_halves(*half, axis, !by_length, asked, false);
      if (!quarters) quarters = in_halves(*half, axis, by_length, asked, false);
      if (!quarters) return std::nullopt;
      result.stoutness_mm = std::min(result.stoutness_mm, quarters->stoutness_mm);
      std::ranges::move(quarters->parts, std::back_inserter(result.parts));
    }
    return result;
  }

  // The way to cut it in the fewest parts, of which the weakest is stoutest; along the longest side of an odd piece if need be.
  std::optional<Anew> cut_anew(const Polygon& grown, vec2 axis, const Parts& asked) const {
    for (const bool again : {false, true}) {
      for (const vec2 along : {axis, longest_side(grown)}) {
        std::optional<Anew> best;
        for (const bool by_length : {true, false}) {
          auto found = in_halves(grown, along, by_length, asked, again);
          if (found && (!best || found->stoutness_mm > best->stoutness_mm)) best = std::move(found);
        }
        if (best) return best;
      }
    }
    return std::nullopt;
  }

  void add_anew(Anew anew, std::size_t host, Joining& result) const {
    ++result.cut_anew;
    result.stoutness_mm = std::min(result.stoutness_mm, anew.stoutness_mm);
    result.hollow_mm2 -= hollow_mm2(pieces_[host].outline_mm);
    for (Polygon& cut : anew.parts) {
      result.hollow_mm2 += hollow_mm2(cut);
      result.falls_apart += bare_ends(cut, size_of(host)).empty() ? 0 : 1;
      auto& list = &cut == anew.parts.data() ? result.grown : result.more;
      list.push_back({host, std::move(cut), anew.axis});
    }
  }

  // A straight neck is as wide as its joint is long; one that leans on it is narrower.
  bool falls_apart(const Polygon& together, double shared_mm, const StoneSize& size) const {
    return (shared_mm < 4.0 * size_.joint_mm && faces_of(together, size_.joint_mm).size() > 1) ||
           !bare_ends(together, size).empty();
  }

  // Each part joined to its host. Nothing if one cannot be, or if the stone would not fit the stock, not in halves either.
  std::optional<Joining> joining(const std::vector<Grown>& parts, std::size_t small) const {
    Joining result;
    // Halves may be small where the piece was smaller by far.
    const double least_mm2 =
        std::min(least_piece * whole_face_mm2(small),
                 less_small * std::max(face_area(pieces_[small].outline_mm), least_kept * whole_face_mm2(small)));
    for (const Grown& part : parts) {
      const Piece& host = pieces_[part.host];
      auto together = joined(part.outline_mm, host.outline_mm);
      if (!together) return std::nullopt;
      const double shared_mm = shared_length(part.outline_mm, host.outline_mm);
      result.shared_mm += shared_mm;
      const StoneSize size = size_of(part.host);
      if (!fits_stock(*together, host.axis, size.stock)) {
        auto anew = cut_anew(*together, host.axis, {size.stock, least_mm2});
        if (!anew) return std::nullopt;
        add_anew(*std::move(anew), part.host, result);
        continue;
      }
      result.falls_apart += falls_apart(*together, shared_mm, size) ? 1 : 0;
      result.hollow_mm2 += hollow_beside(*together, part.host, small) - hollow_beside(host.outline_mm, part.host, small);
      result.grown.push_back({part.host, std::move(*together), host.axis});
    }
    return result;
  }

  std::optional<Joining> best_joining(std::size_t small) const {
    const Polygon& outline = pieces_[small].outline_mm;
    const std::vector<Touch> found = touches(small);
    std::optional<Joining> best;
    const auto rank = [&](const Joining& j) {
      return std::tuple(j.falls_apart, std::floor(j.hollow_mm2 / (least_hollow * whole_face_mm2(small))), j.cut_anew > 0,
                        -j.stoutness_mm, -j.shared_mm);
    };
    const auto consider = [&](const std::vector<Grown>& parts) {
      auto candidate = joining(parts, small);
      if (candidate && (!best || rank(*candidate) < rank(*best))) best = std::move(candidate);
    };
    for (std::size_t t = 0; t < found.size(); ++t) {
      if (t == 0 || found[t].host != found[t - 1].host) consider({{found[t].host, outline, {}}});
    }
    for (const auto& row : rows_of(outline, found)) {
      if (auto parts = shared_out(outline, row)) consider(*parts);
    }
    return best;
  }

  void replace(std::size_t piece, Polygon outline) {
    index_.remove(piece, pieces_[piece].outline_mm);
    pieces_[piece].outline_mm = std::move(outline);
    if (!pieces_[piece].outline_mm.empty()) index_.add(piece, pieces_[piece].outline_mm);
  }

  void join(std::size_t small) {
    auto best = best_joining(small);
    if (!best) return;
    for (Grown& grown : best->grown) {
      Piece& into = pieces_[grown.host];
      const bool larger =
          best->grown.size() == 1 && geometry::area(pieces_[small].outline_mm) > geometry::area(into.outline_mm);
      if (larger) into.cell = pieces_[small].cell;
      into.cut = true;
      into.axis = grown.axis;
      replace(grown.host, std::move(grown.outline_mm));
      changed_.push_back(grown.host);
    }
    for (Grown& part : best->more) {
      index_.add(pieces_.size(), part.outline_mm);
      changed_.push_back(pieces_.size());
      const Piece& host = pieces_[part.host];
      pieces_.push_back({std::move(part.outline_mm), host.cell, true, part.axis, host.size});
      waits_.push_back(false);
    }
    replace(small, {});
  }

  std::vector<Piece> pieces_;
  const StoneSize& size_;
  PieceIndex index_;
  std::vector<bool> waits_;           // of a piece: it is small and will be joined
  std::vector<std::size_t> changed_;  // pieces that grew or were cut anew in this round
};

}  // namespace

std::vector<Piece> without_small(std::vector<Piece> pieces, const StoneSize& size) {
  return Joiner(std::move(pieces), size).join_small();
}

}  // namespace shatterpave::paving
