#include "pipeline/generate.h"

#include <algorithm>
#include <iterator>
#include <mutex>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "glass/breaking.h"
#include "glass/gaps/crack_surface.h"
#include "glass/map/growth_clock.h"
#include "glass/shards/shards.h"
#include "paving/laying.h"
#include "paving/seamless.h"
#include "pipeline/parts.h"
#include "pipeline/placed.h"

namespace shatterpave::pipeline {

namespace {

// What is made of the cracks is made of all that come to be, and shows what of them is there at the pane's time.
void break_pane(exporting::BrokenPane& broken, std::uint64_t seed) {
  broken.network = glass::broken(broken.pane, seed);
  broken.far_network = glass::broken_far_sheet(broken.pane, broken.network, seed);
  if (broken.pane.shards) {
    broken.shards = glass::shards(broken.pane, broken.network, seed);
  } else if (broken.pane.crack_body == glass::CrackBody::sheet) {
    broken.surfaces = glass::crack_surfaces(broken.pane, broken.network, seed);
    std::ranges::move(glass::far_surfaces(broken.pane, broken.network, broken.far_network, seed),
                      std::back_inserter(broken.surfaces.surfaces));
  }
  if (!broken.pane.time_us) return;
  broken.network = glass::network_at(broken.pane, broken.network, *broken.pane.time_us);
  broken.far_network = glass::network_at(broken.pane, broken.far_network, *broken.pane.time_us);
  broken.pane.impacts.resize(std::min(broken.pane.impacts.size(), broken.network.impacts.size()));
}

void lay(exporting::PavedArea& paved, paving::StonePart stones, std::uint64_t seed) {
  paved.layout = paving::laid_stones(paved.pavement, seed);
  if (stones != paving::StonePart::field) {
    for (paving::Stone& stone : paved.layout.stones) stone.part = stones;
  }
  if (paved.pavement.textures.seamless) paved.tile = paving::seamless_tile(paved.pavement, seed);
}

// The names of the things that are being made, in the order in which they were begun.
class InWork {
 public:
  InWork(std::size_t count, const Progress& progress) : count_(count), progress_(progress) { report(); }

  // The thing is being made while this lives.
  class Thing {
   public:
    Thing(InWork& in_work, const std::string& name) : in_work_(in_work), name_(name) { in_work_.begin(name_); }
    ~Thing() { in_work_.end(name_); }
    Thing(const Thing&) = delete;
    Thing& operator=(const Thing&) = delete;

   private:
    InWork& in_work_;
    const std::string& name_;
  };

 private:
  void begin(const std::string& name) {
    const std::scoped_lock lock(mutex_);
    names_.push_back(name);
    report();
  }
  void end(const std::string& name) {
    const std::scoped_lock lock(mutex_);
    names_.erase(std::ranges::find(names_, name));
    ++done_;
    report();
  }
  void report() const {
    constexpr std::size_t most_named = 3;
    if (!progress_) return;
    std::string what = "generating";
    for (std::size_t i = 0; i < std::min(names_.size(), most_named); ++i) what += (i == 0 ? " " : ", ") + names_[i];
    if (names_.size() > most_named) what += " …";
    progress_(what, static_cast<double>(done_) / static_cast<double>(std::max<std::size_t>(count_, 1)));
  }

  std::size_t count_;
  const Progress& progress_;
  std::mutex mutex_;
  std::vector<std::string> names_;
  std::size_t done_ = 0;
};

void require_possible(const scene::Scene& scene, const std::vector<PavementPart>& parts) {
  for (std::size_t i = 0; i < scene.panes.size(); ++i) {
    const glass::Pane& pane = scene.panes[i];
    with_places(pane.name, places_at(scene.pane_places, i), [&] { glass::require_breakable(pane); });
  }
  for (const PavementPart& part : parts) {
    with_places(scene, part, [&] {
      paving::require_layable(part.pavement);
      if (part.pavement.textures.seamless) paving::require_seamless(part.pavement);
    });
  }
}

// The model of the scene, of which nothing is broken or laid yet.
exporting::Model unmade(const scene::Scene& scene, const std::vector<PavementPart>& parts) {
  exporting::Model model;
  model.name = scene.name;
  model.fingerprint = scene.fingerprint;
  model.setting = scene.still.setting;
  model.dispersion = scene.still.dispersion;
  model.caustics = scene.still.caustics;
  model.seed = scene.seed;
  model.camera = scene.camera;
  model.light = scene.light;
  model.environment = scene.environment;
  for (const glass::Pane& pane : scene.panes) model.panes.push_back({pane, {}, {}});
  for (const PavementPart& part : parts) model.pavements.push_back({part.pavement, {}});
  return model;
}

}  // namespace

void require_possible(const scene::Scene& scene) { require_possible(scene, pavement_parts(scene)); }

void require_possible_for(const exporting::Target& target, const scene::Scene& scene) {
  if (target.require == nullptr) return;
  const std::vector<PavementPart> parts = pavement_parts(scene);
  std::vector<paving::Pavement> pavements;
  pavements.reserve(parts.size());
  for (const PavementPart& part : parts) pavements.push_back(part.pavement);
  try {
    target.require({scene.panes, pavements});
  } catch (const InputError& error) {
    const auto is_of = [&](const std::string& name) { return error.place().key.starts_with(name + "."); };
    const auto refuse = [&] { throw InputError(error.place(), error.message()); };
    for (std::size_t i = 0; i < scene.panes.size(); ++i) {
      const std::string& name = scene.panes[i].name;
      if (is_of(name)) with_places(name, places_at(scene.pane_places, i), refuse);
    }
    for (const PavementPart& part : parts) {
      if (is_of(part.pavement.name)) with_places(scene, part, refuse);
    }
    throw;
  }
}

exporting::Model generated(const scene::Scene& scene, const Wanted& wanted, const Progress& progress) {
  const std::vector<PavementPart> parts = pavement_parts(scene);
  require_possible(scene, parts);
  exporting::Model model = unmade(scene, parts);
  const std::size_t panes = model.panes.size();
  std::vector<std::size_t> things;
  for (std::size_t i = 0; i < panes + model.pavements.size(); ++i) {
    if (wanted(i)) things.push_back(i);
  }
  if (things.empty()) return model;
  InWork in_work(things.size(), progress);
  parallel_for(things.size(), [&](std::size_t k) {
    const std::size_t i = things[k];
    if (i < panes) {
      exporting::BrokenPane& broken = model.panes[i];
      const InWork::Thing thing(in_work, broken.pane.name);
      with_places(broken.pane.name, places_at(scene.pane_places, i), [&] { break_pane(broken, scene.seed); });
      return;
    }
    exporting::PavedArea& paved = model.pavements[i - panes];
    const InWork::Thing thing(in_work, paved.pavement.name);
    const PavementPart& part = parts[i - panes];
    with_places(scene, part, [&] { lay(paved, part.stones, scene.seed); });
  });
  return model;
}

exporting::Model generated(const scene::Scene& scene, const Progress& progress) {
  return generated(
      scene, [](std::size_t /*thing*/) { return true; }, progress);
}

}  // namespace shatterpave::pipeline
