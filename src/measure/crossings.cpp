// The pane is cut into bands along x, about as many as the square root of the number of pieces. In each band the pieces, sorted
// by their left end, meet only those whose stretches of x overlap theirs. A pair that shares several bands is looked at in the
// highest band that both begin in or below.
#include "measure/crossings.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

#include "geometry/predicates.h"

namespace shatterpave::measure {

namespace {

using geometry::LatticePoint;

// A segment of a crack, with its box.
struct Piece {
  LatticePoint a;
  LatticePoint b;
  LatticePoint low;
  LatticePoint high;
  int crack = 0;
  bool starts = false;  // a is the first point of the crack
  bool ends = false;    // b is its last
};

struct Meeting {
  Crossing crossing;
  LatticePoint point;  // of a touch, which up to four pairs of pieces tell; of a proper crossing the ends of the pieces
  LatticePoint other;

  auto operator<=>(const Meeting&) const = default;
};

std::vector<Piece> pieces_of(const glass::CrackNetwork& network) {
  std::vector<Piece> pieces;
  std::size_t count = 0;
  for (const glass::Crack& crack : network.cracks) count += crack.points_mm.size() - 1;
  pieces.reserve(count);
  for (const glass::Crack& crack : network.cracks) {
    LatticePoint from = geometry::to_lattice(crack.points_mm.front());
    for (std::size_t i = 1; i < crack.points_mm.size(); ++i) {
      const LatticePoint to = geometry::to_lattice(crack.points_mm[i]);
      const LatticePoint low{std::min(from.x, to.x), std::min(from.y, to.y)};
      const LatticePoint high{std::max(from.x, to.x), std::max(from.y, to.y)};
      pieces.push_back({from, to, low, high, crack.id, i == 1, i + 1 == crack.points_mm.size()});
      from = to;
    }
  }
  return pieces;
}

bool is_end(const Piece& piece, LatticePoint p) { return (piece.starts && piece.a == p) || (piece.ends && piece.b == p); }

bool in_box(const Piece& piece, LatticePoint p) {
  return p.x >= piece.low.x && p.x <= piece.high.x && p.y >= piece.low.y && p.y <= piece.high.y;
}

bool share_an_end(const Piece& one, const Piece& two) {
  return one.a == two.a || one.a == two.b || one.b == two.a || one.b == two.b;
}

void add_touch(const Piece& one, const Piece& two, LatticePoint p, std::vector<Meeting>& found) {
  if (!in_box(two, p) || is_end(one, p) || is_end(two, p) || !geometry::on_segment(two.a, two.b, p)) return;
  found.push_back({{std::min(one.crack, two.crack), std::max(one.crack, two.crack)}, p, p});
}

void add_meetings(const Piece& one, const Piece& two, std::vector<Meeting>& found) {
  // What shares an end cannot cross properly: neighbours along a crack, and the first pieces of all radials.
  const bool sharing = share_an_end(one, two);
  if (sharing && one.crack == two.crack) return;
  if (!sharing && geometry::segments_cross(one.a, one.b, two.a, two.b)) {
    const auto [first, second] = std::minmax(one.a, two.a);
    found.push_back({{std::min(one.crack, two.crack), std::max(one.crack, two.crack)}, first, second});
    return;
  }
  if (one.crack == two.crack) return;
  for (const LatticePoint p : {one.a, one.b}) add_touch(one, two, p, found);
  for (const LatticePoint p : {two.a, two.b}) add_touch(two, one, p, found);
}

class Bands {
 public:
  explicit Bands(std::span<const Piece> pieces) : pieces_(pieces) {
    std::int64_t high = pieces.front().high.y;
    low_ = pieces.front().low.y;
    for (const Piece& piece : pieces) {
      low_ = std::min(low_, piece.low.y);
      high = std::max(high, piece.high.y);
    }
    const auto wanted = static_cast<std::int64_t>(std::sqrt(static_cast<double>(pieces.size())));
    height_ = (high - low_) / std::max<std::int64_t>(wanted, 1) + 1;
    fill(static_cast<std::size_t>((high - low_) / height_ + 1));
  }

  std::size_t count() const { return offsets_.size() - 1; }
  std::size_t band_of(std::int64_t y) const { return static_cast<std::size_t>((y - low_) / height_); }

  // The numbers of the pieces in the band, sorted by their left end.
  std::span<const std::uint32_t> operator[](std::size_t band) const {
    return std::span(members_).subspan(offsets_[band], offsets_[band + 1] - offsets_[band]);
  }

 private:
  // Count, offsets, fill. Pieces are sorted by their left end first, and keep that order within each band.
  void fill(std::size_t bands) {
    std::vector<std::pair<std::int64_t, std::uint32_t>> order;
    order.reserve(pieces_.size());
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) order.emplace_back(pieces_[i].low.x, i);
    std::ranges::sort(order);
    offsets_.assign(bands + 1, 0);
    for (const Piece& piece : pieces_) {
      for (std::size_t band = band_of(piece.low.y); band <= band_of(piece.high.y); ++band) ++offsets_[band + 1];
    }
    for (std::size_t band = 0; band < bands; ++band) offsets_[band + 1] += offsets_[band];
    members_.resize(offsets_.back());
    std::vector<std::size_t> next(offsets_.begin(), offsets_.end() - 1);
    for (const auto& [left, i] : order) {
      for (std::size_t band = band_of(pieces_[i].low.y); band <= band_of(pieces_[i].high.y); ++band) members_[next[band]++] = i;
    }
  }

  std::span<const Piece> pieces_;
  std::int64_t low_ = 0;
  std::int64_t height_ = 1;
  std::vector<std::size_t> offsets_;
  std::vector<std::uint32_t> members_;
};

}  // namespace

std::vector<Crossing> crossings(const glass::CrackNetwork& network) {
  const std::vector<Piece> pieces = pieces_of(network);
  if (pieces.empty()) return {};
  const Bands bands(pieces);
  std::vector<Meeting> found;
  for (std::size_t band = 0; band < bands.count(); ++band) {
    const std::span<const std::uint32_t> members = bands[band];
    for (std::size_t i = 0; i < members.size(); ++i) {
      const Piece& one = pieces[members[i]];
      for (std::size_t j = i + 1; j < members.size() && pieces[members[j]].low.x <= one.high.x; ++j) {
        const Piece& two = pieces[members[j]];
        const std::int64_t low = std::max(one.low.y, two.low.y);
        if (low > std::min(one.high.y, two.high.y) || bands.band_of(low) != band) continue;
        add_meetings(one, two, found);
      }
    }
  }
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  std::vector<Crossing> result;
  result.reserve(found.size());
  for (const Meeting& meeting : found) result.push_back(meeting.crossing);
  return result;
}

}  // namespace shatterpave::measure
