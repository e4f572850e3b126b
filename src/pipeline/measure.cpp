// Panes are broken in batches, in parallel, and each batch is added up in the order of the seeds: so the number of threads does
// not show, and what the measures are made of need not be kept.
#include "pipeline/measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <mutex>

#include "core/error.h"
#include "core/parallel.h"
#include "glass/breaking.h"
#include "glass/growth/counts.h"
#include "paving/bonds/bond.h"
#include "paving/laying.h"
#include "pipeline/parts.h"

namespace shatterpave::pipeline {

namespace {

using measure::Survey;

constexpr std::size_t batch_size = 1024;
constexpr std::size_t most_specimens = 24;

void require_measurable(const scene::Scene& scene, const MeasureOptions& options) {
  const auto refuse = [&](const std::string& message) { throw InputError(Place{options.scene_file, 0, 0, ""}, message); };
  if (scene.panes.empty() && scene.pavements.empty()) refuse("expected a table [[pane]] or [[pavement]] to measure, got none");
  if (scene.panes.empty() && options.sweep) refuse("expected one or more tables [[pane]] for --radials, got none");
  constexpr auto last_seed = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  if (scene.seed > last_seed - (options.seeds - 1)) {
    refuse(fmt::format("expected a first seed of at most {} for {} seeds, got {}", last_seed - (options.seeds - 1),
                       options.seeds, scene.seed));
  }
  if (!scene.panes.empty() && options.seeds > most_measured_panes / scene.panes.size()) {
    refuse(fmt::format("expected at most {} panes in all, got {} seeds with {} panes each", most_measured_panes, options.seeds,
                       scene.panes.size()));
  }
}

// M for the `index`-th of `count` seeds.
int swept_count(const measure::Sweep& sweep, std::size_t index, std::size_t count) {
  const std::size_t span = static_cast<std::size_t>(sweep.high - sweep.low);
  const std::size_t steps = std::max<std::size_t>(count - 1, 1);
  return sweep.low + static_cast<int>((2 * span * index + steps) / (2 * steps));
}

glass::Pane pane_of_seed(const glass::Pane& pane, const MeasureOptions& options, std::size_t index) {
  glass::Pane result = pane;
  if (!options.sweep) return result;
  for (glass::Impact& impact : result.impacts) {
    impact.mean_radial_count.reset();
    impact.large_count.reset();
    impact.circular_count.reset();
    impact.radial_count = swept_count(*options.sweep, index, options.seeds);
  }
  return result;
}

// The law of M, if the first impact of every pane has the same.
std::optional<measure::CountLaw> law_of(const scene::Scene& scene) {
  std::optional<measure::CountLaw> law;
  for (const glass::Pane& pane : scene.panes) {
    const glass::Impact& impact = pane.impacts.front();
    if (impact.radial_count) return std::nullopt;
    const measure::CountLaw here{glass::mean_radial_count(impact, pane.growth), pane.growth.count_dispersion};
    if (law && *law != here) return std::nullopt;
    law = here;
  }
  return law;
}

bool is_printed(const glass::Pane& pane) { return pane.growth.law == glass::GrowthLaw::printed; }

// Whether the pane is of a kind that both laws of growth know.
bool has_laws(const glass::Pane& pane) {
  return measure::subject_of(pane) == measure::Subject::experiment && !pane.given_cracks;
}

// The other law than that of the scene's panes; nothing where it is not asked for.
std::optional<measure::OtherLaw> other_law_of(const scene::Scene& scene, const MeasureOptions& options) {
  const auto of_law = [&](bool printed) {
    return std::ranges::count_if(scene.panes, [&](const glass::Pane& p) { return has_laws(p) && is_printed(p) == printed; });
  };
  const bool asked = of_law(true) > 0 || (options.both_laws && of_law(false) > 0);
  if (!asked) return std::nullopt;
  if (of_law(true) > 0 && of_law(false) > 0) return measure::OtherLaw{"other", {}};
  return measure::OtherLaw{of_law(true) > 0 ? "fitted" : "printed", {}};
}

struct Broken {
  glass::CrackNetwork network;  // kept of specimens only
  measure::PaneMeasures measures;
  std::optional<measure::PaneMeasures> by_other_law;
};

class Surveyor {
 public:
  Surveyor(const scene::Scene& scene, const MeasureOptions& options)
      : scene_(scene), options_(options), pane_totals_(scene.panes.size()) {
    survey_.name = scene.name;
    survey_.first_seed = scene.seed;
    survey_.seed_count = options.seeds;
    survey_.sweep = options.sweep;
    if (!options.sweep) survey_.count_law = law_of(scene);
    survey_.other_law = other_law_of(scene, options);
    for (const glass::Pane& pane : scene.panes) survey_.pane_names.push_back(pane.name);
    survey_.panes.reserve(count());
  }

  std::size_t count() const { return options_.seeds * scene_.panes.size(); }

  // Breaks and measures the `index`-th pane of all. May be called from several threads.
  Broken broken(std::size_t index) const {
    const glass::Pane pane = pane_at(index);
    Broken result;
    result.network = glass::broken(pane, seed_at(index));
    result.measures = measure::measured(result.network, pane);
    if (!is_specimen(index)) result.network = {};
    if (survey_.other_law && has_laws(pane)) {
      glass::Pane other = pane;
      other.growth.law = is_printed(pane) ? glass::GrowthLaw::fitted : glass::GrowthLaw::printed;
      result.by_other_law = measure::measured(glass::broken(other, seed_at(index)), other);
    }
    return result;
  }

  // Must be called in the order of the panes.
  void add(std::size_t index, Broken broken) {
    totals_.add(broken.measures);
    if (broken.by_other_law) other_totals_.add(*broken.by_other_law);
    pane_totals_[index % scene_.panes.size()].add(broken.measures);
    measure::SurveyedPane row{seed_at(index), index % scene_.panes.size(), {}};
    for (const measure::ImpactMeasures& impact : broken.measures.impacts) row.impacts.push_back(measure::figures_of(impact));
    survey_.panes.push_back(std::move(row));
    if (is_specimen(index)) {
      survey_.specimens.push_back({seed_at(index), pane_at(index), std::move(broken.network)});
    }
  }

  Survey finished() {
    if (!scene_.panes.empty()) survey_.summary = totals_.summary();
    if (survey_.other_law) survey_.other_law->summary = other_totals_.summary();
    for (const measure::Totals& totals : pane_totals_) survey_.pane_summaries.push_back(totals.summary());
    return std::move(survey_);
  }

 private:
  // The first panes; in a sweep as many, evenly over all of it.
  bool is_specimen(std::size_t index) const {
    if (!options_.sweep || index == 0) return index < most_specimens;
    const auto share = [&](std::size_t i) { return i * most_specimens / count(); };
    return count() <= most_specimens || share(index) != share(index - 1);
  }
  std::uint64_t seed_at(std::size_t index) const { return scene_.seed + index / scene_.panes.size(); }
  glass::Pane pane_at(std::size_t index) const {
    return pane_of_seed(scene_.panes[index % scene_.panes.size()], options_, index / scene_.panes.size());
  }

  const scene::Scene& scene_;
  const MeasureOptions& options_;
  Survey survey_;
  measure::Totals totals_;
  measure::Totals other_totals_;
  std::vector<measure::Totals> pane_totals_;
};

// Whether the places of the stones depend on the seed.
bool shows_seed(const paving::Pavement& pavement) {
  const paving::Variation& variation = pavement.variation;
  if (variation.size > 0.0 || variation.rotation > Angle() || variation.offset_mm > 0.0 || variation.missing > 0.0) return true;
  return paving::is_drawn(pavement);
}

measure::SurveyedPavement surveyed_pavement(const paving::Pavement& pavement, std::uint64_t first_seed, std::size_t seeds,
                                            const std::function<void()>& one_done) {
  measure::SurveyedPavement result{pavement, {}, {}, {}, {}};
  paving::Pavement plain = pavement;
  plain.variation = {};
  plain.hand = {};
  const bool varies = plain.variation != pavement.variation || plain.hand != pavement.hand;
  for (std::size_t i = 0; i < seeds; ++i) {
    const std::uint64_t seed = first_seed + i;
    paving::StoneLayout set_out = paving::laid_stones(plain, seed);
    measure::LayoutMeasures measures = varies ? measure::measured(pavement, set_out, paving::laid_stones(pavement, seed))
                                              : measure::measured(pavement, set_out, set_out);
    result.layouts.push_back({seed, measures.figures});
    if (i == 0) {
      result.first_layout = std::move(set_out);
      result.first_measures = std::move(measures);
    }
    one_done();
  }
  std::vector<measure::LayoutFigures> figures;
  for (const measure::SurveyedLayout& layout : result.layouts) figures.push_back(layout.figures);
  result.findings = measure::pavement_findings(pavement, figures);
  return result;
}

// Measures all pavements but kerbs. Those that do not depend on the seed are laid once.
std::vector<measure::SurveyedPavement> surveyed_pavements(const scene::Scene& scene, const MeasureOptions& options,
                                                          const Progress& progress) {
  const auto seeds = [&](const paving::Pavement& pavement) { return shows_seed(pavement) ? options.seeds : 1; };
  std::vector<PavementPart> parts = pavement_parts(scene);
  std::erase_if(parts, [](const PavementPart& part) { return part.is_kerb(); });
  std::size_t count = 0;
  for (const PavementPart& part : parts) count += seeds(part.pavement);
  std::size_t done = 0;
  std::vector<measure::SurveyedPavement> result;
  result.reserve(parts.size());
  for (const PavementPart& part : parts) {
    result.push_back(surveyed_pavement(part.pavement, scene.seed, seeds(part.pavement), [&] {
      ++done;
      if (progress) progress("measuring pavements", static_cast<double>(done) / static_cast<double>(count));
    }));
  }
  return result;
}

}  // namespace

Survey surveyed(const scene::Scene& scene, const MeasureOptions& options, const Progress& progress) {
  require_measurable(scene, options);
  Surveyor surveyor(scene, options);
  const std::size_t count = surveyor.count();
  std::size_t done = 0;
  std::mutex reporting;
  for (std::size_t begin = 0; begin < count; begin += batch_size) {
    std::vector<Broken> batch(std::min(batch_size, count - begin));
    parallel_for(batch.size(), [&](std::size_t i) {
      batch[i] = surveyor.broken(begin + i);
      const std::scoped_lock lock(reporting);
      ++done;
      if (progress) progress("measuring", static_cast<double>(done) / static_cast<double>(count));
    });
    for (std::size_t i = 0; i < batch.size(); ++i) surveyor.add(begin + i, std::move(batch[i]));
  }
  Survey survey = surveyor.finished();
  survey.pavements = surveyed_pavements(scene, options, progress);
  return survey;
}

}  // namespace shatterpave::pipeline
