#include "export/csv/tables_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "core/parallel.h"
#include "export/names.h"
#include "geometry/polygon.h"
#include "paving/quantities/quantities.h"

namespace shatterpave::exporting::csv {

namespace {

using Buffer = fmt::memory_buffer;
using paving::PartQuantities;
using paving::Quantities;
using paving::StonePart;

constexpr double mm2_per_m2 = 1e6;
constexpr double mm_per_m = 1000.0;

template <typename... Arguments>
void put(Buffer& out, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  fmt::format_to(std::back_inserter(out), format, std::forward<Arguments>(arguments)...);
}

// A number with that many digits after the point. What rounds to 0 has no sign.
std::string rounded(double value, int digits) {
  std::string text = fmt::format("{:.{}f}", value, digits);
  if (text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
  return text;
}

void put_stones(Buffer& out, const PavedArea& paved, const Quantities& quantities) {
  for (std::size_t i = 0; i < paved.layout.stones.size(); ++i) {
    const paving::Stone& stone = paved.layout.stones[i];
    const vec2 size = paving::stone_size_mm(stone);
    const vec2 middle = geometry::centroid(stone.outline_mm);
    put(out, "{},{},{},{},{},{},{},{},{},{},{}\n", paved.pavement.name, stone.id, name_of(stone.part), name_of(stone.kind),
        rounded(size.x, 3), rounded(size.y, 3), rounded(geometry::area(stone.outline_mm), 3), rounded(middle.x, 3),
        rounded(middle.y, 3), rounded(stone.angle.degrees(), 6), quantities.stock_of_stone[i]);
  }
}

// What of a row there is.
struct Row {
  std::string count{};
  std::string area_m2{};
  std::string length_m{};
};

class QuantityRows {
 public:
  explicit QuantityRows(Buffer& out) : out_(out) {}

  void put_pavement(const PavedArea& paved, const Quantities& quantities) {
    pavement_ = paved.pavement.name;
    put_row("paved", {.area_m2 = square_metres(quantities.paved_mm2)});
    for (const PartQuantities& part : quantities.parts) put_part(part);
    put_row("joints", {.area_m2 = square_metres(quantities.joint_mm2), .length_m = rounded(quantities.joint_mm / mm_per_m, 3)});
    const bool is_kerb = std::ranges::any_of(quantities.parts, [](const auto& part) { return part.part == StonePart::kerb; });
    if (is_kerb) put_kerb(paved, quantities);
  }

 private:
  static std::string square_metres(double mm2) { return rounded(mm2 / mm2_per_m2, 6); }

  void put_row(std::string_view item, const Row& row) {
    put(out_, "{},{},{},{},{}\n", pavement_, item, row.count, row.area_m2, row.length_m);
  }

  void put_part(const PartQuantities& part) {
    const std::string_view name = name_of(part.part);
    const auto tally = [&](std::string_view kind, const paving::Tally& stones) {
      put_row(fmt::format("{}_{}", name, kind),
              {.count = fmt::format("{}", stones.count), .area_m2 = square_metres(stones.area_mm2)});
    };
    tally("whole", part.whole);
    tally("cut", part.cut);
    const auto order = [&](std::string_view how, std::size_t count) {
      put_row(fmt::format("{}_{}", name, how),
              {.count = fmt::format("{}", count), .area_m2 = square_metres(static_cast<double>(count) * part.stock_area_mm2)});
    };
    order("to_order", part.order);
    order("to_order_reusing_offcuts", part.order_reusing);
  }

  // Along its middle. All joints of the strip run across it, or half a joint beside it.
  void put_kerb(const PavedArea& paved, const Quantities& quantities) {
    std::size_t count = 0;
    for (const PartQuantities& part : quantities.parts) count += part.whole.count + part.cut.count;
    const double width_mm = paved.pavement.stone_mm.y + paved.pavement.joint_mm;
    put_row("kerb", {.count = fmt::format("{}", count),
                     .area_m2 = square_metres(quantities.paved_mm2),
                     .length_m = rounded(quantities.paved_mm2 / width_mm / mm_per_m, 3)});
  }

  Buffer& out_;
  std::string pavement_;
};

void put_cracks(Buffer& out, const BrokenPane& broken, const glass::CrackNetwork& network) {
  for (const glass::Crack& crack : network.cracks) {
    for (std::size_t i = 0; i < crack.points_mm.size(); ++i) {
      const vec2 p = crack.points_mm[i];
      put(out, "{},{},{},{},{},{},{}\n", broken.pane.name, crack.id, name_of(crack.kind), crack.impact, i, rounded(p.x, 3),
          rounded(p.y, 3));
    }
  }
}

}  // namespace

std::vector<OutputFile> csv_files(const Model& model) {
  std::vector<Quantities> quantities(model.pavements.size());
  parallel_for(model.pavements.size(), [&](std::size_t i) {
    quantities[i] = paving::quantities(model.pavements[i].pavement, model.pavements[i].layout);
  });
  Buffer stones;
  Buffer items;
  Buffer cracks;
  put(stones, "pavement,id,part,kind,length_mm,width_mm,area_mm2,x_mm,y_mm,angle_deg,stock\n");
  put(items, "pavement,item,count,area_m2,length_m\n");
  put(cracks, "pane,crack,kind,impact,index,x_mm,y_mm\n");
  QuantityRows rows(items);
  for (std::size_t i = 0; i < model.pavements.size(); ++i) {
    put_stones(stones, model.pavements[i], quantities[i]);
    rows.put_pavement(model.pavements[i], quantities[i]);
  }
  for (const BrokenPane& pane : model.panes) {
    put_cracks(cracks, pane, pane.network);
    put_cracks(cracks, pane, pane.far_network);
  }
  return {{model.name + "-stones.csv", fmt::to_string(stones)},
          {model.name + "-quantities.csv", fmt::to_string(items)},
          {model.name + "-cracks.csv", fmt::to_string(cracks)}};
}

void append(const Model& model, Outputs& outputs) { std::ranges::move(csv_files(model), std::back_inserter(outputs.files)); }

}  // namespace shatterpave::exporting::csv
