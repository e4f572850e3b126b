// Raster images written to a file row by row, so that no image is in memory whole.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

namespace shatterpave::relief {

struct RasterFileShape {
  std::size_t width = 0;
  std::size_t height = 0;
  std::size_t channels = 1;  // 1: grey; 3: red, green, blue
};

enum class RasterFileFormat {
  png8,       // values 0 … 1 to 0 … 255, as they are
  png16,      // values 0 … 1 to 0 … 65535
  exr_half,   // rows, zip
  exr_float,  // rows, zip
};

// How a pixel of a smaller size of the image comes from four.
enum class Smaller {
  mean,
  first  // for numbers that stand for something
};

// A file that is open for writing. It holds pixels and what is needed to read them: no time, program, path or host. Whatever
// cannot be written throws std::runtime_error, with the file's name.
class RasterFile {
 public:
  RasterFile(const std::string& path, const RasterFileShape& shape, RasterFileFormat format);
  // OpenEXR in tiles, with all smaller sizes down to 1 × 1 in the same file (mip maps); `format` is one of the two of OpenEXR.
  // Each size is half of the last, rounded down. A third of the pixels is kept in memory.
  RasterFile(const std::string& path, const RasterFileShape& shape, RasterFileFormat format, Smaller smaller);
  ~RasterFile();
  RasterFile(const RasterFile&) = delete;
  RasterFile& operator=(const RasterFile&) = delete;

  // The next rows from the top, channels together: a whole number of them.
  void append(std::span<const float> rows);
  // All rows must have been appended.
  void close();

 private:
  class Writer;
  std::unique_ptr<Writer> writer_;
};

}  // namespace shatterpave::relief
