// The keys by which [[pane]] and [[pavement]] take areas and lines from plans.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/notes.h"
#include "geometry/polygon.h"
#include "scene/plans/plan_frame.h"
#include "scene/toml/toml_table.h"

namespace shatterpave::scene {

// The plans of one scene. Each file is read once. All plans in the same units share one frame, so that features keep their
// places to each other: the first shapes that are taken fix it, or [plan] does.
class Plans {
 public:
  // `root` is the root of the scene, which may have a table [plan]. `notes` is where it is told what of a plan is read
  // otherwise than it was written; it must outlive this.
  Plans(const TomlTable& root, std::vector<Note>& notes);

  std::vector<Note>& notes() { return notes_; }

  const Plan& plan(const TomlTable& table, std::string_view file_key) { return plan(table, file_key, svg_scale_); }
  // The same with a scale of its own, if it is an SVG.
  const Plan& plan(const TomlTable& table, std::string_view file_key, double svg_scale);
  // That something else was read from a file with that sum.
  void note_sum(const std::string& sum) { other_sums_ += sum; }
  // The sums of all plans that were read, one after the other.
  std::string sums() const;
  PlanFrame frame(const Plan& plan, const std::vector<std::size_t>& shapes, std::optional<PlanUnits> units);

 private:
  struct SharedFrame {
    bool svg = false;
    PlanUnits units;
    PlanFrame frame;
  };

  std::vector<Note>& notes_;
  std::optional<vec2> origin_;
  double svg_scale_ = 1.0;
  std::map<std::pair<std::string, double>, Plan> plans_;  // by their paths and scales
  std::string other_sums_;
  std::vector<SharedFrame> frames_;
};

// The areas that `outline_file` and the keys about it give; one or more.
std::vector<geometry::Region> outlines_of_plan(const TomlTable& table, Plans& plans);

// The areas without the holes that `holes_file`, `holes_feature` or `holes_class` give, if any of them is there.
std::vector<geometry::Region> without_holes_of_plan(const TomlTable& table, Plans& plans, std::vector<geometry::Region> areas);

// Whether `direction` takes guides from a plan, and the lines.
bool has_guides_of_plan(const TomlTable& direction);
std::vector<std::vector<vec2>> guides_of_plan(const TomlTable& direction, const TomlTable& pavement, Plans& plans);

}  // namespace shatterpave::scene
