#include "scene/grey_map_file.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "core/sha256.h"
#include "scene/input_file.h"

namespace shatterpave::scene {

namespace {

[[noreturn]] void refuse_map(const std::string& file, const std::string& expected, const std::string& got) {
  throw InputError(Place{file, 0, 0, ""}, fmt::format("expected {}, got {}", expected, got));
}

// libpng tells errors by a jump to where it was called, so what is between has nothing to destroy.
struct GreyPng {
  std::string_view left;  // of the file
  std::array<char, 80> error{};
  png_structp reader = nullptr;
  png_infop info = nullptr;
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;

  explicit GreyPng(std::string_view content) : left(content) {
    reader = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, &fail, &ignore_warning);
    info = png_create_info_struct(reader);
  }
  ~GreyPng() { png_destroy_read_struct(&reader, &info, nullptr); }
  GreyPng(const GreyPng&) = delete;
  GreyPng& operator=(const GreyPng&) = delete;

  static void fail(png_structp png, png_const_charp message) {
    auto& self = *static_cast<GreyPng*>(png_get_error_ptr(png));
    std::strncpy(self.error.data(), message, self.error.size() - 1);
    std::longjmp(*png_set_longjmp_fn(png, std::longjmp, sizeof(std::jmp_buf)), 1);
  }
  static void ignore_warning(png_structp /*png*/, png_const_charp /*message*/) {}
  static void take(png_structp png, png_bytep out, std::size_t count) {
    std::string_view& left = static_cast<GreyPng*>(png_get_io_ptr(png))->left;
    if (count > left.size()) png_error(png, "the file ends too early");
    std::memcpy(out, left.data(), count);
    left.remove_prefix(count);
  }

  // Whether it could: up to its pixels.
  bool read_head() {
    if (setjmp(png_jmpbuf(reader)) != 0) return false;
    png_set_read_fn(reader, this, &take);
    png_set_user_limits(reader, static_cast<png_uint_32>(most_grey_pixels), static_cast<png_uint_32>(most_grey_pixels));
    png_read_info(reader, info);
    columns = png_get_image_width(reader, info);
    rows = png_get_image_height(reader, info);
    return true;
  }

  // Two bytes for each pixel, the high one first, by a pointer to each row.
  bool read_pixels(png_bytepp row_pointers) {
    if (setjmp(png_jmpbuf(reader)) != 0) return false;
    png_set_expand_16(reader);
    png_set_strip_alpha(reader);
    if ((png_get_color_type(reader, info) & PNG_COLOR_MASK_COLOR) != 0) {
      constexpr int as_libpng_does = -1;
      png_set_rgb_to_gray_fixed(reader, PNG_ERROR_ACTION_NONE, as_libpng_does, as_libpng_does);
    }
    png_read_update_info(reader, info);
    if (png_get_rowbytes(reader, info) != std::size_t{2} * columns) png_error(reader, "no picture in grey");
    png_read_image(reader, row_pointers);
    png_read_end(reader, nullptr);
    return true;
  }
};

}  // namespace

GreyMapFile grey_map_of_file(const std::filesystem::path& file, const Place& place) {
  const std::string text = input_text(file, largest_outline_bytes, place);
  GreyPng png(text);
  const auto refuse_png = [&] { refuse_map(file.string(), "a PNG picture", in_quotes(png.error.data())); };
  if (!png.read_head()) refuse_png();
  if (png.columns > most_grey_pixels / png.rows) {
    refuse_map(file.string(), fmt::format("at most {} pixels", most_grey_pixels),
               fmt::format("{} x {}", png.columns, png.rows));
  }
  const std::size_t row_bytes = std::size_t{2} * png.columns;
  std::vector<png_byte> levels(row_bytes * png.rows);
  std::vector<png_bytep> row_pointers(png.rows);
  for (std::size_t row = 0; row < png.rows; ++row) row_pointers[row] = levels.data() + row * row_bytes;
  if (!png.read_pixels(row_pointers.data())) refuse_png();
  GreyMapFile result;
  result.columns = png.columns;
  result.greys.reserve(levels.size() / 2);
  for (std::size_t i = 0; i < levels.size(); i += 2) {
    result.greys.push_back(static_cast<float>(256 * levels[i] + levels[i + 1]) / 65535.0F);
  }
  Sha256 hash;
  hash.add_text(text);
  result.sum = hash.sum();
  return result;
}

}  // namespace shatterpave::scene
