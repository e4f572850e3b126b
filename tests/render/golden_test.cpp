// The golden-image tests: each case renders as its golden does, and each of its near misses does not.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string_view>

#include "render/case.h"
#include "render/comparison.h"
#include "render/picture_row.h"
#include "render/povray.h"
#include "render/rendering.h"

namespace shatterpave::render_tests {
namespace {

struct Outcome {
  Comparison comparison;
  relief::Raster golden;
  relief::Raster now;
};

Outcome outcome(const Case& of, const NearMiss* miss, const std::filesystem::path& folder) {
  Outcome result;
  result.golden = relief::read_raster(of.golden().string());
  if (!of.seeds) {
    result.now = picture(of, miss, std::nullopt, folder);
    result.comparison = compared(of, result.golden, result.now);
    return result;
  }
  std::vector<relief::Raster> pictures;
  for (const std::uint64_t seed : of.seeds->tested) {
    pictures.push_back(picture(of, miss, seed, folder / ("seed_" + std::to_string(seed))));
  }
  result.now = row_of(pictures);
  result.comparison = compared_over_seeds(of, parts_of(result.golden, of.width), pictures);
  return result;
}

// Leaves what a person needs to judge: both pictures, their difference, and the table.
void leave(const Outcome& outcome, const std::filesystem::path& folder) {
  const auto write = [&](const std::string& name, const std::string& bytes) {
    std::ofstream(folder / name, std::ios::binary) << bytes;
  };
  const auto shown = [](const relief::Raster& raster) {
    return relief::encoded(relief::display(raster), relief::RasterFormat::png8);
  };
  write("now.exr", relief::encoded(outcome.now, relief::RasterFormat::exr_half));
  write("now.png", shown(outcome.now));
  write("golden.png", shown(outcome.golden));
  write("difference.png", shown(difference(outcome.golden, outcome.now)));
  write("statistics.txt", outcome.comparison.table());
}

std::string first_lines(const std::string& text, int count) {
  std::size_t end = 0;
  for (int line = 0; line < count && end != std::string::npos; ++line) end = text.find('\n', end + 1);
  return text.substr(0, end);
}

class RenderGolden : public testing::TestWithParam<std::string> {};

TEST_P(RenderGolden, LooksAsItsGolden) {
  const Case of = case_named(GetParam());
  ASSERT_TRUE(std::filesystem::exists(of.golden()))
      << of.golden() << " is missing. Look at the scene, then write it: tests/render/update_goldens.sh " << of.name;
  const std::filesystem::path folder = output_folder() / of.name;
  const Outcome result = outcome(of, nullptr, folder);
  leave(result, folder);
  EXPECT_TRUE(result.comparison.agrees()) << first_lines(result.comparison.table(), 20)
                                          << "\nSee now.png, golden.png, difference.png and statistics.txt in " << folder
                                          << "\nWhere the new picture is the right one: tests/render/update_goldens.sh "
                                          << of.name;
}

struct MissOfCase {
  std::string of;
  std::string miss;

  // NOLINTNEXTLINE(readability-identifier-naming): the name that GoogleTest looks for.
  friend void PrintTo(const MissOfCase& value, std::ostream* stream) { *stream << value.of << ": " << value.miss; }
};

class RenderNearMiss : public testing::TestWithParam<MissOfCase> {};

TEST_P(RenderNearMiss, IsToldFromTheGolden) {
  const Case of = case_named(GetParam().of);
  const auto miss = std::ranges::find(of.near_misses, GetParam().miss, &NearMiss::name);
  ASSERT_NE(miss, of.near_misses.end());
  ASSERT_TRUE(std::filesystem::exists(of.golden())) << of.golden() << " is missing";
  const std::filesystem::path folder = output_folder() / (of.name + "-" + miss->name);
  const Outcome result = outcome(of, &*miss, folder);
  leave(result, folder);
  EXPECT_FALSE(result.comparison.agrees()) << "the tolerances of " << of.name << " let " << miss->name << " pass; see "
                                           << folder;
}

// The first near miss of each case, or all where the environment asks for them (.ci/long/goldens). Cases whose expect.toml
// cannot be read have none here; their golden test fails with the reason.
std::vector<MissOfCase> chosen_misses() {
  const char* wanted = std::getenv("SHATTERPAVE_NEAR_MISSES");
  const bool all = wanted != nullptr && std::string_view(wanted) == "all";
  std::vector<MissOfCase> chosen;
  for (const std::string& name : case_names()) {
    try {
      for (const NearMiss& miss : case_named(name).near_misses) {
        chosen.push_back({name, miss.name});
        if (!all) break;
      }
    } catch (const std::exception&) {
      continue;
    }
  }
  return chosen;
}

INSTANTIATE_TEST_SUITE_P(Cases, RenderGolden, testing::ValuesIn(case_names()), [](const auto& test) { return test.param; });
INSTANTIATE_TEST_SUITE_P(Cases, RenderNearMiss, testing::ValuesIn(chosen_misses()),
                         [](const auto& test) { return test.param.of + "_" + test.param.miss; });

}  // namespace
}  // namespace shatterpave::render_tests
