#include "measure/scene_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>

#include "core/error.h"
#include "core/parallel.h"
#include "glass/breaking.h"

namespace shatterpave::measure {

namespace {

using glass::Pane;
using Numbers = std::array<double, figure_count>;

constexpr std::size_t fit_seeds = 32;
constexpr std::size_t judging_seeds = 96;
constexpr std::uint64_t first_fit_seed = 1;
constexpr std::uint64_t first_judging_seed = 1'000'001;  // none that was fitted with
constexpr int rounds = 4;
// M is counted where lines run together: what tracing promises for it.
constexpr double count_error_share = 0.04;

enum Figure : std::size_t { radials, reaching, rings, ring_mean, ring_spread, turn_spread, turn_memory, gaps, branches };

// A value, the figure that it makes, and how one follows from the other: by a factor, or by as much as it is off.
struct Parameter {
  std::string_view key;
  Figure figure;
  bool by_factor;
  bool whole;
  double low, high;
  std::function<void(Pane&, double)> put;
  double value = 0.0;
};

struct Moments {
  Numbers mean{};
  Numbers deviation{};
};

Moments moments_of(const std::vector<Numbers>& panes) {
  Moments moments;
  for (std::size_t i = 0; i < figure_count; ++i) {
    Distribution values;
    for (const Numbers& pane : panes) values.add(pane[i]);
    moments.mean[i] = values.mean();
    moments.deviation[i] = values.deviation();
  }
  return moments;
}

std::vector<Numbers> simulated(const Pane& pane, std::uint64_t first_seed, std::size_t count) {
  std::vector<Numbers> panes(count);
  parallel_for(count, [&](std::size_t i) { panes[i] = numbers_of(pane_figures(glass::broken(pane, first_seed + i), pane)); });
  return panes;
}

std::vector<Parameter> common_parameters() {
  const auto first = [](Pane& pane) -> glass::Impact& { return pane.impacts.front(); };
  return {
      {"impact[0].radial_count", radials, false, true, 1.0, 10'000.0,
       [first](Pane& pane, double v) { first(pane).radial_count = static_cast<int>(v); }},
      {"impact[0].large_count", reaching, false, true, 0.0, 10'000.0,
       [first](Pane& pane, double v) { first(pane).large_count = std::min(static_cast<int>(v), *first(pane).radial_count); }},
      {"growth.wander_deg", turn_spread, true, false, 0.5, 80.0,
       [](Pane& pane, double v) { pane.growth.wander = Angle::degrees(v); }, 14.0},
      {"growth.branch_rate_per_m", branches, true, false, 0.0, 1000.0,
       [](Pane& pane, double v) { pane.growth.branch_rate_per_m = v; }},
  };
}

// Of several panes N scatters about its law (eq. 6), which is moved; that of one is its own.
Parameter law_of_large(const Numbers& traced) {
  const double by_law = glass::Growth{}.large_slope * std::max(std::round(traced[radials]), 1.0);
  return {"growth.large_offset",
          reaching,
          false,
          false,
          -1000.0,
          1000.0,
          [](Pane& pane, double v) { pane.growth.large_offset = v; },
          traced[reaching] - by_law};
}

std::vector<Parameter> parameters_of(glass::Pattern pattern, const Numbers& traced, std::size_t count) {
  std::vector<Parameter> all = common_parameters();
  all[0].value = std::max(std::round(traced[radials]), 1.0);
  all[1].value = std::round(traced[reaching]);
  if (count > 1) all[1] = law_of_large(traced);
  all[3].value = traced[branches];
  if (pattern == glass::Pattern::agui1992) {
    all.push_back({"impact[0].circular_count", rings, false, true, 0.0, 1000.0,
                   [](Pane& pane, double v) { pane.impacts.front().circular_count = static_cast<int>(v); },
                   std::round(traced[rings])});
    if (traced[rings] > 0.0) {
      all.push_back({"growth.ring_radius_offset_mm", ring_mean, false, false, 0.0, 10'000.0,
                     [](Pane& pane, double v) { pane.growth.ring_radius_offset_mm = v; },
                     std::max(traced[ring_mean] - 0.470 * traced[radials], 0.0)});
    }
    return all;
  }
  all.push_back({"rings.count", rings, true, true, 0.0, 100.0,
                 [](Pane& pane, double v) { pane.rings.count = static_cast<int>(v); }, traced[rings] > 0.0 ? 5.0 : 0.0});
  if (traced[rings] > 0.0) {
    all.push_back({"rings.first_radius_mm", ring_mean, true, false, 0.1, 100'000.0,
                   [](Pane& pane, double v) { pane.rings.first_radius_mm = v; }, std::max(0.3 * traced[ring_mean], 1.0)});
  }
  return all;
}

void put(const std::vector<Parameter>& parameters, Pane& pane) {
  for (const Parameter& parameter : parameters)
    parameter.put(pane, parameter.whole ? std::round(parameter.value) : parameter.value);
}

// One step of each value towards its figure.
void improve(std::vector<Parameter>& parameters, const Numbers& traced, const Numbers& mean) {
  for (Parameter& parameter : parameters) {
    const double wanted = traced[parameter.figure];
    const double got = mean[parameter.figure];
    if (parameter.by_factor) {
      if (got > 0.0) parameter.value *= std::clamp(wanted / got, 0.4, 2.5);
    } else {
      parameter.value += wanted - got;
    }
    parameter.value = std::clamp(parameter.value, parameter.low, parameter.high);
  }
}

// Of a value: what its figure scatters from pane to pane, carried over.
double error_of(const Parameter& parameter, const Moments& moments, std::size_t traced) {
  const double mean = moments.mean[parameter.figure];
  const double deviation = moments.deviation[parameter.figure];
  const double few = std::sqrt(1.0 / static_cast<double>(traced) + 1.0 / static_cast<double>(fit_seeds));
  double error = parameter.by_factor ? (mean > 0.0 ? parameter.value * deviation / mean : 0.0) : deviation;
  if (parameter.figure == radials) error = std::max(error, count_error_share * parameter.value);
  error *= few;
  return parameter.whole ? std::max(error, 0.5) : error;
}

double distance(const Numbers& pane, const Moments& moments) {
  double sum = 0.0;
  for (std::size_t i = 0; i < figure_count; ++i) {
    // What does not vary over seeds, as M where it is given, is off by what counting is.
    const double scale = std::max(moments.deviation[i], count_error_share * std::abs(moments.mean[i]) + 1e-6);
    const double off = (pane[i] - moments.mean[i]) / scale;
    sum += std::min(off * off, 100.0);
  }
  return sum;
}

// The share of groups of as many panes that are as far off, or farther.
double probability_of(const Numbers& traced, const std::vector<Numbers>& panes, const Moments& moments, std::size_t count) {
  const double off = distance(traced, moments);
  std::size_t farther = 0;
  for (std::size_t i = 0; i < panes.size(); ++i) {
    std::vector<Numbers> group;
    for (std::size_t k = 0; k < count; ++k) group.push_back(panes[(i + k * 31) % panes.size()]);
    if (distance(moments_of(group).mean, moments) >= off) ++farther;
  }
  return (static_cast<double>(farther) + 1.0) / (static_cast<double>(panes.size()) + 1.0);
}

struct Trial {
  SceneFit fit;
  double distance = 0.0;
};

Trial trial_of(glass::Pattern pattern, const Numbers& traced, std::size_t count, const Pane& like,
               const std::function<void()>& step_done) {
  Trial trial;
  Pane& pane = trial.fit.pane;
  pane.name = "fitted";
  pane.outline_mm = like.outline_mm;
  pane.thickness_mm = like.thickness_mm;
  pane.pattern = pattern;
  pane.impacts.resize(1);
  pane.impacts.front().at_mm = like.impacts.front().at_mm;
  std::vector<Parameter> parameters = parameters_of(pattern, traced, count);
  Moments moments;
  for (int round = 0; round <= rounds; ++round) {
    put(parameters, pane);
    moments = moments_of(simulated(pane, first_fit_seed, fit_seeds));
    if (round < rounds) improve(parameters, traced, moments.mean);
    step_done();
  }
  for (const Parameter& parameter : parameters) {
    const double value = parameter.whole ? std::round(parameter.value) : parameter.value;
    trial.fit.values.push_back({parameter.key, value, error_of(parameter, moments, count)});
  }
  const std::vector<Numbers> judges = simulated(pane, first_judging_seed, judging_seeds);
  const Moments judged = moments_of(judges);
  step_done();
  for (std::size_t i = 0; i < figure_count; ++i) {
    trial.fit.figures.push_back({figure_names[i], traced[i], judged.mean[i], judged.deviation[i]});
  }
  trial.fit.probability = probability_of(traced, judges, judged, count);
  trial.distance = distance(traced, judged);
  return trial;
}

}  // namespace

SceneFit fitted_scene(const std::vector<PaneFigures>& traced, const Pane& like, const Progress& progress) {
  ENSURE(!traced.empty() && !like.impacts.empty());
  std::vector<Numbers> numbers(traced.size());
  std::ranges::transform(traced, numbers.begin(), numbers_of);
  const Numbers mean = moments_of(numbers).mean;
  int done = 0;
  const auto step_done = [&] {
    ++done;
    if (progress) progress("fitting", static_cast<double>(done) / (2.0 * (rounds + 2)));
  };
  Trial paper = trial_of(glass::Pattern::agui1992, mean, traced.size(), like, step_done);
  Trial real = trial_of(glass::Pattern::real, mean, traced.size(), like, step_done);
  return paper.distance <= real.distance ? paper.fit : real.fit;
}

}  // namespace shatterpave::measure
