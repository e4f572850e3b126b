#include "render/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace shatterpave::render_tests {

namespace {

std::string description(const Statistic& statistic) {
  return fmt::format("{}, {} {}", statistic.region, statistic.channel,
                     measure_names[static_cast<std::size_t>(statistic.measure)]);
}

struct Moments {
  double mean = 0.0;
  double deviation = 0.0;  // of the sample
};

Moments moments(const std::vector<std::vector<Statistic>>& series, std::size_t index) {
  const auto count = static_cast<double>(series.size());
  Moments result;
  for (const auto& statistics : series) result.mean += statistics[index].value / count;
  double sum = 0.0;
  for (const auto& statistics : series) sum += std::pow(statistics[index].value - result.mean, 2);
  result.deviation = std::sqrt(sum / (count - 1.0));
  return result;
}

std::vector<std::vector<Statistic>> statistics_of_each(const std::vector<relief::Raster>& pictures) {
  std::vector<std::vector<Statistic>> series;
  for (const relief::Raster& picture : pictures) {
    std::vector<Statistic> all = statistics(picture, {1, 1});
    std::erase_if(all, [](const Statistic& statistic) { return statistic.region != "whole"; });
    series.push_back(std::move(all));
  }
  return series;
}

}  // namespace

double Row::excess() const {
  const double change = std::abs(now - golden);
  // Not `change > limit`: a number that is none must be found too.
  if (change <= limit) return 0.0;
  return limit > 0.0 && std::isfinite(change) ? change / limit : HUGE_VAL;
}

bool Comparison::agrees() const {
  return std::ranges::all_of(rows, [](const Row& row) { return row.excess() == 0.0; });
}

std::string Comparison::table() const {
  std::vector<Row> ordered = rows;
  std::ranges::stable_sort(ordered, std::ranges::greater{}, &Row::excess);
  std::string text = fmt::format("{:<36} {:>10} {:>10} {:>10} {:>10}\n", "statistic", "golden", "now", "change", "limit");
  for (const Row& row : ordered) {
    text += fmt::format("{:<36} {:>10.5f} {:>10.5f} {:>+10.5f} {:>10.5f}{}\n", row.what, row.golden, row.now,
                        row.now - row.golden, row.limit, row.excess() > 0.0 ? "  out" : "");
  }
  return text;
}

Comparison compared(const Case& expected, const relief::Raster& golden, const relief::Raster& now) {
  if (golden.width != now.width || golden.height != now.height) throw std::runtime_error("the pictures differ in size");
  const std::vector<Statistic> before = statistics(golden, expected.grid);
  const std::vector<Statistic> after = statistics(now, expected.grid);
  Comparison result;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Tolerance& tolerance = expected.tolerances[static_cast<std::size_t>(before[i].measure)];
    result.rows.push_back({description(before[i]), before[i].value, after[i].value,
                           tolerance.absolute + tolerance.relative * std::abs(before[i].value)});
  }
  return result;
}

Comparison compared_over_seeds(const Case& expected, const std::vector<relief::Raster>& golden,
                               const std::vector<relief::Raster>& now) {
  const auto before = statistics_of_each(golden);
  const auto after = statistics_of_each(now);
  if (!expected.seeds || before.size() != after.size()) throw std::runtime_error("the series differ in length");
  Comparison result;
  for (std::size_t i = 0; i < before.front().size(); ++i) {
    const Moments old_moments = moments(before, i);
    const Moments new_moments = moments(after, i);
    const std::string what = description(before.front()[i]);
    // A spread below a quarter of a grey level of a screen cannot be seen, and is no measure of chance.
    const double smallest = 0.25 / 255.0;
    const double old_spread = std::max(old_moments.deviation, smallest);
    const double new_spread = std::max(new_moments.deviation, smallest);
    const double error = std::sqrt((old_spread * old_spread + new_spread * new_spread) / static_cast<double>(before.size()));
    result.rows.push_back({what + ", mean", old_moments.mean, new_moments.mean, expected.seeds->mean_sigmas * error});
    // The spread as its logarithm, so that half and double are alike.
    result.rows.push_back(
        {what + ", log spread", std::log(old_spread), std::log(new_spread), std::log(expected.seeds->spread_ratio)});
  }
  return result;
}

relief::Raster difference(const relief::Raster& golden, const relief::Raster& now) {
  relief::Raster result = now;
  if (golden.values.size() != now.values.size()) return result;
  for (std::size_t i = 0; i < result.values.size(); ++i) result.values[i] = 0.5F + 0.5F * (now.values[i] - golden.values[i]);
  return result;
}

}  // namespace shatterpave::render_tests
