// With mip maps the smaller sizes are written last, since a file's sizes come one after the other; each is made as rows of the
// one before it go by, two by two.
#include "relief/raster_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "core/cancel.h"
#include "core/error.h"
#include "relief/openimageio.h"

namespace shatterpave::relief {

namespace {

constexpr int tile_size = 64;  // OpenImageIO's own for textures

// zlib's levels: 1 takes a third of the time of 6, the default, for files a tenth larger.
constexpr int png_level = 1;

OIIO::ImageSpec specification(const RasterFileShape& shape, RasterFileFormat format, bool tiled) {
  const bool exr = format == RasterFileFormat::exr_half || format == RasterFileFormat::exr_float;
  OIIO::TypeDesc type = OIIO::TypeDesc::UINT8;
  if (format == RasterFileFormat::png16) type = OIIO::TypeDesc::UINT16;
  if (format == RasterFileFormat::exr_half) type = OIIO::TypeDesc::HALF;
  if (format == RasterFileFormat::exr_float) type = OIIO::TypeDesc::FLOAT;
  OIIO::ImageSpec spec(static_cast<int>(shape.width), static_cast<int>(shape.height), static_cast<int>(shape.channels), type);
  if (exr) {
    spec.attribute("compression", "zip");
    spec.attribute("DateTime", "");  // or the writer would put the present time here
  } else {
    spec.attribute("png:compressionLevel", png_level);
  }
  if (tiled) {
    spec.tile_width = tile_size;
    spec.tile_height = tile_size;
    spec.attribute("textureformat", "Plain Texture");  // what makes the writer expect smaller sizes
  }
  return spec;
}

// The header of a PNG is shorter.
constexpr std::int64_t beyond_header = 1000;

bool is_last(const RasterFileShape& shape) { return shape.width == 1 && shape.height == 1; }

RasterFileShape halved(const RasterFileShape& shape) {
  return {std::max<std::size_t>(1, shape.width / 2), std::max<std::size_t>(1, shape.height / 2), shape.channels};
}

// A row of the next smaller size from two rows of this one.
void append_smaller(const float* upper, const float* lower, const RasterFileShape& shape, Smaller smaller,
                    std::vector<float>& values) {
  const std::size_t width = halved(shape).width;
  const std::size_t right = shape.width > 1 ? shape.channels : 0;
  for (std::size_t x = 0; x < width; ++x) {
    for (std::size_t c = 0; c < shape.channels; ++c) {
      const std::size_t at = 2 * x * shape.channels + c;
      values.push_back(smaller == Smaller::first ? upper[at]
                                                 : 0.25F * (upper[at] + upper[at + right] + lower[at] + lower[at + right]));
    }
  }
}

}  // namespace

class RasterFile::Writer {
 public:
  Writer(const std::string& path, const RasterFileShape& shape, RasterFileFormat format, bool tiled, Smaller smaller)
      : path_(path), format_(format), tiled_(tiled), smaller_(smaller), level_(shape), file_(std::fopen(path.c_str(), "wb")) {
    ENSURE(shape.width > 0 && shape.height > 0 && shape.channels > 0);
    if (!file_) fail_by_errno();
    proxy_ = std::make_unique<OIIO::Filesystem::IOFile>(file_.get(), OIIO::Filesystem::IOProxy::Write);
    output_ = OIIO::ImageOutput::create(path, proxy_.get());
    if (!output_) fail(OIIO::geterror());
    if (!output_->open(path, specification(shape, format, tiled))) fail(output_->geterror());
  }

  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  Writer(Writer&&) = delete;
  Writer& operator=(Writer&&) = delete;

  // Where the file is left unfinished, it gets some black rows: libpng would complain on stderr of one without any data.
  ~Writer() {
    if (!output_ || tiled_) return;
    try {
      const std::vector<float> black(level_.width * level_.channels, 0.0F);
      while (done_ < level_.height && proxy_->tell() < beyond_header &&
             output_->write_scanline(static_cast<int>(done_), 0, OIIO::TypeDesc::FLOAT, black.data())) {
        ++done_;
      }
    } catch (const std::exception&) {
      // What made it be left is on its way already.
    }
  }

  void append(std::span<const float> rows) {
    const std::size_t length = level_.width * level_.channels;
    ENSURE(rows.size() % length == 0 && done_ + held_.size() / length + rows.size() / length <= level_.height);
    if (!tiled_) {
      const std::size_t last = done_ + rows.size() / length;
      if (!output_->write_scanlines(static_cast<int>(done_), static_cast<int>(last), 0, OIIO::TypeDesc::FLOAT, rows.data())) {
        fail(output_->geterror());
      }
      done_ = last;
      return;
    }
    held_.insert(held_.end(), rows.begin(), rows.end());
    write_held();
  }

  void close() {
    ENSURE(done_ == level_.height);
    while (tiled_ && !is_last(level_)) begin_smaller();
    if (!output_->close()) fail(output_->geterror());
    output_.reset();  // with tiles, the last of the file is only written here
    // Writers do not tell all that a disk refuses, and nothing of what is refused as they end.
    if (std::ferror(file_.get()) != 0 || std::fflush(file_.get()) != 0) fail_by_errno();
    if (std::fclose(file_.release()) != 0) fail_by_errno();
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const { throw std::runtime_error("cannot write " + path_ + ": " + reason); }

  [[noreturn]] void fail_by_errno() const { fail(std::generic_category().message(errno != 0 ? errno : EIO)); }

  // Writes the rows of tiles that are whole, and the last one.
  void write_held() {
    const std::size_t length = level_.width * level_.channels;
    while (!held_.empty()) {
      stop_if_cancelled();
      const std::size_t rows = std::min<std::size_t>(tile_size, level_.height - done_);
      if (held_.size() < rows * length) return;
      if (!output_->write_tiles(0, static_cast<int>(level_.width), static_cast<int>(done_), static_cast<int>(done_ + rows), 0,
                                1, OIIO::TypeDesc::FLOAT, held_.data())) {
        fail(output_->geterror());
      }
      if (!is_last(level_)) append_smaller_rows(rows);
      held_.erase(held_.begin(), held_.begin() + static_cast<std::ptrdiff_t>(rows * length));
      done_ += rows;
    }
  }

  // A row of tiles begins with an even one, so that pairs of rows are never torn apart. A last odd row is left out.
  void append_smaller_rows(std::size_t rows) {
    const std::size_t length = level_.width * level_.channels;
    for (std::size_t row = 0; row < rows; row += 2) {
      if ((done_ + row) / 2 >= halved(level_).height) return;
      const float* upper = &held_[row * length];
      append_smaller(upper, row + 1 < rows ? upper + length : upper, level_, smaller_, next_);
    }
  }

  void begin_smaller() {
    level_ = halved(level_);
    if (!output_->open(path_, specification(level_, format_, true), OIIO::ImageOutput::AppendMIPLevel)) {
      fail(output_->geterror());
    }
    done_ = 0;
    held_.clear();
    std::swap(held_, next_);
    write_held();
    ENSURE(done_ == level_.height);
  }

  std::string path_;
  RasterFileFormat format_;
  bool tiled_;
  Smaller smaller_;
  RasterFileShape level_;    // that is being written
  std::size_t done_ = 0;     // rows of it
  std::vector<float> held_;  // rows that are not written yet
  std::vector<float> next_;  // the next smaller size, as far as it is made
  struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, CloseFile> file_;
  std::unique_ptr<OIIO::Filesystem::IOProxy> proxy_;
  std::unique_ptr<OIIO::ImageOutput> output_;
};

RasterFile::RasterFile(const std::string& path, const RasterFileShape& shape, RasterFileFormat format)
    : writer_(std::make_unique<Writer>(path, shape, format, false, Smaller::mean)) {}

RasterFile::RasterFile(const std::string& path, const RasterFileShape& shape, RasterFileFormat format, Smaller smaller)
    : writer_(std::make_unique<Writer>(path, shape, format, true, smaller)) {
  ENSURE(format == RasterFileFormat::exr_half || format == RasterFileFormat::exr_float);
}

RasterFile::~RasterFile() = default;

void RasterFile::append(std::span<const float> rows) { writer_->append(rows); }
void RasterFile::close() { writer_->close(); }

}  // namespace shatterpave::relief
