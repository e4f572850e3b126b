#include "scene/direction_file.h"

#include <fmt/format.h>

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
    GridDirection grid;
    vec2 low{rows[0][0], rows[0][1]};
    vec2 high = low;
    for (const auto& row : rows) {
      low = glm::min(low, vec2{row[0], row[1]});
      high = glm::max(high, vec2{row[0], row[1]});
    }
    // Of n columns and m rows, (n − 1) p = width, (m − 1) p = height and n m vectors.
    const vec2 size = high - low;
    const auto count = static_cast<double>(rows.size());
    const double sum = size.x + size.y;
    const double pitch = size.x > 0.0 && size.y > 0.0
                             ? (sum + std::sqrt(sum * sum + 4.0 * (count - 1.0) * size.x * size.y)) / (2.0 * (count - 1.0))
                             : 0.0;
    if (pitch < least_pitch_mm) refuse("", "two or more rows and columns", "vectors on a line");
    grid.origin_mm = low;
    grid.pitch_mm = pitch;
    grid.columns = static_cast<std::size_t>(std::lround(size.x / pitch)) + 1;
    const std::size_t down = rows.size() / grid.columns;
    grid.vectors.assign(rows.size(), vec2{0.0, 0.0});
    std::vector<bool> taken(rows.size(), false);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const vec2 at = (vec2{rows[i][0], rows[i][1]} - low) / pitch;
      const vec2 whole = glm::round(at);
      const auto place = static_cast<std::size_t>(whole.y) * grid.columns + static_cast<std::size_t>(whole.x);
      const bool is_on = std::abs(at.x - whole.x) <= off_grid && std::abs(at.y - whole.y) <= off_grid;
      if (!is_on || down * grid.columns != rows.size() || place >= rows.size() || taken[place]) {
        refuse("", fmt::format("each point of a square grid of {:.6g} mm once", pitch),
               fmt::format("({}, {})", rows[i][0], rows[i][1]), lines[i]);
      }
      taken[place] = true;
      grid.vectors[place] = {rows[i][2], rows[i][3]};
    }
    return grid;
  }

  std::string file_;
};

}  // namespace

DirectionFile direction_of_file(const std::filesystem::path& file, const Place& place) {
  const std::string text = input_text(file, largest_outline_bytes, place);
  require_utf8(text, file.string());
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  const DirectionReader reader(file.string());
  DirectionFile result;
  if (ending == ".json") {
    result.grid = reader.of_json(text);
  } else if (ending == ".csv") {
    result.grid = reader.of_csv(text);
  } else {
    throw InputError(place,
                     fmt::format("expected a file that ends in .json or .csv, got {}", in_quotes(file.filename().string())));
  }
  reader.check(result.grid);
  Sha256 hash;
  hash.add_text(text);
  result.sum = hash.sum();
  return result;
}

}  // namespace shatterpave::scene
