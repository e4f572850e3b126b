// The panes and pavements of a scene over many seeds: what `measure` writes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "glass/network.h"
#include "glass/pane.h"
#include "measure/count_law.h"
#include "measure/distribution.h"
#include "measure/pane_measures.h"
#include "measure/pavement_findings.h"
#include "measure/pavement_measures.h"
#include "measure/summary.h"
#include "paving/pavement.h"
#include "paving/stones.h"

namespace shatterpave::measure {

// The numbers of an impact, without the values that they are made of.
struct ImpactFigures {
  glass::ImpactCounts drawn;  // M, N and R
  int reaching_count = 0;     // radial cracks that end on the edge
  EndCounts ends;
  int ring_crack_count = 0;
  int held_ring_end_count = 0;
  Distribution ring_distance_mm;  // its mean is d_ave
  Distribution turn_deg;
  Distribution edge_angle_deg;
  std::optional<double> gap_ratio;
  int crossing_count = 0;
  Distribution young_turn_deg;  // of turns near the impact, and of those farther out (young_turns_within)
  Distribution grown_turn_deg;
  std::optional<double> reaching_gap_variation;
};

ImpactFigures figures_of(const ImpactMeasures& measures);

// One pane of the scene, broken with one seed.
struct SurveyedPane {
  std::uint64_t seed = 0;
  std::size_t pane = 0;  // which of Survey::pane_names
  std::vector<ImpactFigures> impacts;
};

// A pane to look at.
struct Specimen {
  std::uint64_t seed = 0;
  glass::Pane pane;
  glass::CrackNetwork network;
};

// M in even steps over the seeds, from `low` for the first to `high` for the last.
struct Sweep {
  int low = 0;
  int high = 0;

  bool operator==(const Sweep&) const = default;
};

// A pavement of the scene, laid with one seed.
struct SurveyedLayout {
  std::uint64_t seed = 0;
  LayoutFigures figures;
};

struct SurveyedPavement {
  paving::Pavement pavement;
  std::vector<SurveyedLayout> layouts;  // seed by seed; the first one only, where no seed would change anything
  std::vector<Finding> findings;        // of all layouts
  paving::StoneLayout first_layout;     // as set out, of the first seed
  LayoutMeasures first_measures;
};

// The same panes, broken by the other law of growth.
struct OtherLaw {
  std::string name;  // "printed", "fitted"; "other" where the scene has panes of both
  Summary summary;   // of all panes together
};

struct Survey {
  std::string name;  // of the scene: stem of the file names
  std::vector<std::string> pane_names;
  std::uint64_t first_seed = 0;
  std::size_t seed_count = 0;
  std::optional<Sweep> sweep;           // where M is not what the scene says
  std::optional<CountLaw> count_law;    // by which M was drawn, where all panes have one law
  std::vector<SurveyedPane> panes;      // seed by seed, in each in the order of the scene
  Summary summary;                      // of all panes together; nothing in it where there are none
  std::vector<Summary> pane_summaries;  // of each pane of the scene
  std::optional<OtherLaw> other_law;
  std::vector<Specimen> specimens;  // the first panes; in a sweep some from all of it
  std::vector<SurveyedPavement> pavements;
};

}  // namespace shatterpave::measure
