#include "pipeline/generate.h"

#include <algorithm>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "glass/breaking.h"
#include "glass/gaps/crack_surface.h"
#include "glass/shards/shards.h"
#include "paving/derived/kerb.h"
#include "paving/laying.h"
#include "paving/seamless.h"
#include "pipeline/placed.h"

namespace shatterpave::pipeline {

namespace {

const scene::KeyPlaces& places_at(const std::vector<scene::KeyPlaces>& places, std::size_t i) {
  static const scene::KeyPlaces none;
  return i < places.size() ? places[i] : none;
}

// Of what a pavement of the model was made.
struct Origin {
  std::size_t pavement = 0;  // of the scene
  bool is_kerb = false;
};

// What is wrong with a kerb is wrong with the key that asks for it.
void with_kerb_places(const scene::KeyPlaces& places, const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    const Place place = places.place("ground.kerb_width_mm");
    if (!error.place().file.empty() || place.file.empty()) throw;
    throw InputError(place, "kerb: " + error.message());
  }
}

void break_pane(exporting::BrokenPane& broken, std::uint64_t seed) {
  broken.network = glass::broken(broken.pane, seed);
  if (broken.pane.shards) {
    broken.shards = glass::shards(broken.pane, broken.network, seed);
  } else if (broken.pane.crack_body == glass::CrackBody::sheet) {
    broken.surfaces = glass::crack_surfaces(broken.pane, broken.network, seed);
  }
}

void lay(exporting::PavedArea& paved, std::uint64_t seed) {
  paved.layout = paving::laid_stones(paved.pavement, seed);
  if (paved.pavement.textures.seamless) paved.tile = paving::seamless_tile(paved.pavement, seed);
}

// The names of what is in work, in the order in which it began.
class InWork {
 public:
  InWork(std::size_t count, const Progress& progress) : count_(count), progress_(progress) { report(); }

  // In work while it lives.
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

}  // namespace

void require_possible(const scene::Scene& scene) {
  for (std::size_t i = 0; i < scene.panes.size(); ++i) {
    const glass::Pane& pane = scene.panes[i];
    with_places(pane.name, places_at(scene.pane_places, i), [&] { glass::require_breakable(pane); });
  }
  for (std::size_t i = 0; i < scene.pavements.size(); ++i) {
    const paving::Pavement& pavement = scene.pavements[i];
    const scene::KeyPlaces& places = places_at(scene.pavement_places, i);
    with_places(pavement.name, places, [&] {
      paving::require_layable(pavement);
      if (pavement.textures.seamless) paving::require_seamless(pavement);
    });
    if (pavement.kerb.width_mm == 0.0) continue;
    with_kerb_places(places, [&] { paving::require_layable(paving::kerb(pavement)); });
  }
}

void require_possible_for(const exporting::Target& target, const scene::Scene& scene) {
  if (target.require == nullptr) return;
  try {
    target.require({scene.panes, scene.pavements});
  } catch (const InputError& error) {
    const auto tell_place = [&](const auto& things, const std::vector<scene::KeyPlaces>& places) {
      for (std::size_t i = 0; i < things.size(); ++i) {
        if (!error.place().key.starts_with(things[i].name + ".")) continue;
        with_places(things[i].name, places_at(places, i), [&] { throw InputError(error.place(), error.message()); });
      }
    };
    tell_place(scene.panes, scene.pane_places);
    tell_place(scene.pavements, scene.pavement_places);
    throw;
  }
}

exporting::Model generated(const scene::Scene& scene, const Progress& progress) {
  require_possible(scene);
  exporting::Model model;
  model.name = scene.name;
  model.fingerprint = scene.fingerprint;
  model.setting = scene.still.setting;
  model.dispersion = scene.still.dispersion;
  model.caustics = scene.still.caustics;
  model.seed = scene.seed;
  for (const glass::Pane& pane : scene.panes) model.panes.push_back({pane, {}, {}});
  std::vector<Origin> origins;
  for (std::size_t i = 0; i < scene.pavements.size(); ++i) {
    const paving::Pavement& pavement = scene.pavements[i];
    model.pavements.push_back({pavement, {}});
    origins.push_back({i, false});
    if (pavement.kerb.width_mm == 0.0) continue;
    model.pavements.push_back({paving::kerb(pavement), {}});
    origins.push_back({i, true});
  }

  const std::size_t panes = model.panes.size();
  const std::size_t count = panes + model.pavements.size();
  InWork in_work(count, progress);
  parallel_for(count, [&](std::size_t i) {
    if (i < panes) {
      exporting::BrokenPane& broken = model.panes[i];
      const InWork::Thing thing(in_work, broken.pane.name);
      with_places(broken.pane.name, places_at(scene.pane_places, i), [&] { break_pane(broken, scene.seed); });
      return;
    }
    exporting::PavedArea& paved = model.pavements[i - panes];
    const Origin& origin = origins[i - panes];
    const InWork::Thing thing(in_work, paved.pavement.name);
    const scene::KeyPlaces& places = places_at(scene.pavement_places, origin.pavement);
    if (origin.is_kerb) {
      with_kerb_places(places, [&] { lay(paved, scene.seed); });
    } else {
      with_places(paved.pavement.name, places, [&] { lay(paved, scene.seed); });
    }
  });
  return model;
}

}  // namespace shatterpave::pipeline
