#include "trace/picture.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/parallel.h"

namespace shatterpave::trace {

namespace {

// Between the four pixels about `p`; of the nearest ones, outside.
double interpolated(const Grey& picture, vec2 p) {
  const double x = std::clamp(p.x - 0.5, 0.0, static_cast<double>(picture.width - 1));
  const double y = std::clamp(p.y - 0.5, 0.0, static_cast<double>(picture.height - 1));
  const int left = std::min(static_cast<int>(x), std::max(picture.width - 2, 0));
  const int top = std::min(static_cast<int>(y), std::max(picture.height - 2, 0));
  const int right = std::min(left + 1, picture.width - 1);
  const int below = std::min(top + 1, picture.height - 1);
  const double u = x - left;
  const double v = y - top;
  return (1.0 - v) * ((1.0 - u) * picture.at(left, top) + u * picture.at(right, top)) +
         v * ((1.0 - u) * picture.at(left, below) + u * picture.at(right, below));
}

double longest_of(const Corners& corners) {
  double longest = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) longest = std::max(longest, glm::length(corners[(i + 1) % 4] - corners[i]));
  return longest;
}

}  // namespace

vec2 Perspective::operator()(vec2 p) const {
  const double w = rows[6] * p.x + rows[7] * p.y + rows[8];
  return vec2{rows[0] * p.x + rows[1] * p.y + rows[2], rows[3] * p.x + rows[4] * p.y + rows[5]} / w;
}

Perspective perspective_to(const Corners& corners, double width, double height) {
  const auto point = [](double x, double y) { return cv::Point2f(static_cast<float>(x), static_cast<float>(y)); };
  const std::array<cv::Point2f, 4> from = {point(0.0, 0.0), point(width, 0.0), point(width, height), point(0.0, height)};
  std::array<cv::Point2f, 4> to;
  std::ranges::transform(corners, to.begin(), [&](vec2 p) { return point(p.x, p.y); });
  const cv::Mat matrix = cv::getPerspectiveTransform(from.data(), to.data());
  Perspective result;
  for (int i = 0; i < 9; ++i) result.rows[static_cast<std::size_t>(i)] = matrix.at<double>(i / 3, i % 3);
  return result;
}

Sight seen_straight(const Grey& photograph, const Corners& corners, vec2 pane_mm, int longest_side) {
  const double side_mm = std::max(pane_mm.x, pane_mm.y);
  const double side = std::min(longest_of(corners), static_cast<double>(longest_side));
  Sight sight;
  sight.mm_per_px = side_mm / std::max(std::round(side), 1.0);
  const auto pixels = [&](double mm) { return std::max(static_cast<int>(std::lround(mm / sight.mm_per_px)), 1); };
  sight.picture = Grey(pixels(pane_mm.x), pixels(pane_mm.y));
  const int width = sight.picture.width;
  sight.to_photograph = perspective_to(corners, width, sight.picture.height);
  // Where several pixels of the photograph make one, as many samples are taken on each side.
  const int samples = std::max(static_cast<int>(std::lround(longest_of(corners) / side)), 1);
  parallel_for(static_cast<std::size_t>(sight.picture.height), [&](std::size_t row) {
    for (int x = 0; x < width; ++x) {
      double sum = 0.0;
      for (int i = 0; i < samples * samples; ++i) {
        const vec2 within = (vec2{i % samples, i / samples} + 0.5) / static_cast<double>(samples);
        sum += interpolated(photograph, sight.to_photograph(vec2{x, static_cast<double>(row)} + within));
      }
      sight.picture.at(x, static_cast<int>(row)) = static_cast<std::uint8_t>(std::lround(sum / (samples * samples)));
    }
  });
  return sight;
}

Grey mean_of_nine(const Grey& picture) {
  Grey mean(picture.width, picture.height);
  parallel_for(static_cast<std::size_t>(picture.height), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < picture.width; ++x) {
      int sum = 0;
      int count = 0;
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, picture.height - 1); ++v) {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, picture.width - 1); ++u) {
          sum += picture.at(u, v);
          ++count;
        }
      }
      mean.at(x, y) = static_cast<std::uint8_t>((2 * sum + count) / (2 * count));
    }
  });
  return mean;
}

double noise_deviation(const Grey& picture) {
  std::vector<float> values;
  for (int y = 1; y + 1 < picture.height; y += 3) {
    for (int x = 1; x + 1 < picture.width; x += 3) {
      int sum = 4 * picture.at(x, y);
      for (const int d : {-1, 1}) {
        sum -= 2 * (picture.at(x + d, y) + picture.at(x, y + d));
        sum += picture.at(x + d, y - 1) + picture.at(x + d, y + 1);
      }
      values.push_back(static_cast<float>(std::abs(sum)) / 6.0F);
    }
  }
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return 1.4826 * static_cast<double>(*middle);
}

}  // namespace shatterpave::trace
