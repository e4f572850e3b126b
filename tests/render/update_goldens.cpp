// Writes golden.exr of the cases named, or of all; run by update_goldens.sh. Shows which statistics change.

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <fstream>

#include "render/case.h"
#include "render/comparison.h"
#include "render/picture_row.h"
#include "render/povray.h"
#include "render/rendering.h"

namespace shatterpave::render_tests {
namespace {

// A row of pictures is compared seed by seed here: only the program that made them can have changed them.
void show_changes(const Case& of, const relief::Raster& golden, const relief::Raster& now) {
  if (golden.width != now.width || golden.height != now.height) {
    fmt::print("{}: another size\n", of.name);
    return;
  }
  if (golden == now) {
    fmt::print("{}: no pixel changes\n", of.name);
    return;
  }
  const Comparison comparison = compared(of, golden, now);
  fmt::print("{}:\n", of.name);
  for (const Row& row : comparison.rows) {
    if (row.now != row.golden && row.what.starts_with("whole")) {
      fmt::print("  {:<36} {:>10.5f} -> {:>10.5f}\n", row.what, row.golden, row.now);
    }
  }
}

void update(const std::string& name) {
  const Case of = case_named(name);
  const std::filesystem::path folder = output_folder() / name;
  relief::Raster now;
  if (of.seeds) {
    std::vector<relief::Raster> pictures;
    for (const std::uint64_t seed : of.seeds->golden) {
      pictures.push_back(picture(of, nullptr, seed, folder / fmt::format("seed_{}", seed)));
    }
    now = row_of(pictures);
  } else {
    now = picture(of, nullptr, std::nullopt, folder);
  }
  if (std::filesystem::exists(of.golden())) {
    const relief::Raster golden = relief::read_raster(of.golden().string());
    show_changes(of, golden, now);
    if (golden == now) return;
  } else {
    fmt::print("{}: new\n", name);
  }
  std::ofstream file(of.golden(), std::ios::binary);
  file << relief::encoded(now, relief::RasterFormat::exr_half);
  file.close();
  if (!file) throw std::runtime_error("cannot write " + of.golden().string());
}

}  // namespace
}  // namespace shatterpave::render_tests

int main(int count, char** arguments) {
  try {
    std::vector<std::string> names(arguments + 1, arguments + count);
    if (names.empty()) names = shatterpave::render_tests::case_names();
    for (const std::string& name : names) shatterpave::render_tests::update(name);
  } catch (const std::exception& error) {
    fmt::print(stderr, "update_goldens: {}\n", error.what());
    return 1;
  }
  return 0;
}
