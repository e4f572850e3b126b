#include "scene/direction_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "core/sha256.h"
#include "geometry/lattice.h"
#include "scene/field_picture.h"
#include "scene/input_file.h"

namespace shatterpave::scene {

namespace {

using nlohmann::json;
using paving::GridDirection;

// As many as nodes of a field that is solved (paving/field/direction_field.cpp).
constexpr std::size_t most_vectors = 4'000'000;
constexpr double least_pitch_mm = 0.1;
// Of a pitch: so far off the grid may a point lie, which decimals round.
constexpr double off_grid = 0.01;
// Of a pixel's side: so much may it differ from the other, where the corners of a picture are rounded.
constexpr double off_square = 0.01;
constexpr double largest = 1e30;  // its square is finite

class DirectionReader {
 public:
  explicit DirectionReader(std::string file) : file_(std::move(file)) {}

  [[noreturn]] void refuse(const std::string& key, const std::string& expected, const std::string& got, int line = 0) const {
    throw InputError(Place{file_, line, line > 0 ? 1 : 0, key}, fmt::format("expected {}, got {}", expected, got));
  }

  double number(const json& value, const std::string& key, double low, double high) const {
    const double found = value.is_number() ? value.get<double>() : std::nan("");
    if (!(found >= low && found <= high)) {
      refuse(key, fmt::format("a number from {} to {}", low, high), in_quotes(value.dump()));
    }
    return found;
  }

  vec2 pair(const json& value, const std::string& key, double most) const {
    if (!value.is_array() || value.size() != 2) refuse(key, "two numbers [x, y]", in_quotes(value.dump()));
    return {number(value[0], key, -most, most), number(value[1], key, -most, most)};
  }

  void check(const GridDirection& grid) const {
    const auto says = [](vec2 v) { return v != vec2{0.0, 0.0}; };
    if (std::ranges::none_of(grid.vectors, says)) refuse("vectors", "a vector other than [0, 0]", "none");
  }

  GridDirection of_json(const std::string& text) const {
    json document;
    try {
      document = json::parse(text);
    } catch (const json::parse_error& error) {
      const TextPosition at = text_position(text, std::min(error.byte > 0 ? error.byte - 1 : 0, text.size()));
      throw InputError(Place{file_, at.line, at.column, ""}, "expected JSON, got an error");
    } catch (const json::exception&) {
      refuse("", "JSON with numbers in range", "others");
    }
    if (!document.is_object()) refuse("", "an object", in_quotes(document.dump().substr(0, 40)));
    constexpr std::array<std::string_view, 4> keys = {"origin_mm", "pitch_mm", "columns", "vectors"};
    for (const auto& [key, value] : document.items()) {
      if (std::ranges::find(keys, key) == keys.end()) {
        refuse("", fmt::format("the keys {} alone", fmt::join(keys, ", ")), in_quotes(key));
      }
    }
    const auto member = [&](const char* key) -> const json& {
      if (!document.contains(key)) refuse(key, "a value", "nothing");
      return document[key];
    };
    GridDirection grid;
    grid.origin_mm = pair(member("origin_mm"), "origin_mm", geometry::largest_coordinate_mm);
    grid.pitch_mm = number(member("pitch_mm"), "pitch_mm", least_pitch_mm, geometry::largest_coordinate_mm);
    const json& columns = member("columns");
    if (!columns.is_number_integer()) refuse("columns", "a whole number, 2 or more", in_quotes(columns.dump()));
    grid.columns = static_cast<std::size_t>(number(columns, "columns", 2, static_cast<double>(most_vectors)));
    const json& vectors = member("vectors");
    if (!vectors.is_array() || vectors.size() > most_vectors) {
      refuse("vectors", fmt::format("a list of at most {} vectors", most_vectors),
             vectors.is_array() ? "more" : "another value");
    }
    if (vectors.size() % grid.columns != 0 || vectors.size() < 2 * grid.columns) {
      refuse("vectors", fmt::format("two or more whole rows of {}", grid.columns), fmt::format("{} vectors", vectors.size()));
    }
    for (std::size_t i = 0; i < vectors.size(); ++i) {
      grid.vectors.push_back(pair(vectors[i], fmt::format("vectors[{}]", i), largest));
    }
    return grid;
  }

  GridDirection of_csv(std::string_view text) const {
    // Spreadsheets begin what they save as UTF-8 by a byte order mark.
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    if (text.starts_with(mark)) text.remove_prefix(mark.size());
    std::vector<std::array<double, 4>> rows;
    std::vector<int> lines;
    int line = 0;
    while (!text.empty()) {
      const std::size_t end = text.find('\n');
      std::string_view row = text.substr(0, end);
      text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
      ++line;
      while (!row.empty() && (row.back() == '\r' || row.back() == ' ')) row.remove_suffix(1);
      if (line == 1) {
        if (row != "x_mm,y_mm,u,v") refuse("", "the line x_mm,y_mm,u,v", in_quotes(row), line);
      } else if (!row.empty()) {
        if (rows.size() == most_vectors) refuse("", fmt::format("at most {} vectors", most_vectors), "more", line);
        rows.push_back(numbers(row, line));
        lines.push_back(line);
      }
    }
    return on_grid(rows, lines);
  }

  GridDirection of_exr(const std::string& content, const geometry::Box& area) const {
    constexpr std::array<ChannelPair, 4> pairs = {{{"u", "v"}, {"x", "y"}, {"X", "Y"}, {"R", "G"}}};
    const PairPicture picture = pair_of_exr(content, file_, pairs);
    if (picture.columns < 2 || picture.rows < 2) {
      refuse("", "two or more rows and columns", fmt::format("{} x {} pixels", picture.columns, picture.rows));
    }
    const vec2 pitch = (area.high - area.low) / vec2{static_cast<double>(picture.columns), static_cast<double>(picture.rows)};
    if (std::abs(pitch.x - pitch.y) > off_square * pitch.x) {
      refuse("", "pixels that are square where the picture lies (direction.grid_area_mm)",
             fmt::format("{:.6g} x {:.6g} mm", pitch.x, pitch.y));
    }
    if (pitch.x < least_pitch_mm) {
      refuse("", fmt::format("pixels of {} mm or more", least_pitch_mm), fmt::format("{:.6g} mm", pitch.x));
    }
    GridDirection grid;
    grid.pitch_mm = 0.5 * (pitch.x + pitch.y);
    grid.columns = picture.columns;
    const vec2 cells{static_cast<double>(picture.columns - 1), static_cast<double>(picture.rows - 1)};
    grid.origin_mm = 0.5 * (area.low + area.high) - 0.5 * grid.pitch_mm * cells;
    grid.vectors.reserve(picture.first.size());
    for (std::size_t row = picture.rows; row-- > 0;) {
      for (std::size_t column = 0; column < picture.columns; ++column) {
        const vec2 v{picture.first[row * picture.columns + column], picture.second[row * picture.columns + column]};
        if (!(std::abs(v.x) <= largest && std::abs(v.y) <= largest)) {
          refuse("", "finite numbers in range", fmt::format("({}, {}) at pixel ({}, {})", v.x, v.y, column, row));
        }
        grid.vectors.push_back(v);
      }
    }
    return grid;
  }

 private:
  std::array<double, 4> numbers(std::string_view row, int line) const {
    std::array<double, 4> found{};
    const char* at = row.data();
    const char* const end = row.data() + row.size();
    for (std::size_t k = 0; k < found.size(); ++k) {
      while (at != end && (*at == ' ' || *at == '\t')) ++at;
      const double most = k < 2 ? geometry::largest_coordinate_mm : largest;
      const auto [next, error] = std::from_chars(at, end, found.at(k));
      const bool ends = next == end ? k == 3 : *next == ',' && k < 3;
      if (error != std::errc() || !ends || !(std::abs(found.at(k)) <= most)) {
        refuse("", "four numbers x_mm,y_mm,u,v in range", in_quotes(row), line);
      }
      at = next == end ? end : next + 1;
    }
    return found;
  }

  GridDirection on_grid(const std::vector<std::array<double, 4>>& rows, const std::vector<int>& lines) const {
    if (rows.size() < 4) refuse("", "four vectors or more", fmt::format("{}", rows.size()));
    const Axis across = axis_of(rows, 0);
    const Axis up = axis_of(rows, 1);
    if (across.places < 2 || up.places < 2) refuse("", "two or more rows and columns", "vectors on a line");
    if (std::abs(across.pitch_mm - up.pitch_mm) > off_grid * across.pitch_mm) {
      refuse("", "a square grid",
             fmt::format("places {:.6g} mm apart along x and {:.6g} mm along y", across.pitch_mm, up.pitch_mm));
    }
    GridDirection grid;
    grid.origin_mm = {across.low_mm, up.low_mm};
    grid.pitch_mm = across.pitch_mm;
    if (grid.pitch_mm < least_pitch_mm) {
      refuse("", fmt::format("places {} mm apart or more", least_pitch_mm), fmt::format("{:.6g} mm", grid.pitch_mm));
    }
    if (static_cast<double>(across.places) * static_cast<double>(up.places) > static_cast<double>(most_vectors)) {
      refuse("", fmt::format("a grid of at most {} places", most_vectors), fmt::format("{} x {}", across.places, up.places));
    }
    grid.columns = across.places;
    put_vectors(rows, lines, grid, up.places);
    return grid;
  }

  // The places of the grid along x or y.
  struct Axis {
    double low_mm = 0.0;
    double pitch_mm = 0.0;
    std::size_t places = 0;
  };

  // They are as far apart as most neighbours among the coordinates there are: some places may have no vector.
  static Axis axis_of(const std::vector<std::array<double, 4>>& rows, std::size_t axis) {
    std::vector<double> coordinates;
    coordinates.reserve(rows.size());
    for (const auto& row : rows) coordinates.push_back(row.at(axis));
    std::ranges::sort(coordinates);
    const double size = coordinates.back() - coordinates.front();
    // Nearer ones are one place, which decimals round.
    const double same = std::max(off_grid * least_pitch_mm, 1e-9 * size);
    std::vector<double> steps;
    for (std::size_t i = 1; i < coordinates.size(); ++i) {
      const double step = coordinates[i] - coordinates[i - 1];
      if (step > same) steps.push_back(step);
    }
    if (steps.empty()) return {coordinates.front(), 0.0, 1};
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::ranges::nth_element(steps, middle);
    const double count = std::max(1.0, std::round(size / *middle));
    const double most = static_cast<double>(most_vectors);
    return {coordinates.front(), size / count, static_cast<std::size_t>(std::min(count, most)) + 1};
  }

  void put_vectors(const std::vector<std::array<double, 4>>& rows, const std::vector<int>& lines, GridDirection& grid,
                   std::size_t down) const {
    grid.vectors.assign(grid.columns * down, vec2{0.0, 0.0});
    std::vector<bool> taken(grid.vectors.size(), false);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const auto got = [&] { return fmt::format("({}, {})", rows[i][0], rows[i][1]); };
      const vec2 at = (vec2{rows[i][0], rows[i][1]} - grid.origin_mm) / grid.pitch_mm;
      const vec2 whole = glm::round(at);
      if (std::abs(at.x - whole.x) > off_grid || std::abs(at.y - whole.y) > off_grid) {
        refuse("", fmt::format("a place of a square grid of {:.6g} mm", grid.pitch_mm), got(), lines[i]);
      }
      const auto place = static_cast<std::size_t>(whole.y) * grid.columns + static_cast<std::size_t>(whole.x);
      if (place >= taken.size()) refuse("", "a place of the grid", got(), lines[i]);
      if (taken[place]) refuse("", "each place of the grid once", got() + " again", lines[i]);
      taken[place] = true;
      grid.vectors[place] = {rows[i][2], rows[i][3]};
    }
    const auto missing = std::ranges::find(taken, false);
    if (missing == taken.end()) return;
    const auto place = static_cast<std::size_t>(missing - taken.begin());
    const std::size_t row = place / grid.columns;
    const std::size_t column = place % grid.columns;
    const vec2 at = grid.origin_mm + grid.pitch_mm * vec2{static_cast<double>(column), static_cast<double>(row)};
    refuse("", fmt::format("a vector at each of {} x {} places, {:.6g} mm apart", grid.columns, down, grid.pitch_mm),
           fmt::format("none at ({:.6g}, {:.6g})", at.x, at.y));
  }

  std::string file_;
};

std::string small_ending(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return ending;
}

}  // namespace

bool covers_area(const std::filesystem::path& file) { return small_ending(file) == ".exr"; }

DirectionFile direction_of_file(const std::filesystem::path& file, const Place& place, const geometry::Box& area) {
  const std::string text = input_text(file, covers_area(file) ? largest_field_bytes : largest_outline_bytes, place);
  const std::string ending = small_ending(file);
  const DirectionReader reader(file.string());
  DirectionFile result;
  if (covers_area(file)) {
    result.grid = reader.of_exr(text, area);
  } else {
    require_utf8(text, file.string());
    if (ending == ".json") {
      result.grid = reader.of_json(text);
    } else if (ending == ".csv") {
      result.grid = reader.of_csv(text);
    } else {
      throw InputError(
          place, fmt::format("expected a file that ends in .json, .csv or .exr, got {}", in_quotes(file.filename().string())));
    }
  }
  reader.check(result.grid);
  Sha256 hash;
  hash.add_text(text);
  result.sum = hash.sum();
  return result;
}

}  // namespace shatterpave::scene
