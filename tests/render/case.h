// A case of the golden-image tests: a folder with expect.toml, golden.exr, and scene.toml unless another scene is named.
//
//     about = "what the picture shows, and what it guards"
//     scene = "scenes/stone_path.toml"      # from the root of the project; default: scene.toml of the folder
//     set   = ["pavement[0].joint_mm=8"]    # as the command's --set; default: none
//     draft = false                         # rendered as a draft, by Quality = 0
//     size  = [160, 120]                    # of the picture, px
//     oversampling = 1                      # rendered so many times as large, and averaged
//     grid  = [4, 4]                        # columns and rows of the regions that are compared too
//
//     [tolerance.mean]                      # also deviation, percentile, gradient: what |now - golden| may be,
//     absolute = 0.001                      # absolute + relative * |golden|; 1 is white
//     relative = 0.0
//     because  = "…"                        # the reason, required
//
//     [seeds]                               # only where numbers shall hold over seeds: then golden.exr is a row of the
//     golden = [1, 2]                       # pictures of these seeds, and mean and spread over the seeds are compared
//     tested = [3, 4]                       # with those of the pictures of these ones
//     mean_sigmas  = 4.6                    # difference of means, in its standard errors
//     spread_ratio = 5.0                    # between the two standard deviations
//     because      = "…"
//
//     [[near_miss]]                         # one or more: each is rendered too, and must be told from the golden
//     name    = "one_radial_fewer"
//     set     = ["pane[0].impact[0].radial_count=112"]               # as the command's --set
//     replace = [{find = "ior 1.52", by = "ior 1.0"}]                # in the files that POV-Ray reads
//     without_stone = 12                                             # id of a stone that is taken out
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "render/statistics.h"

namespace shatterpave::render_tests {

struct Tolerance {
  double absolute = 0.0;
  double relative = 0.0;
};

struct Replacement {
  std::string find;
  std::string by;
};

struct NearMiss {
  std::string name;
  std::vector<std::string> set;  // KEY=VALUE
  std::vector<Replacement> replace;
  std::optional<int> without_stone;
};

struct Seeds {
  std::vector<std::uint64_t> golden;
  std::vector<std::uint64_t> tested;  // as many
  double mean_sigmas = 0.0;
  double spread_ratio = 0.0;
};

struct Case {
  std::string name;
  std::filesystem::path folder;
  std::filesystem::path scene;
  std::vector<std::string> set;
  bool draft = false;
  std::size_t width = 0;
  std::size_t height = 0;
  std::size_t oversampling = 1;
  Grid grid;
  std::array<Tolerance, measure_names.size()> tolerances;
  std::optional<Seeds> seeds;
  std::vector<NearMiss> near_misses;

  std::filesystem::path golden() const { return folder / "golden.exr"; }
};

// The names of the folders of tests/render, in alphabetical order.
std::vector<std::string> case_names();

// The case of that name. Throws std::runtime_error where its expect.toml is not as described above.
Case case_named(const std::string& name);

}  // namespace shatterpave::render_tests
