// How a picture is asked for.
#pragma once

#include <string_view>

namespace shatterpave::pipeline {

enum class Quality { draft, final };
constexpr std::string_view name_of(Quality quality) { return quality == Quality::draft ? "draft" : "final"; }

struct RenderOptions {
  Quality quality = Quality::draft;
  int width = 0;    // px, 1 … 16384; 0: 640 for a draft, 1200 for a final picture
  int height = 0;   // px; 0: 480 or 900
  int threads = 0;  // 0: all processors

  bool operator==(const RenderOptions&) const = default;
};

struct PictureSize {
  int width = 0;  // px
  int height = 0;
};
PictureSize size_of(const RenderOptions& options);

}  // namespace shatterpave::pipeline
