// DXF is read by GDAL, from memory: a drawing may name no other file. What GDAL does not tell, the units of the drawing, stands
// in its header in plain text.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/input_file.h"
#include "scene/plans/gdal_library.h"
#include "scene/plans/plan.h"
#include "scene/plans/svg_lines.h"

namespace shatterpave::scene {

namespace {

constexpr std::size_t most_points = 4'000'000;

// $INSUNITS of the DXF reference (AutoCAD 2018), those in which things of this world are drawn.
struct DrawingUnit {
  int code;
  double metres;
};
constexpr std::array<DrawingUnit, 9> drawing_units = {
    {{1, 0.0254}, {2, 0.3048}, {4, 0.001}, {5, 0.01}, {6, 1.0}, {7, 1000.0}, {10, 0.9144}, {14, 0.1}, {21, 1200.0 / 3937.0}}};

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view space = " \t\r\n";
  const std::size_t first = text.find_first_not_of(space);
  return first == std::string_view::npos ? std::string_view() : text.substr(first, text.find_last_not_of(space) - first + 1);
}

// The next line; `text` is left with those after it.
std::string_view taken_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return trimmed(line);
}

std::optional<int> whole(std::string_view text) {
  int value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || stop != text.data() + text.size()) return std::nullopt;
  return value;
}

// The value of a variable of the header: pairs of lines, a code and a value. Empty where it is not there.
std::string_view header_value(std::string_view text, std::string_view variable) {
  while (!text.empty()) {
    const std::string_view code = taken_line(text);
    const std::string_view value = taken_line(text);
    if (code == "0" && value == "ENDSEC") return {};
    if (code != "9" || value != variable) continue;
    taken_line(text);
    return taken_line(text);
  }
  return {};
}

// From AutoCAD 2007 on texts are UTF-8, whatever code page the header names.
bool is_utf8(std::string_view text) {
  const std::string_view version = header_value(text, "$ACADVER");
  constexpr std::string_view first = "AC1021";
  return version.size() == first.size() && version >= first;
}

// What is cut off has no end.
void require_end(std::string_view text, const std::string& file) {
  constexpr std::string_view end = "EOF";
  const std::string_view body = trimmed(text);
  if (body.ends_with(end)) return;
  throw InputError(Place{file, 0, 0, ""}, "expected a whole DXF drawing, as text, which ends with EOF, got one that does not");
}

void set_units(std::string_view text, Plan& plan) {
  const std::optional<int> code = whole(header_value(text, "$INSUNITS"));
  const auto known = std::ranges::find_if(drawing_units, [&](const DrawingUnit& unit) { return code && unit.code == *code; });
  if (known != drawing_units.end()) {
    plan.units = PlanUnits{PlanUnits::Kind::length, known->metres};
    return;
  }
  const std::string got = code && *code != 0 ? fmt::format("$INSUNITS {}", *code) : "none";
  plan.no_units = InputError(Place{plan.file, 0, 0, ""},
                             "expected a drawing that tells its units ($INSUNITS), or outline_units in the scene, got " + got);
}

// A file of GDAL's in memory, and what it reads of it.
class Drawing {
 public:
  Drawing(std::string_view text, const std::string& file) : gdal_(gdal_library()), text_(text) {
    gdal_.push_error_handler(gdal_.quiet_error_handler);
    gdal_.error_reset();
    gdal_.set_thread_option("DXF_ENCODING", is_utf8(text) ? "UTF-8" : nullptr);
    // GDAL does not write to what it is told not to own.
    auto* const bytes = reinterpret_cast<GByte*>(text_.data());
    VSILFILE* const in_memory = gdal_.file_from_buffer(name, bytes, text_.size(), FALSE);
    if (in_memory != nullptr) gdal_.close_file(in_memory);
    const char* const drivers[] = {"DXF", nullptr};
    dataset_ = gdal_.open(name, GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers, nullptr, nullptr);
    layer_ = dataset_ == nullptr ? nullptr : gdal_.layer_by_name(dataset_, "entities");
    if (layer_ != nullptr) return;
    const std::string why = gdal_.last_error_message();
    close();
    throw InputError(Place{file, 0, 0, ""}, fmt::format("expected a DXF drawing, as text, got {}",
                                                        why.empty() ? "something else" : "an error: " + why));
  }
  ~Drawing() { close(); }
  Drawing(const Drawing&) = delete;
  Drawing& operator=(const Drawing&) = delete;

  // The next entity, or null. Of the caller.
  OGRFeatureH next() { return gdal_.next_feature(layer_); }
  // What went wrong since this was asked; empty where nothing did.
  std::string taken_fault() {
    std::string fault = gdal_.last_error_message();
    gdal_.error_reset();
    return fault;
  }

 private:
  static constexpr const char* name = "/vsimem/shatterpave-plan.dxf";

  void close() {
    if (dataset_ != nullptr) gdal_.close(dataset_);
    gdal_.unlink_file(name);
    gdal_.pop_error_handler();
  }

  const GdalLibrary& gdal_;
  std::string text_;
  GDALDatasetH dataset_ = nullptr;
  OGRLayerH layer_ = nullptr;
};

// Ends of lines meet within this, or where no units are told within this part of the drawing.
constexpr double ends_meet_m = 1e-4;
constexpr double whole_part = 1e-5;

class EntityReader {
 public:
  explicit EntityReader(Plan& plan) : plan_(plan), gdal_(gdal_library()) {}

  void read(OGRFeatureH entity) {
    if (is_hidden(entity)) return;
    place_ = {plan_.file, 0, 0,
              fmt::format("layer {}, entity {}", in_quotes(field(entity, "Layer")), field(entity, "EntityHandle"))};
    const OGRGeometryH geometry = gdal_.geometry(entity);
    if (geometry == nullptr || is_text(entity, geometry)) return;
    const std::size_t group = group_of(field(entity, "Layer"));
    PlanFeature feature;
    feature.group = group;
    const std::string handle = field(entity, "EntityHandle");
    if (!handle.empty()) feature.ids.push_back(handle);
    feature_ = plan_.features.size();
    plan_.features.push_back(std::move(feature));
    add(geometry);
  }

  // Lines that meet end to end in one layer are an outline.
  void join(double tolerance) { join_lines(pieces_, tolerance, plan_); }

 private:
  std::string field(OGRFeatureH entity, const char* name) const {
    const int index = gdal_.field_index(entity, name);
    return index < 0 ? std::string() : gdal_.field_text(entity, index);
  }

  // On paper, beside the model; or in a layer that is off or frozen: GDAL gives it a colour that nothing is seen of.
  bool is_hidden(OGRFeatureH entity) const {
    const int paper = gdal_.field_index(entity, "PaperSpace");
    if (paper >= 0 && gdal_.field_number(entity, paper) != 0) return true;
    const char* const style = gdal_.style_text(entity);
    if (style == nullptr) return false;
    const std::string_view text = style;
    const std::size_t colour = text.find("c:#");
    constexpr std::size_t alpha_at = 9;  // after "c:#rrggbb"
    return colour != std::string_view::npos && text.substr(colour + alpha_at, 2) == "00";
  }

  // Words are drawn at a point. (Of a hatch the text is the name of its pattern.)
  bool is_text(OGRFeatureH entity, OGRGeometryH geometry) const {
    const bool is_point = gdal_.without_heights(gdal_.geometry_type(geometry)) == wkbPoint;
    return field(entity, "SubClasses").find("Text") != std::string::npos || (is_point && !field(entity, "Text").empty());
  }

  // The feature that stands for a layer.
  std::size_t group_of(const std::string& layer) {
    const auto found = std::ranges::find(layers_, layer, &std::pair<std::string, std::size_t>::first);
    if (found != layers_.end()) return found->second;
    layers_.emplace_back(layer, plan_.features.size());
    plan_.features.push_back({{layer}, {}, {layer}, {}});
    return layers_.back().second;
  }

  Ring ring_of(OGRGeometryH line) {
    Ring ring{{}, place_};
    const int count = gdal_.point_count(line);
    points_ += static_cast<std::size_t>(count);
    if (points_ > most_points) {
      throw InputError(Place{plan_.file, 0, 0, ""},
                       fmt::format("expected a drawing of at most {} points, got more", most_points));
    }
    ring.points_mm.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) ring.points_mm.push_back({gdal_.x(line, i), gdal_.y(line, i)});
    return ring;
  }

  PlanShape shape_of(ShapeKind kind, std::vector<Ring> rings) const {
    PlanShape shape;
    shape.kind = kind;
    shape.rings = std::move(rings);
    shape.feature = feature_;
    return shape;
  }

  void add(OGRGeometryH geometry) {
    const OGRwkbGeometryType type = gdal_.without_heights(gdal_.geometry_type(geometry));
    if (type == wkbPolygon) {
      std::vector<Ring> rings;
      rings.reserve(static_cast<std::size_t>(gdal_.geometry_count(geometry)));
      for (int i = 0; i < gdal_.geometry_count(geometry); ++i) rings.push_back(ring_of(gdal_.part(geometry, i)));
      if (!rings.empty()) plan_.shapes.push_back(shape_of(ShapeKind::area, std::move(rings)));
    } else if (type == wkbLineString) {
      add_line(ring_of(geometry));
    } else if (type == wkbPoint) {
      plan_.shapes.push_back(shape_of(ShapeKind::point, {ring_of(geometry)}));
    } else if (gdal_.geometry_count(geometry) > 0) {
      for (int i = 0; i < gdal_.geometry_count(geometry); ++i) add(gdal_.part(geometry, i));
    }
  }

  // Whether the line ends where it starts: where it ends in an arc, that is rounded.
  bool comes_back(const std::vector<vec2>& points) const {
    geometry::Box box{points.front(), points.front()};
    for (const vec2& p : points) box = {glm::min(box.low, p), glm::max(box.high, p)};
    // Of a line so small that its ends are near each other anyhow, less.
    constexpr double part = 1e-3;
    const double size = glm::length(box.high - box.low);
    const double tolerance = plan_.units ? std::min(ends_meet_m / plan_.units->size, part * size) : whole_part * size;
    return glm::distance(points.front(), points.back()) <= tolerance;
  }

  void add_line(Ring line) {
    if (line.points_mm.size() < 2) return;
    const bool closed = line.points_mm.size() > 3 && comes_back(line.points_mm);
    if (closed) {
      line.points_mm.back() = line.points_mm.front();
      plan_.shapes.push_back(shape_of(ShapeKind::area, {line}));
    } else {
      pieces_.push_back({plan_.features[feature_].group, plan_.shapes.size(), std::nullopt});
    }
    PlanShape shape = shape_of(ShapeKind::line, {std::move(line)});
    // What closes is an area to whoever asks for areas too.
    if (closed) shape.asked_for = AskedFor::lines_alone;
    plan_.shapes.push_back(std::move(shape));
  }

  Plan& plan_;
  const GdalLibrary& gdal_;
  std::vector<std::pair<std::string, std::size_t>> layers_;
  std::vector<OutlinePiece> pieces_;
  std::size_t feature_ = 0;
  std::size_t points_ = 0;
  Place place_;
};

// Within which ends of lines meet: a tenth of a millimetre, or where no units are told 1 / 100,000 of the drawing.
double join_tolerance(const Plan& plan) {
  if (plan.units) return ends_meet_m / plan.units->size;
  std::optional<geometry::Box> box;
  for (const PlanShape& shape : plan.shapes) {
    for (const Ring& ring : shape.rings) {
      for (const vec2& p : ring.points_mm)
        box = box ? geometry::Box{glm::min(box->low, p), glm::max(box->high, p)} : geometry::Box{p, p};
    }
  }
  if (!box) return 1.0;
  const vec2 size = box->high - box->low;
  return std::max({whole_part * size.x, whole_part * size.y, std::numeric_limits<double>::min()});
}

}  // namespace

Plan plan_of_dxf(std::string_view text, const std::string& file) {
  Plan plan;
  plan.file = file;
  require_end(text, file);
  set_units(text, plan);
  Drawing drawing(text, file);
  EntityReader reader(plan);
  const auto destroy = [](OGRFeatureH entity) { gdal_library().destroy_feature(entity); };
  using Entity = std::unique_ptr<std::remove_pointer_t<OGRFeatureH>, decltype(destroy)>;
  for (Entity entity(drawing.next(), destroy); entity; entity.reset(drawing.next())) reader.read(entity.get());
  const std::string fault = drawing.taken_fault();
  if (!fault.empty()) {
    plan.notes.push_back({Place{file, 0, 0, ""}, "expected entities that GDAL reads, left out one or more: " + fault});
  }
  reader.join(join_tolerance(plan));
  return plan;
}

}  // namespace shatterpave::scene
