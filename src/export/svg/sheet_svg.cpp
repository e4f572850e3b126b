#include "export/svg/sheet_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "export/names.h"
#include "export/svg/text.h"
#include "paving/quantities/quantities.h"
#include "studio/world.h"

namespace shatterpave::exporting::svg {

namespace {

using paving::PartQuantities;
using paving::Quantities;
using paving::StonePart;

// Paper, in millimetres: ISO 216, lying.
struct Paper {
  std::string_view name;
  vec2 size;
};
constexpr std::array<Paper, 5> papers = {
    {{"A4", {297, 210}}, {"A3", {420, 297}}, {"A2", {594, 420}}, {"A1", {841, 594}}, {"A0", {1189, 841}}}};

// By eye, as drawing offices have them: what stays free at the edges, and a column for the words.
constexpr double margin = 10.0;
constexpr double column_width = 92.0;
constexpr double gap = 6.0;
constexpr double row_height = 4.2;

// Of paper to a thousandth of a millimetre: finer than any printer, and short.
std::string number(double value) {
  const double rounded = std::round(value * 1000.0) / 1000.0 + 0.0;
  return fmt::format("{}", rounded);
}

struct Colour {
  std::string_view part;
  std::string_view whole;
  std::string_view cut;
};
constexpr std::array<Colour, 4> colours = {{{"field", "#9a9a94", "#c9c7bd"},
                                            {"border", "#6f7f8c", "#aab6bf"},
                                            {"kerb", "#5b5b5b", "#8e8e8e"},
                                            {"step", "#8a7f70", "#bfb6a8"}}};

vec2 on_plan(vec2 p_mm, const PavedArea& paved) {
  const vec3 at = studio::placed({p_mm.x, p_mm.y, 0.0}, paved.pavement.placement);
  return {at.x, at.y};
}

geometry::Box box_of(const Model& model) {
  std::optional<geometry::Box> box;
  for (const PavedArea& paved : model.pavements) {
    for (const vec2& corner : paved.pavement.area.outline) {
      const vec2 p = on_plan(corner, paved);
      box = box ? geometry::Box{glm::min(box->low, p), glm::max(box->high, p)} : geometry::Box{p, p};
    }
  }
  ENSURE(box.has_value());
  return *box;
}

vec2 room_on(const Paper& paper) { return paper.size - vec2{2.0 * margin + column_width + gap, 2.0 * margin}; }

bool fits(vec2 drawing, const Paper& paper) {
  const vec2 room = room_on(paper);
  return drawing.x <= room.x && drawing.y <= room.y;
}

// The usual scale next below the one at which the drawing would just fit the largest paper.
double scale_that_fits(vec2 size_mm) {
  constexpr std::array usual = {1.0,   2.0,   5.0,   10.0,   20.0,   25.0,   50.0,  100.0,
                                200.0, 250.0, 500.0, 1000.0, 2000.0, 2500.0, 5000.0};
  for (const double scale : usual) {
    if (fits(size_mm / scale, papers.back())) return scale;
  }
  return smallest_scale;
}

const Paper& paper_for(vec2 size_mm, double scale) {
  const auto paper = std::ranges::find_if(papers, [&](const Paper& one) { return fits(size_mm / scale, one); });
  if (paper != papers.end()) return *paper;
  throw InputError(fmt::format("--scale: expected a scale at which {:.1f} × {:.1f} m fit A0, such as 1:{}, got 1:{}",
                               size_mm.x / 1000.0, size_mm.y / 1000.0, scale_that_fits(size_mm), scale));
}

class Sheet {
 public:
  Sheet(const Model& model, double scale)
      : model_(model), scale_(scale), box_(box_of(model)), paper_(paper_for(box_.high - box_.low, scale)) {}

  std::string text() {
    put_head();
    put_plan();
    put_words();
    put(out_, "</svg>\n");
    return fmt::to_string(out_);
  }

 private:
  // From the plan to paper, y down. The plan lies in the upper left corner of its room.
  std::string paper_point(vec2 p) const {
    const vec2 at = (p - vec2{box_.low.x, box_.high.y}) / scale_;
    return number(margin + at.x) + "," + number(margin - at.y);
  }
  void put_ring(const geometry::Polygon& ring, const PavedArea& paved) {
    std::string_view between;
    for (const vec2& p : ring) {
      put(out_, "{}{}", between, paper_point(on_plan(p, paved)));
      between = " ";
    }
  }

  void put_head() {
    put(out_,
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}mm\" "
        "height=\"{1}mm\" "
        "viewBox=\"0 0 {0} {1}\">\n<title>{2}, 1:{3}</title>\n<style>\ntext{{font-family:sans-serif;font-size:2.8px}}\n"
        ".head{{font-size:5px;font-weight:bold}}\n.end{{text-anchor:end}}\n.middle{{text-anchor:middle}}\n"
        ".outline{{fill:none;stroke:#000;stroke-width:0.35}}\n.stone{{stroke:#000;stroke-width:0.05}}\n"
        ".rule{{fill:none;stroke:#000;stroke-width:0.25}}\n",
        number(paper_.size.x), number(paper_.size.y), model_.name, number(scale_));
    for (const Colour& colour : colours) {
      put(out_, ".{0}.whole{{fill:{1}}}\n.{0}.cut{{fill:{2}}}\n", colour.part, colour.whole, colour.cut);
    }
    put(out_, "</style>\n<rect width=\"{}\" height=\"{}\" fill=\"#fff\"/>\n", number(paper_.size.x), number(paper_.size.y));
  }

  void put_plan() {
    for (const PavedArea& paved : model_.pavements) {
      put(out_, "<g id=\"{}\">\n", paved.pavement.name);
      for (const paving::Stone& stone : paved.layout.stones) {
        put(out_, "<polygon class=\"stone {} {}\" id=\"{}-stone-{}\" points=\"", name_of(stone.part), name_of(stone.kind),
            paved.pavement.name, stone.id);
        put_ring(stone.outline_mm, paved);
        put(out_, "\"/>\n");
      }
      put(out_, "<path class=\"outline\" d=\"M");
      put_ring(paved.pavement.area.outline, paved);
      put(out_, "Z");
      for (const geometry::Polygon& hole : paved.pavement.area.holes) {
        put(out_, "M");
        put_ring(hole, paved);
        put(out_, "Z");
      }
      put(out_, "\"/>\n</g>\n");
    }
  }

  // The column on the right, from top to bottom.
  void put_words() {
    x_ = paper_.size.x - margin - column_width;
    y_ = margin + 5.0;
    put(out_, "<g id=\"words\">\n<text class=\"head\" x=\"{}\" y=\"{}\">{}</text>\n", number(x_), number(y_), model_.name);
    y_ += 7.0;
    put_text(0.0, "", fmt::format("1:{} on {}; lengths in m", number(scale_), paper_.name));
    put_north();
    put_scale_bar();
    put_legend();
    put_quantities();
    put(out_, "</g>\n");
  }

  void put_text(double x, std::string_view anchor, std::string_view text) {
    put(out_, "<text{} x=\"{}\" y=\"{}\">{}</text>\n", anchor.empty() ? "" : fmt::format(" class=\"{}\"", anchor),
        number(x_ + x), number(y_), text);
  }

  void put_north() {
    const double x = x_ + column_width - 8.0;
    put(out_,
        "<g id=\"north\"><path d=\"M{0},{1}l3,12l-3,-2.5l-3,2.5z\"/><text class=\"middle\" x=\"{0}\" y=\"{2}\">N</text></g>\n",
        number(x), number(margin), number(margin + 15.5));
  }

  // Of a round length that is 35 to 80 mm of paper long.
  void put_scale_bar() {
    double length_mm = 1.0;
    for (const double factor : {1.0, 2.0, 5.0}) {
      for (double power = 1.0; power <= 1e6; power *= 10.0) {
        const double on_paper = factor * power / scale_;
        if (on_paper > length_mm / scale_ && on_paper <= 80.0) length_mm = factor * power;
      }
    }
    y_ += 10.0;
    const double width = length_mm / scale_;
    put(out_, "<g id=\"scale-bar\">\n");
    constexpr int parts = 4;
    for (int i = 0; i < parts; ++i) {
      put(out_, "<rect class=\"rule\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"2\" style=\"fill:{}\"/>\n",
          number(x_ + width * i / parts), number(y_), number(width / parts), i % 2 == 0 ? "#000" : "#fff");
    }
    y_ += 5.5;
    put_text(0.0, "", "0");
    put_text(width, "end", fmt::format("{} m", number(length_mm / 1000.0)));
    put(out_, "</g>\n");
  }

  void put_legend() {
    y_ += 8.0;
    for (std::size_t i = 0; i < colours.size(); ++i) {
      const Colour& colour = colours[i];
      const auto has = [&](paving::StoneKind kind) {
        return std::ranges::any_of(model_.pavements, [&](const PavedArea& paved) {
          return std::ranges::any_of(paved.layout.stones, [&](const paving::Stone& stone) {
            return name_of(stone.part) == colour.part && stone.kind == kind;
          });
        });
      };
      for (const auto& [kind, fill] :
           {std::pair(paving::StoneKind::whole, colour.whole), std::pair(paving::StoneKind::cut, colour.cut)}) {
        if (!has(kind)) continue;
        put(out_, "<rect class=\"rule\" x=\"{}\" y=\"{}\" width=\"6\" height=\"3\" style=\"fill:{}\"/>\n", number(x_),
            number(y_ - 2.7), fill);
        put_text(8.0, "", fmt::format("{}, {}", colour.part, name_of(kind)));
        y_ += row_height;
      }
    }
  }

  struct Cells {
    std::string name;
    std::array<std::string, 5> numbers;
  };

  void put_row(const Cells& cells) {
    constexpr std::array<double, 5> ends = {46.0, 57.0, 66.0, 79.0, 92.0};
    put_text(0.0, "", cells.name);
    for (std::size_t i = 0; i < ends.size(); ++i) put_text(ends[i], "end", cells.numbers[i]);
    y_ += row_height;
  }

  void put_quantities() {
    std::vector<Quantities> all(model_.pavements.size());
    parallel_for(all.size(),
                 [&](std::size_t i) { all[i] = paving::quantities(model_.pavements[i].pavement, model_.pavements[i].layout); });
    std::vector<Cells> rows;
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (const PartQuantities& part : all[i].parts) {
        const double area_m2 = (part.whole.area_mm2 + part.cut.area_mm2) / 1e6;
        rows.push_back({fmt::format("{} {}", shortened(model_.pavements[i].pavement.name), name_of(part.part)),
                        {fmt::format("{:.2f}", area_m2), fmt::format("{}", part.whole.count), fmt::format("{}", part.cut.count),
                         fmt::format("{}", part.order), fmt::format("{}", part.order_reusing)}});
      }
      rows.push_back(
          {fmt::format("{} joints", shortened(model_.pavements[i].pavement.name)),
           {fmt::format("{:.2f}", all[i].joint_mm2 / 1e6), "", "", "", fmt::format("{:.1f} m", all[i].joint_mm / 1000.0)}});
    }
    y_ += 6.0;
    put_row({"", {"m²", "whole", "cut", "to order", "reusing"}});
    put(out_, "<path class=\"rule\" d=\"M{},{}h{}\"/>\n", number(x_), number(y_ - 3.2), number(column_width));
    const auto room = static_cast<std::size_t>(std::max(0.0, (paper_.size.y - margin - y_) / row_height));
    const bool all_fit = rows.size() <= room;
    const std::size_t shown = all_fit ? rows.size() : room - 1;
    for (std::size_t i = 0; i < shown; ++i) put_row(rows[i]);
    if (!all_fit) put_text(0.0, "", fmt::format("and {} rows more: see --target csv", rows.size() - shown));
  }

  // Names of things are ASCII.
  static std::string shortened(const std::string& name) {
    constexpr std::size_t most = 14;
    return name.size() <= most ? name : name.substr(0, most - 1) + "…";
  }

  const Model& model_;
  double scale_;
  geometry::Box box_;
  const Paper& paper_;
  Buffer out_;
  double x_ = 0.0;  // of the column
  double y_ = 0.0;  // of the next line in it
};

}  // namespace

OutputFile sheet(const Model& model, double scale) {
  if (model.pavements.empty()) throw InputError("--scale: expected a scene with a pavement, got none to draw");
  return {model.name + "-sheet.svg", Sheet(model, scale).text()};
}

}  // namespace shatterpave::exporting::svg
