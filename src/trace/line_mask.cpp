// A line stands out in the second derivative across it. That is taken of the picture smoothed to three widths, in twelve
// directions, and summed up over nine pixels along each: noise cancels out, lines do not. What an edge between two grounds
// gives is taken off by the first derivative, which is 0 on a line and as large as the second beside an edge (at one width of
// the smoothing, where the second is greatest).
#include "trace/line_mask.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/angle.h"
#include "core/functions.h"
#include "core/parallel.h"

namespace shatterpave::trace {

namespace {

using Values = Grid<float>;

constexpr std::array<double, 3> widths_px = {0.9, 1.8, 3.6};  // standard deviations of the smoothing: lines of 1 … 8 px
constexpr int direction_count = 12;
constexpr int reach_px = 4;  // to either side along a line
// What a line as wide as twice the smoothing gives, of its contrast: 2 φ(1).
constexpr double share_of_contrast = 0.484;
// Beside a line its second derivative has the other sign: 2 exp(−3/2) = 0.446 of it at √3 widths. An opposite line that is
// not this counts from here on.
constexpr float side_lobe = 0.6F;
// Over the median of the surroundings: where a line is certain, and where it goes on. On noise of 5 % alone (SD 12.75) the
// former leaves a pixel in some 10,000, by trial.
constexpr float ridge_over_noise = 3.4F;
constexpr float on_over_noise = 2.3F;
constexpr int tile_px = 64;

std::vector<float> gaussian(double width) {
  const int half = static_cast<int>(std::ceil(3.0 * width));
  std::vector<float> weights;
  double sum = 0.0;
  for (int i = -half; i <= half; ++i) sum += exponential(-0.5 * (i / width) * (i / width));
  for (int i = -half; i <= half; ++i) {
    weights.push_back(static_cast<float>(exponential(-0.5 * (i / width) * (i / width)) / sum));
  }
  return weights;
}

// The index of a pixel beyond the border: that of its mirror image.
int mirrored(int i, int count) {
  if (count == 1) return 0;
  const int period = 2 * (count - 1);
  const int at = ((i % period) + period) % period;
  return at < count ? at : period - at;
}

Values smoothed(const Grey& picture, double width) {
  const std::vector<float> weights = gaussian(width);
  const int half = static_cast<int>(weights.size()) / 2;
  Values across(picture.width, picture.height);
  parallel_for(static_cast<std::size_t>(picture.height), [&](std::size_t row) {
    std::vector<float> line(static_cast<std::size_t>(picture.width) + 2 * static_cast<std::size_t>(half));
    for (int x = -half; x < picture.width + half; ++x) {
      line[static_cast<std::size_t>(std::ptrdiff_t{x} + half)] = picture.at(mirrored(x, picture.width), static_cast<int>(row));
    }
    float* to = &across.at(0, static_cast<int>(row));
    for (std::size_t k = 0; k < weights.size(); ++k) {
      for (int x = 0; x < picture.width; ++x) to[x] += weights[k] * line[static_cast<std::size_t>(x) + k];
    }
  });
  Values result(picture.width, picture.height);
  parallel_for(static_cast<std::size_t>(picture.height), [&](std::size_t row) {
    float* to = &result.at(0, static_cast<int>(row));
    for (int k = -half; k <= half; ++k) {
      const float weight = weights[static_cast<std::size_t>(std::ptrdiff_t{k} + half)];
      const float* from = &across.at(0, mirrored(static_cast<int>(row) + k, picture.height));
      for (int x = 0; x < picture.width; ++x) to[x] += weight * from[x];
    }
  });
  return result;
}

// First and second derivatives, times the width and its square.
struct Derivatives {
  Values x, y, xx, xy, yy;
};

Derivatives derivatives(const Values& picture, double width) {
  const auto first = static_cast<float>(0.5 * width);
  const auto second = static_cast<float>(width * width);
  Derivatives d{Values(picture.width, picture.height), Values(picture.width, picture.height),
                Values(picture.width, picture.height), Values(picture.width, picture.height),
                Values(picture.width, picture.height)};
  parallel_for(static_cast<std::size_t>(picture.height), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    const float* up = &picture.at(0, mirrored(y - 1, picture.height));
    const float* on = &picture.at(0, y);
    const float* down = &picture.at(0, mirrored(y + 1, picture.height));
    for (int i = 0; i < picture.width; ++i) {
      const int l = mirrored(i - 1, picture.width);
      const int r = mirrored(i + 1, picture.width);
      d.x.at(i, y) = first * (on[r] - on[l]);
      d.y.at(i, y) = first * (down[i] - up[i]);
      d.xx.at(i, y) = second * (on[r] - 2.0F * on[i] + on[l]);
      d.yy.at(i, y) = second * (down[i] - 2.0F * on[i] + up[i]);
      d.xy.at(i, y) = 0.25F * second * (down[r] - down[l] - up[r] + up[l]);
    }
  });
  return d;
}

// How much each pixel stands out as part of a bright and of a dark line, in levels of contrast.
struct Response {
  Values level;
  Grid<std::uint8_t> direction;  // of the line, of direction_count

  Response(int width, int height) : level(width, height), direction(width, height) {}
};
struct Responses {
  Response bright, dark;
};

vec2 direction_of(int direction) { return Angle::degrees(180.0 * direction / direction_count).direction(); }

// Adds what lines in one direction give, where it is more than what is there.
void raise(const Derivatives& d, int direction, Responses& responses) {
  const vec2 step = direction_of(direction);
  const float c = static_cast<float>(-step.y);  // across
  const float s = static_cast<float>(step.x);
  const int width = d.x.width;
  const int height = d.x.height;
  Values bright(width, height);
  Values dark(width, height);
  parallel_for(static_cast<std::size_t>(height), [&](std::size_t row) {
    const std::size_t begin = row * static_cast<std::size_t>(width);
    for (std::size_t i = begin; i < begin + static_cast<std::size_t>(width); ++i) {
      const float bend = c * c * d.xx.values[i] + 2.0F * c * s * d.xy.values[i] + s * s * d.yy.values[i];
      const float slope = std::abs(c * d.x.values[i] + s * d.y.values[i]);
      bright.values[i] = std::max(-bend - slope, 0.0F);
      dark.values[i] = std::max(bend - slope, 0.0F);
    }
  });
  const auto scale = static_cast<float>(1.0 / (share_of_contrast * (2 * reach_px + 1)));
  const auto sum_along = [&](const Values& values, Response& most, int y, std::vector<float>& sums) {
    std::ranges::fill(sums, 0.0F);
    for (int k = -reach_px; k <= reach_px; ++k) {
      const int dx = static_cast<int>(std::lround(k * step.x));
      const int v = std::clamp(y + static_cast<int>(std::lround(k * step.y)), 0, height - 1);
      const float* from = &values.at(0, v);
      const int first = std::max(0, -dx);
      const int last = std::min(width, width - dx);
      for (int x = first; x < last; ++x) sums[static_cast<std::size_t>(x)] += from[x + dx];
    }
    float* to = &most.level.at(0, y);
    std::uint8_t* to_direction = &most.direction.at(0, y);
    for (int x = 0; x < width; ++x) {
      const float value = scale * sums[static_cast<std::size_t>(x)];
      if (value <= to[x]) continue;
      to[x] = value;
      to_direction[x] = static_cast<std::uint8_t>(direction);
    }
  };
  parallel_for(static_cast<std::size_t>(height), [&](std::size_t row) {
    std::vector<float> sums(static_cast<std::size_t>(width));
    sum_along(bright, responses.bright, static_cast<int>(row), sums);
    sum_along(dark, responses.dark, static_cast<int>(row), sums);
  });
}

cv::Mat view(Values& values) { return {values.height, values.width, CV_32F, values.values.data()}; }
cv::Mat view(Mask& mask) { return {mask.height, mask.width, CV_8U, mask.values.data()}; }

// Takes off what is beside an opposite line: of the same width, or a finer one.
void drop_side_lobes(Responses& responses, Values finer_bright, Values finer_dark, double width) {
  const int radius = static_cast<int>(std::ceil(2.5 * width));
  const cv::Mat square = cv::getStructuringElement(cv::MORPH_RECT, cv::Size(2 * radius + 1, 2 * radius + 1));
  Values& bright = responses.bright.level;
  Values& dark = responses.dark.level;
  Values bright_near(bright.width, bright.height);
  Values dark_near(bright.width, bright.height);
  for (std::size_t i = 0; i < bright.values.size(); ++i) {
    finer_bright.values[i] = std::max(finer_bright.values[i], bright.values[i]);
    finer_dark.values[i] = std::max(finer_dark.values[i], dark.values[i]);
  }
  cv::dilate(view(finer_bright), view(bright_near), square);
  cv::dilate(view(finer_dark), view(dark_near), square);
  for (std::size_t i = 0; i < bright_near.values.size(); ++i) {
    if (bright.values[i] < side_lobe * dark_near.values[i]) bright.values[i] = 0.0F;
    if (dark.values[i] < side_lobe * bright_near.values[i]) dark.values[i] = 0.0F;
  }
}

Responses responses_at(const Grey& picture, double width) {
  Responses responses{Response(picture.width, picture.height), Response(picture.width, picture.height)};
  const Derivatives d = derivatives(smoothed(picture, width), width);
  for (int i = 0; i < direction_count; ++i) raise(d, i, responses);
  return responses;
}

float median_of(std::vector<float>& values) {
  if (values.empty()) return 0.0F;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

// What noise gives about each tile: the median of its responses, but no more than twice that of the picture, since where lines
// are dense they are most of what there is.
Values noise_by_tile(const Values& response) {
  const int columns = (response.width + tile_px - 1) / tile_px;
  const int rows = (response.height + tile_px - 1) / tile_px;
  Values noise(columns, rows);
  parallel_for(noise.values.size(), [&](std::size_t tile) {
    const int left = static_cast<int>(tile) % columns * tile_px;
    const int top = static_cast<int>(tile) / columns * tile_px;
    std::vector<float> values;
    for (int y = top; y < std::min(top + tile_px, response.height); y += 2) {
      for (int x = left; x < std::min(left + tile_px, response.width); x += 2) values.push_back(response.at(x, y));
    }
    noise.values[tile] = median_of(values);
  });
  std::vector<float> all = noise.values;
  const float most = 2.0F * median_of(all);
  for (float& value : noise.values) value = std::min(value, most);
  return noise;
}

// Takes off where something finer about it stands out more: several lines beside one another are not one wide line. Then adds
// what is left to the finer.
void leave_to_finer(Values& response, Values& finer, double width) {
  const int radius = static_cast<int>(std::ceil(1.5 * width));
  const cv::Mat square = cv::getStructuringElement(cv::MORPH_RECT, cv::Size(2 * radius + 1, 2 * radius + 1));
  Values near(finer.width, finer.height);
  cv::dilate(view(finer), view(near), square);
  for (std::size_t i = 0; i < near.values.size(); ++i) {
    if (response.values[i] < near.values[i]) response.values[i] = 0.0F;
  }
  for (std::size_t i = 0; i < near.values.size(); ++i) finer.values[i] = std::max(finer.values[i], response.values[i]);
}

// Whether nothing beside the pixel, across the line, stands out much more: so lines a few pixels apart do not touch.
bool is_crest(const Response& response, int x, int y, double width) {
  constexpr float share = 0.8F;
  const vec2 across = left_of(direction_of(response.direction.at(x, y)));
  const float least = share * response.level.nearest({x + 0.5, y + 0.5});
  float most = 0.0F;
  for (const double off : {std::max(1.0, 0.8 * width), std::max(2.0, 1.6 * width)}) {
    for (const double sign : {-1.0, 1.0}) {
      most = std::max(most, response.level.nearest(vec2{x + 0.5, y + 0.5} + sign * off * across));
    }
  }
  return least / share >= share * most;
}

// Marks what is above the lower threshold and hangs together with something above the higher one: 1 and 2.
void mark(const Response& response, const Values& noise, double width, Mask& mask) {
  parallel_for(static_cast<std::size_t>(mask.height), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < mask.width; ++x) {
      const float around = noise.at(x / tile_px, y / tile_px);
      const auto contrast = static_cast<float>(least_contrast);
      const float high = std::max(contrast, ridge_over_noise * around);
      const float value = response.level.at(x, y);
      if (value < std::max(0.5F * contrast, on_over_noise * around) || !is_crest(response, x, y, width)) continue;
      mask.at(x, y) = std::max<std::uint8_t>(mask.at(x, y), value >= high ? 2 : 1);
    }
  });
}

// Adds ribbons, which are too wide to be lines but narrower than `ribbon_px`: what is brighter than the ground about it and
// than what is left where everything narrower is taken away, or darker, by far.
void mark_ribbons(const Grey& picture, Polarity polarity, int ribbon_px, Mask& mask) {
  const double least = std::max(2.0 * least_contrast, 5.0 * noise_deviation(picture));
  Grey copy = picture;
  const cv::Mat levels(copy.height, copy.width, CV_8U, copy.values.data());
  const cv::Mat disc = cv::getStructuringElement(cv::MORPH_RECT, cv::Size(ribbon_px, ribbon_px));
  cv::Mat ground;
  cv::medianBlur(levels, ground, 2 * ribbon_px + 1);
  for (const bool bright : {true, false}) {
    if (polarity == (bright ? Polarity::dark : Polarity::bright)) continue;
    cv::Mat without;
    cv::morphologyEx(levels, without, bright ? cv::MORPH_OPEN : cv::MORPH_CLOSE, disc);
    const cv::Mat over_ground = bright ? levels - ground : ground - levels;
    const cv::Mat over_rest = bright ? levels - without : without - levels;
    const cv::Mat far = (over_ground >= least) & (over_rest >= least);
    for (int y = 0; y < mask.height; ++y) {
      const std::uint8_t* row = far.ptr<std::uint8_t>(y);
      for (int x = 0; x < mask.width; ++x) {
        if (row[x] != 0) mask.at(x, y) = 2;
      }
    }
  }
}

// Of the marked pixels the connected ones that hold enough of level 2, as 1.
void keep_certain(Mask& mask) {
  constexpr int least_certain = 6;  // px: a crumb is no line
  cv::Mat labels;
  cv::Mat marked = view(mask) > 0;
  const int count = cv::connectedComponents(marked, labels, 8, CV_32S);
  std::vector<int> certain(static_cast<std::size_t>(count), 0);
  for (int y = 0; y < mask.height; ++y) {
    const int* label = labels.ptr<int>(y);
    for (int x = 0; x < mask.width; ++x) certain[static_cast<std::size_t>(label[x])] += mask.at(x, y) == 2 ? 1 : 0;
  }
  for (int y = 0; y < mask.height; ++y) {
    const int* label = labels.ptr<int>(y);
    for (int x = 0; x < mask.width; ++x) {
      const bool kept = mask.at(x, y) > 0 && certain[static_cast<std::size_t>(label[x])] >= least_certain;
      mask.at(x, y) = kept ? 1 : 0;
    }
  }
}

// Where lines are of one kind but for a small part, that part is the ground between them.
Polarity polarity_of(const Mask& bright, const Mask& dark) {
  constexpr double small_part = 0.15;
  const auto certain = [](const Mask& mask) { return static_cast<double>(std::ranges::count(mask.values, std::uint8_t{2})); };
  const double all = certain(bright) + certain(dark);
  if (certain(dark) < small_part * all) return Polarity::bright;
  return certain(bright) < small_part * all ? Polarity::dark : Polarity::both;
}

// Ground of a few pixels that lines enclose.
void fill_pinholes(Mask& mask) {
  constexpr int largest = 24;  // px
  cv::Mat labels;
  cv::Mat stats;
  cv::Mat middles;
  const cv::Mat ground = view(mask) == 0;
  cv::connectedComponentsWithStats(ground, labels, stats, middles, 4, CV_32S);
  for (int y = 0; y < mask.height; ++y) {
    const int* label = labels.ptr<int>(y);
    for (int x = 0; x < mask.width; ++x) {
      if (mask.at(x, y) == 0 && stats.at<int>(label[x], cv::CC_STAT_AREA) <= largest) mask.at(x, y) = 1;
    }
  }
}

}  // namespace

Mask threshold_mask(const Grey& picture, std::optional<int> threshold) {
  Grey mean = mean_of_nine(picture);
  cv::Mat above;
  const cv::Mat levels(mean.height, mean.width, CV_8U, mean.values.data());
  if (threshold) {
    cv::threshold(levels, above, *threshold, 1, cv::THRESH_BINARY);
  } else {
    cv::threshold(levels, above, 0, 1, cv::THRESH_BINARY | cv::THRESH_OTSU);
  }
  Mask mask(mean.width, mean.height);
  above.copyTo(view(mask));
  const auto bright = static_cast<std::size_t>(cv::countNonZero(above));
  if (2 * bright > mask.values.size()) {
    for (std::uint8_t& value : mask.values) value = value == 0 ? 1 : 0;
  }
  return mask;
}

Mask line_mask(const Grey& picture, Polarity polarity, int ribbon_px) {
  Mask bright_mask(picture.width, picture.height);
  Mask dark_mask(picture.width, picture.height);
  Values finer_bright(picture.width, picture.height);
  Values finer_dark(picture.width, picture.height);
  for (const double width : widths_px) {
    Responses responses = responses_at(picture, width);
    // Of what is there before anything is taken off.
    const Values bright_noise = noise_by_tile(responses.bright.level);
    const Values dark_noise = noise_by_tile(responses.dark.level);
    if (polarity == Polarity::both) drop_side_lobes(responses, finer_bright, finer_dark, width);
    const auto add = [&](Response& response, const Values& noise, Values& finer, Mask& mask) {
      leave_to_finer(response.level, finer, width);
      mark(response, noise, width, mask);
    };
    if (polarity != Polarity::dark) add(responses.bright, bright_noise, finer_bright, bright_mask);
    if (polarity != Polarity::bright) add(responses.dark, dark_noise, finer_dark, dark_mask);
  }
  const Polarity seen = polarity == Polarity::both ? polarity_of(bright_mask, dark_mask) : polarity;
  Mask mask(picture.width, picture.height);
  for (std::size_t i = 0; i < mask.values.size(); ++i) {
    if (seen != Polarity::dark) mask.values[i] = bright_mask.values[i];
    if (seen != Polarity::bright) mask.values[i] = std::max(mask.values[i], dark_mask.values[i]);
  }
  mark_ribbons(picture, seen, ribbon_px, mask);
  keep_certain(mask);
  const cv::Mat cross = cv::getStructuringElement(cv::MORPH_CROSS, cv::Size(3, 3));
  Mask closed(mask.width, mask.height);
  cv::morphologyEx(view(mask), view(closed), cv::MORPH_CLOSE, cross);
  fill_pinholes(closed);
  return closed;
}

}  // namespace shatterpave::trace
