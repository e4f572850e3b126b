// Pictures of one grey channel that sizes of stones follow.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "core/error.h"

namespace shatterpave::scene {

struct GreyMapFile {
  std::size_t columns = 0;
  std::vector<float> greys;  // 0 … 1, in rows from the top
  std::string sum;           // SHA-256 of its content
};

// As many as a picture of 4096 by 4096.
inline constexpr std::size_t most_grey_pixels = std::size_t{1} << 24;

// The picture of a portable greymap (PGM, "P2" in figures or "P5" in bytes; https://netpbm.sourceforge.net/doc/pgm.html), its
// levels over the greatest that it names, as they are: no gamma. Other pictures would need a library that takes longer to load
// than most scenes to lay. Throws InputError at `place` where there is no such file, and with its name where it is no greymap,
// has too many pixels or too few levels.
GreyMapFile grey_map_of_file(const std::filesystem::path& file, const Place& place);

}  // namespace shatterpave::scene
