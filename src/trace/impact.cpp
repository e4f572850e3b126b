#include "trace/impact.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/angle.h"
#include "core/functions.h"
#include "core/parallel.h"

namespace shatterpave::trace {

namespace {

constexpr double looking_deg = 10.0;
// Photographs of broken panes have 0.20 to 0.68 of their lines so, 1.7 to 5.6 times as much as elsewhere; a brick wall, setts
// and a house front 0.11 to 0.14, at most 1.4 times.
constexpr double least_share = 0.18;
constexpr double over_elsewhere = 1.5;
constexpr std::size_t side_count = 12;
// A few lines look at one place by chance: those of a pane of which little shows did so from three or four sides, with a share
// of 0.28. Where most of the length does, as about an impact in a corner, three of twelve sides are left.
constexpr double clear_share = 0.35;
constexpr std::size_t least_sides = 7;
constexpr std::size_t least_clear_sides = 3;

// ---- votes

class Votes {
 public:
  Votes(int width, int height)
      : cell_px_(std::max(std::max(width, height) / 96.0, 2.0)),
        sums_(static_cast<int>(std::ceil(width / cell_px_)), static_cast<int>(std::ceil(height / cell_px_))) {}

  // For every square that the chord's line passes, but for those next to it: it is in them whatever it looks at.
  void add(const Chord& chord) {
    const double reach = 0.7 * cell_px_ * std::max(sums_.width, sums_.height);
    for (const double sign : {-1.0, 1.0}) {
      int last = -1;
      for (double gone = 2.0 * cell_px_; gone < reach; gone += 0.5 * cell_px_) {
        const vec2 at = (chord.middle + sign * gone * chord.direction) / cell_px_;
        const int x = static_cast<int>(std::floor(at.x));
        const int y = static_cast<int>(std::floor(at.y));
        if (!sums_.holds(x, y)) break;
        const int cell = y * sums_.width + x;
        if (cell == last) continue;
        last = cell;
        sums_.at(x, y) += chord.length;
      }
    }
  }

  // The middle of the square that has most, together with its neighbours.
  vec2 most() const {
    double best = -1.0;
    vec2 at{0.0, 0.0};
    for (int y = 0; y < sums_.height; ++y) {
      for (int x = 0; x < sums_.width; ++x) {
        const double sum = sum_about(x, y);
        if (sum <= best) continue;
        best = sum;
        at = cell_px_ * vec2{x + 0.5, y + 0.5};
      }
    }
    return at;
  }

 private:
  double sum_about(int x, int y) const {
    double sum = 0.0;
    int count = 0;
    for (int v = y - 1; v <= y + 1; ++v) {
      for (int u = x - 1; u <= x + 1; ++u) {
        if (!sums_.holds(u, v)) continue;
        sum += sums_.at(u, v);
        ++count;
      }
    }
    return sum / count;
  }

  double cell_px_;
  Grid<double> sums_;
};

// Lines that meet best, from `start` on. A chord's line is off by a pixel, and by 3 % of the way.
vec2 refined(const std::vector<Chord>& chords, vec2 start) {
  constexpr int rounds = 40;
  constexpr double off_px = 1.0;
  constexpr double off_share = 0.03;
  vec2 at = start;
  for (int round = 0; round < rounds; ++round) {
    const double tolerance = round < rounds / 2 ? 4.0 - 6.0 * round / rounds : 1.0;
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    vec2 sum{0.0, 0.0};
    for (const Chord& chord : chords) {
      const vec2 across = left_of(chord.direction);
      const double off = glm::dot(at - chord.middle, across);
      const double expected = off_px + off_share * glm::length(at - chord.middle);
      const double ratio = off / (tolerance * expected);
      const double weight = chord.length / (expected * expected * (1.0 + ratio * ratio));
      const double level = glm::dot(chord.middle, across);
      xx += weight * across.x * across.x;
      xy += weight * across.x * across.y;
      yy += weight * across.y * across.y;
      sum += weight * level * across;
    }
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 1e-12 * (xx + yy) * (xx + yy))) break;
    at = vec2{yy * sum.x - xy * sum.y, xx * sum.y - xy * sum.x} / determinant;
  }
  return at;
}

bool looks_at(const Chord& chord, vec2 point) {
  const vec2 way = point - chord.middle;
  const double least = Angle::degrees(looking_deg).direction().x;
  return std::abs(glm::dot(way, chord.direction)) >= least * glm::length(way);
}

std::size_t sides_looking_at(const std::vector<Chord>& chords, vec2 point, double near_px) {
  std::vector<double> lengths(side_count, 0.0);
  for (const Chord& chord : chords) {
    const vec2 way = chord.middle - point;
    if (glm::length(way) < near_px || !looks_at(chord, point)) continue;
    const double turn = (Angle::of(way).radians() + pi) / (2.0 * pi);
    lengths[std::min(static_cast<std::size_t>(turn * side_count), side_count - 1)] += chord.length;
  }
  return static_cast<std::size_t>(std::ranges::count_if(lengths, [&](double length) { return length > near_px; }));
}

}  // namespace

std::vector<Chord> chords_of(const LineGraph& graph, double length_px) {
  std::vector<Chord> chords;
  for (const GraphEdge& edge : graph.edges()) {
    if (!edge.alive) continue;
    vec2 from = edge.points.front();
    for (const vec2 to : edge.points) {
      const double length = glm::length(to - from);
      if (length < length_px) continue;
      chords.push_back({0.5 * (from + to), (to - from) / length, length});
      from = to;
    }
  }
  return chords;
}

double share_looking_at(const std::vector<Chord>& chords, vec2 point, double near_px) {
  double all = 0.0;
  double looking = 0.0;
  for (const Chord& chord : chords) {
    if (glm::length(chord.middle - point) < near_px) continue;
    all += chord.length;
    if (looks_at(chord, point)) looking += chord.length;
  }
  return all > 0.0 ? looking / all : 0.0;
}

std::optional<vec2> impact_of(const std::vector<Chord>& chords, int width, int height) {
  if (chords.size() < 8) return std::nullopt;
  Votes votes(width, height);
  for (const Chord& chord : chords) votes.add(chord);
  const vec2 at = refined(chords, votes.most());
  if (!(at.x > 0.0 && at.y > 0.0 && at.x < width && at.y < height)) return std::nullopt;
  const double near_px = 0.03 * std::max(width, height);
  const double share = share_looking_at(chords, at, near_px);
  std::vector<double> elsewhere;
  for (int i = 0; i < 25; ++i) {
    const int column = i % 5;
    const int row = i / 5;
    const vec2 place = vec2{(column + 0.5) * width, (row + 0.5) * height} / 5.0;
    elsewhere.push_back(share_looking_at(chords, place, near_px));
  }
  std::ranges::sort(elsewhere);
  if (share < least_share || share < over_elsewhere * elsewhere[elsewhere.size() / 2]) return std::nullopt;
  const std::size_t wanted = share >= clear_share ? least_clear_sides : least_sides;
  if (sides_looking_at(chords, at, near_px) < wanted) return std::nullopt;
  return at;
}

double merged_radius(const Mask& mask, vec2 impact) {
  const double most = 0.2 * std::min(mask.width, mask.height);
  double radius = 0.0;
  for (double r = 1.0; r < most; r += 1.0) {
    const int samples = static_cast<int>(std::ceil(2.0 * pi * r));
    int on = 0;
    for (int i = 0; i < samples; ++i) {
      on += mask.nearest(impact + r * Angle::radians(2.0 * pi * i / samples).direction()) != 0 ? 1 : 0;
    }
    if (2 * on <= samples) {
      if (r > radius + 6.0) break;
    } else {
      radius = r;
    }
  }
  return radius;
}

namespace {

// ---- lines on a circle

constexpr double samples_per_px = 2.0;
constexpr double least_apart_px = 2.5;  // lines nearer to the next are one
constexpr double clear_px = 3.2;        // and on a circle where they are nearer than that on the whole, counts mean nothing
constexpr double over_noise = 3.5;      // standard deviations of the mean over a band
constexpr double least_level = 3.0;     // of 255, of the mean over a band

// The mean over the band of each direction, in samples of half a pixel along its middle.
std::vector<double> band_profile(const Grey& picture, vec2 impact, double inner, double outer) {
  const double middle = 0.5 * (inner + outer);
  const auto samples = static_cast<std::size_t>(std::ceil(2.0 * pi * middle * samples_per_px));
  std::vector<double> profile(samples, 0.0);
  const int rings = std::max(static_cast<int>(outer - inner), 1);
  for (std::size_t i = 0; i < samples; ++i) {
    const vec2 way = Angle::radians(2.0 * pi * static_cast<double>(i) / static_cast<double>(samples)).direction();
    for (int k = 0; k < rings; ++k) profile[i] += picture.nearest(impact + (inner + k + 0.5) * way);
    profile[i] /= rings;
  }
  return profile;
}

// What stands out from both sides, two pixels off, of a profile smoothed over a pixel.
std::vector<double> standing_out(const std::vector<double>& profile, double sign) {
  const std::size_t n = profile.size();
  std::vector<double> smooth(n);
  for (std::size_t i = 0; i < n; ++i)
    smooth[i] = 0.25 * profile[(i + n - 1) % n] + 0.5 * profile[i] + 0.25 * profile[(i + 1) % n];
  constexpr std::size_t off = 4;
  std::vector<double> result(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double left = sign * (smooth[i] - smooth[(i + n - off) % n]);
    const double right = sign * (smooth[i] - smooth[(i + off) % n]);
    result[i] = std::min(left, right);
  }
  return result;
}

// Peaks above a fifth of what the strongest tenth reaches, with a valley between each and the next.
int peak_count(const std::vector<double>& values, double noise) {
  std::vector<double> sorted = values;
  std::ranges::sort(sorted);
  const double strong = sorted[sorted.size() * 9 / 10];
  const double least = std::max({least_level, 0.2 * strong, over_noise * noise});
  int count = 0;
  double high = 0.0;
  bool rising = false;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] >= least && !rising) {
      rising = true;
      high = values[i];
      ++count;
    } else if (rising) {
      high = std::max(high, values[i]);
      if (values[i] < 0.5 * high || values[i] < least) rising = false;
    }
  }
  const bool wraps = rising && values.front() >= least;
  return std::max(count - (wraps ? 1 : 0), 0);
}

// How many lines there are on a circle where n are counted, if they lie at random and those nearer to the next than `blur` are
// one: n = m exp(−m blur / length). Nothing where they are too dense to tell.
std::optional<double> lines_behind(int n, double radius) {
  constexpr double blur_px = 3.0;
  const double length = 2.0 * pi * radius;
  const double most = length / blur_px;
  if (n > 0.3 * most) return std::nullopt;
  double lines = n;
  for (int i = 0; i < 60; ++i) lines = 0.5 * (lines + n * exponential(std::min(lines / most, 1.0)));
  return lines;
}

// Lines end on their way out, and run together on the way in: what there are where they can be told apart is carried on inward
// to where they begin, by the power of the distance that they follow farther out.
void estimate(const std::vector<double>& radii, const std::vector<int>& counts, RadialCount& result) {
  double first_radius = 0.0;
  double first = 0.0;
  double power_sum = 0.0;
  int powers = 0;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const double radius = 1.17 * radii[i];
    const auto lines = lines_behind(counts[i], radius);
    if (!lines || radii[i] < result.start_px || *lines < 1.0) continue;
    if (first_radius == 0.0) {
      first_radius = radius;
      first = *lines;
    } else if (radius > 1.3 * first_radius && radius < 3.0 * first_radius) {
      power_sum += logarithm(first / *lines) / logarithm(radius / first_radius);
      ++powers;
    }
  }
  const double start = std::max(result.start_px, 1.0);
  const double power = powers > 0 ? std::clamp(power_sum / powers, 0.0, 0.5) : 0.0;
  const auto whole = [](double value) { return static_cast<int>(std::lround(value)); };
  const int seen = result.count;
  // No more can be told apart where they begin, and none hide where that is not more than are seen.
  const int room = whole(2.0 * pi * start / least_apart_px);
  const bool grows = power > 0.15 && first_radius > 1.5 * start;
  const double carried = grows ? first * exponential(power * logarithm(first_radius / start)) : seen;
  result.interval = {seen, std::max(seen, std::min(whole(1.4 * carried), room))};
}

}  // namespace

RadialCount radial_count(const Grey& picture, Polarity polarity, vec2 impact, double least_radius_px) {
  const double most = 0.3 * std::min(picture.width, picture.height);
  std::vector<double> radii;
  for (double r = std::max(least_radius_px, 4.0); r < most; r *= 1.08) radii.push_back(r);
  std::vector<int> counts(radii.size(), 0);
  const double noise = noise_deviation(picture);
  parallel_for(radii.size(), [&](std::size_t i) {
    const double r = radii[i];
    const double width = std::max(6.0, 0.35 * r);
    const double of_band = std::sqrt(2.0 / width) * noise;  // of the difference of two means
    const std::vector<double> profile = band_profile(picture, impact, r, r + width);
    if (polarity != Polarity::dark) counts[i] = peak_count(standing_out(profile, 1.0), of_band);
    if (polarity != Polarity::bright) counts[i] = std::max(counts[i], peak_count(standing_out(profile, -1.0), of_band));
    if (clear_px * counts[i] > 2.0 * pi * (r + std::max(3.0, 0.175 * r))) counts[i] = 0;
  });
  RadialCount result;
  for (std::size_t i = 0; i + 2 < radii.size(); ++i) {
    // Of three neighbouring circles the middle count: one circle alone may pass through crumbs.
    std::array<int, 3> three = {counts[i], counts[i + 1], counts[i + 2]};
    std::ranges::sort(three);
    if (three[1] > result.count) result = {three[1], 1.17 * radii[i + 1], 0.0, {}};
  }
  for (std::size_t i = 0; i < radii.size() && result.start_px == 0.0; ++i) {
    if (2 * counts[i] >= result.count) result.start_px = radii[i];
  }
  estimate(radii, counts, result);
  return result;
}

}  // namespace shatterpave::trace
