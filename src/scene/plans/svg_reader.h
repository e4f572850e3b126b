// The elements of an SVG document as shapes of a plan.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "scene/input_file.h"
#include "scene/plans/plan.h"
#include "scene/plans/svg_lines.h"
#include "scene/plans/svg_shapes.h"
#include "scene/plans/svg_style.h"

namespace shatterpave::scene {

// What an element hands on to those inside it.
struct SvgInherited {
  enum class Fill { unsaid, none, painted };

  Affine to_mm;
  vec2 viewport{0.0, 0.0};  // in user units, for percentages
  FillRule fill_rule = FillRule::nonzero;
  FillRule clip_rule = FillRule::nonzero;
  Fill fill = Fill::unsaid;
  bool visible = true;
  bool transparent = false;  // wholly, itself or what it lies in
  bool copied = false;       // by `use`: ids are those of the original
  std::optional<std::size_t> group;
  int depth = 0;
};

// Reads one document into one plan.
class SvgReader {
 public:
  // `text` is the document in UTF-8; it and the plan must outlive this.
  SvgReader(std::string_view text, double scale, Plan& plan);

  // Throws InputError.
  void read(const pugi::xml_node& svg);

 private:
  using Regions = std::vector<geometry::Region>;

  Place place_of(const pugi::xml_node& node) const;
  std::string_view value(const pugi::xml_node& node, const char* property) const { return styles_.value(node, property); }
  Lengths lengths_of(const pugi::xml_node& node, vec2 viewport) const { return {node, viewport, property_of_}; }

  void read_styles(const pugi::xml_node& svg);
  void add_style(const pugi::xml_node& style);
  void visit_children(const pugi::xml_node& node, const SvgInherited& inherited);
  void visit_first(const pugi::xml_node& node, const SvgInherited& inherited);
  // `sized_by` is the `use` whose width and height a viewport takes, if one refers to it.
  void visit(const pugi::xml_node& node, const SvgInherited& from_parent, const pugi::xml_node& sized_by = {});
  void visit_within(const pugi::xml_node& node, const SvgInherited& inherited, const pugi::xml_node& sized_by);
  void visit_used(const pugi::xml_node& use, const SvgInherited& inherited);
  void visit_viewport(const pugi::xml_node& node, const SvgInherited& inherited, const pugi::xml_node& sized_by);

  // How an element hands on what it got.
  void take_styles(const pugi::xml_node& node, SvgInherited& inherited) const;
  std::optional<Affine> transform_of_element(const pugi::xml_node& node) const;
  SvgInherited handed_on(const pugi::xml_node& node, const SvgInherited& from_parent);
  bool is_hidden(const pugi::xml_node& node) const { return value(node, "display") == "none"; }
  bool is_transparent(const pugi::xml_node& node) const;

  // Shapes.
  void add(const pugi::xml_node& node, std::string_view name, const SvgInherited& inherited);
  void add_hidden(const std::vector<Subpath>& subpaths);
  std::optional<std::vector<std::size_t>> add_lines(const std::vector<Subpath>& subpaths, const Place& place,
                                                    const SvgInherited& inherited, PlanShape& closed, PlanShape& filled);
  void add_areas(const std::vector<Subpath>& subpaths, const Place& place, const SvgInherited& inherited);
  void add_unread(const pugi::xml_node& node, const SvgInherited& from_parent);
  std::size_t keep(PlanShape shape);

  // Where the shapes of an element begin.
  struct Begin {
    std::size_t shapes = 0;
    std::size_t hidden = 0;
  };
  Begin begin() const { return {plan_.shapes.size(), hidden_.size()}; }

  // What clip paths, viewports and masks leave of the shapes from `first` on (svg_clip.cpp).
  void limit_shapes(const pugi::xml_node& node, const Affine& to_mm, vec2 viewport, Begin first);
  void clip_shapes(const Regions& clip, std::size_t first);
  void refuse_shapes(const pugi::xml_node& node, const std::string& expected, std::size_t first);
  std::optional<Regions> clip_of(const pugi::xml_node& node, const Affine& to_mm, vec2 viewport, Begin first);
  Regions clip_regions(const pugi::xml_node& clip, const Affine& to_mm, vec2 viewport, int depth);
  Regions clip_child(const pugi::xml_node& child, const pugi::xml_node& ruled_by, const Affine& to_mm, vec2 viewport,
                     int depth);
  Regions clip_shape(const pugi::xml_node& shape, const pugi::xml_node& ruled_by, const Affine& to_mm, vec2 viewport);
  Regions clipped_child(const pugi::xml_node& child, Regions regions, const Affine& to_mm, vec2 viewport, int depth);
  Affine unit_box(const Affine& to_mm, Begin first) const;
  // The node that url(#id) names, if there is one.
  pugi::xml_node node_of_url(std::string_view url);
  std::string_view inherited_value(const pugi::xml_node& node, const char* property) const;
  pugi::xml_node referred(const pugi::xml_node& use);
  const std::map<std::string_view, pugi::xml_node>& nodes_by_id();

  TextIndex index_;
  double scale_;
  Plan& plan_;
  SvgStyles styles_;
  PropertyOf property_of_;
  pugi::xml_node root_;
  std::map<std::string_view, pugi::xml_node> nodes_by_id_;
  std::vector<OutlinePiece> pieces_;
  std::vector<PlanShape> hidden_;  // not drawn, but in the boxes about what they lie in (SVG 2, 8.10)
  std::size_t visited_ = 0;
  std::size_t points_ = 0;
};

}  // namespace shatterpave::scene
