#include "export/svg/drawing_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "export/names.h"
#include "export/svg/text.h"

namespace shatterpave::exporting::svg {

namespace {

// Line widths as fractions of the larger side of the drawing: by eye, so that a pane of 300 mm and a plaza of 50 m both read.
constexpr double outline_width = 1.0 / 600.0;
constexpr double crack_width = 1.0 / 1500.0;

// y points down in SVG. Adding 0 turns −0 into 0.
void put_points(Buffer& out, const std::vector<vec2>& points) {
  bool first = true;
  for (const vec2& p : points) {
    put(out, "{}{},{}", first ? "" : " ", p.x + 0.0, 0.0 - p.y);
    first = false;
  }
}

void put_path(Buffer& out, const geometry::Polygon& ring) {
  put(out, "M");
  put_points(out, ring);
  put(out, "Z");
}

// The file up to the drawing itself: size, and looks that a user may change in one place.
void put_head(Buffer& out, const geometry::Polygon& outline, std::string_view title, std::string_view style) {
  const geometry::Box box = geometry::bounding_box(outline);
  const vec2 size = box.high - box.low;
  const double side = std::max(size.x, size.y);
  const double margin = outline_width * side;  // room for the outline's own stroke
  const double width = size.x + 2.0 * margin;
  const double height = size.y + 2.0 * margin;
  put(out,
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}mm\" height=\"{}mm\" "
      "viewBox=\"{} {} {} {}\">\n",
      width, height, box.low.x - margin, -box.high.y - margin, width, height);
  put(out, "<title>{}</title>\n<style>\n.outline{{fill:#fff;stroke:#000;stroke-width:{};fill-rule:evenodd}}\n{}</style>\n",
      title, outline_width * side, style);
}

std::string crack_style(const BrokenPane& broken) {
  const geometry::Box box = geometry::bounding_box(broken.pane.outline_mm);
  const vec2 size = box.high - box.low;
  const double width = crack_width * std::max(size.x, size.y);
  // Kinds that the paper's panes do not have.
  std::string more;
  const auto has = [&](glass::CrackKind kind) {
    return std::ranges::any_of(broken.network.cracks, [kind](const glass::Crack& crack) { return crack.kind == kind; });
  };
  if (has(glass::CrackKind::branch)) more += ".branch{stroke:#000}\n";
  if (has(glass::CrackKind::dice)) more += ".dice{stroke:#222}\n";
  if (has(glass::CrackKind::rung)) more += ".rung{stroke:#b03a2e}\n";
  if (has(glass::CrackKind::chip)) more += ".chip{stroke:#666}\n";
  if (!broken.far_network.cracks.empty()) more += "#far-cracks{opacity:0.4}\n";
  return fmt::format(
      ".crack{{fill:none;stroke-linejoin:round;stroke-linecap:round;stroke-width:{}}}\n.large{{stroke:#000;stroke-width:{}}}\n"
      ".radial{{stroke:#444}}\n.circular{{stroke:#b03a2e}}\n{}",
      width, 1.6 * width, more);
}

OutputFile pane_drawing(const Model& model, const BrokenPane& broken) {
  Buffer out;
  put_head(out, broken.pane.outline_mm, broken.pane.name, crack_style(broken));
  put(out, "<path class=\"outline\" id=\"outline\" d=\"");
  put_path(out, broken.pane.outline_mm);
  put(out, "\"/>\n");
  const auto put_cracks = [&](std::string_view group, const glass::CrackNetwork& network) {
    put(out, "<g id=\"{}\">\n", group);
    for (const glass::Crack& crack : network.cracks) {
      put(out, "<polyline class=\"crack {}\" id=\"crack-{}\" points=\"", name_of(crack.kind), crack.id);
      put_points(out, crack.points_mm);
      put(out, "\"/>\n");
    }
    put(out, "</g>\n");
  };
  if (!broken.far_network.cracks.empty()) put_cracks("far-cracks", broken.far_network);
  put_cracks("cracks", broken.network);
  put(out, "</svg>\n");
  return {fmt::format("{}-{}.svg", model.name, broken.pane.name), fmt::to_string(out)};
}

OutputFile pavement_drawing(const Model& model, const PavedArea& paved) {
  const geometry::Region& area = paved.pavement.area;
  Buffer out;
  put_head(out, area.outline, paved.pavement.name, ".stone{stroke:none}\n.whole{fill:#8c8c88}\n.cut{fill:#b5b3ab}\n");
  put(out, "<path class=\"outline\" id=\"outline\" d=\"");
  put_path(out, area.outline);
  for (const geometry::Polygon& hole : area.holes) put_path(out, hole);
  put(out, "\"/>\n<g id=\"stones\">\n");
  for (const paving::Stone& stone : paved.layout.stones) {
    put(out, "<polygon class=\"stone {} {}\" id=\"stone-{}\" points=\"", name_of(stone.part), name_of(stone.kind), stone.id);
    put_points(out, stone.outline_mm);
    put(out, "\"/>\n");
  }
  put(out, "</g>\n</svg>\n");
  return {fmt::format("{}-{}.svg", model.name, paved.pavement.name), fmt::to_string(out)};
}

}  // namespace

std::vector<OutputFile> svg_files(const Model& model) {
  std::vector<OutputFile> files;
  for (const BrokenPane& pane : model.panes) files.push_back(pane_drawing(model, pane));
  for (const PavedArea& paved : model.pavements) files.push_back(pavement_drawing(model, paved));
  return files;
}

void append(const Model& model, Outputs& outputs) { std::ranges::move(svg_files(model), std::back_inserter(outputs.files)); }

}  // namespace shatterpave::exporting::svg
