#include "pipeline/generate.h"

#include <mutex>

#include "core/parallel.h"
#include "glass/crack_surface.h"
#include "glass/dice.h"
#include "glass/growth.h"
#include "glass/shards.h"
#include "paving/kerb.h"
#include "paving/laying.h"
#include "paving/seamless.h"

namespace shatterpave::pipeline {

void require_possible(const scene::Scene& scene) {
  for (const glass::Pane& pane : scene.panes) {
    if (pane.glass == glass::GlassKind::tempered) glass::require_few_fragments(pane);
  }
  for (const paving::Pavement& pavement : scene.pavements) {
    paving::require_layable(pavement);
    if (pavement.kerb.width_mm > 0.0) paving::require_layable(paving::kerb(pavement));
    if (pavement.textures.seamless) static_cast<void>(paving::seamless_tile(pavement, scene.seed));
  }
}

exporting::Model generated(const scene::Scene& scene, const Progress& progress) {
  exporting::Model model;
  model.name = scene.name;
  model.fingerprint = scene.fingerprint;
  model.setting = scene.still.setting;
  model.dispersion = scene.still.dispersion;
  model.caustics = scene.still.caustics;
  model.seed = scene.seed;
  for (const glass::Pane& pane : scene.panes) model.panes.push_back({pane, {}, {}});
  for (const paving::Pavement& pavement : scene.pavements) {
    model.pavements.push_back({pavement, {}});
    if (pavement.kerb.width_mm > 0.0) model.pavements.push_back({paving::kerb(pavement), {}});
  }

  const std::size_t panes = model.panes.size();
  const std::size_t count = panes + model.pavements.size();
  std::size_t done = 0;
  std::mutex reporting;
  if (progress) progress("generating", 0.0);
  parallel_for(count, [&](std::size_t i) {
    if (i < panes) {
      exporting::BrokenPane& broken = model.panes[i];
      broken.network = glass::grown_cracks(broken.pane, scene.seed);
      if (broken.pane.shards) {
        broken.shards = glass::shards(broken.pane, broken.network, scene.seed);
      } else if (broken.pane.crack_body == glass::CrackBody::sheet) {
        broken.surfaces = glass::crack_surfaces(broken.pane, broken.network, scene.seed);
      }
    } else {
      exporting::PavedArea& paved = model.pavements[i - panes];
      paved.layout = paving::laid_stones(paved.pavement, scene.seed);
      if (paved.pavement.textures.seamless) paved.tile = paving::seamless_tile(paved.pavement, scene.seed);
    }
    const std::scoped_lock lock(reporting);
    ++done;
    if (progress) progress("generating", static_cast<double>(done) / static_cast<double>(count));
  });
  return model;
}

}  // namespace shatterpave::pipeline
