// What a report tells of many values: moments and a histogram, without keeping the values.
#pragma once

#include <cstddef>
#include <vector>

namespace shatterpave::measure {

// 0 of nothing.
inline double percentage(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

// Count, mean, spread and range of values that are added one by one. The result depends on their order, in the last bits.
class Distribution {
 public:
  void add(double value);

  std::size_t count() const { return count_; }
  double mean() const { return mean_; }  // 0 without values, as are the others
  double variance() const;               // by count − 1; 0 for one value
  double deviation() const;              // its square root
  double least() const { return least_; }
  double greatest() const { return greatest_; }

  bool operator==(const Distribution&) const = default;

 private:
  std::size_t count_ = 0;
  double mean_ = 0.0;
  double squares_ = 0.0;  // about the mean
  double least_ = 0.0;
  double greatest_ = 0.0;
};

// The value below which the share of the values lies, 0 <= share <= 1: one of them, the lower where it lies between two; 0 of
// none. The order of the values changes.
double percentile(std::vector<double>& values, double share);

// Counts of values in cells of equal width from `low` on; cell i holds [low + i width, low + (i + 1) width). Values outside go
// to the first and the last cell.
struct Histogram {
  double low = 0.0;
  double width = 1.0;               // > 0
  std::vector<std::size_t> counts;  // one or more

  void add(double value);

  bool operator==(const Histogram&) const = default;
};

}  // namespace shatterpave::measure
