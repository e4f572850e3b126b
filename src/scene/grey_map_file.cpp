#include "scene/grey_map_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "core/sha256.h"
#include "scene/input_file.h"

namespace shatterpave::scene {

namespace {

constexpr unsigned most_level = 65535;

class GreymapReader {
 public:
  GreymapReader(std::string file, std::string_view text) : file_(std::move(file)), text_(text) {}

  void read(GreyMapFile& map) {
    const std::string_view kind = text_.substr(0, 2);
    if (kind != "P2" && kind != "P5") refuse("a portable greymap that begins with P2 or P5", in_quotes(kind));
    at_ = 2;
    const std::size_t columns = number("its width, 1 or more", most_grey_pixels);
    const std::size_t rows = number("its height, 1 or more", most_grey_pixels);
    if (columns == 0 || rows == 0 || columns > most_grey_pixels / rows) {
      refuse(fmt::format("1 to {} pixels", most_grey_pixels), fmt::format("{} x {}", columns, rows));
    }
    greatest_ = static_cast<unsigned>(number("its greatest level, 1 to 65535", most_level));
    if (greatest_ == 0) refuse("a greatest level from 1 to 65535", "0");
    map.columns = columns;
    if (kind == "P5") {
      ++at_;  // one white space
      take_bytes(columns * rows, map.greys);
    } else {
      take_figures(columns * rows, map.greys);
    }
  }

 private:
  [[noreturn]] void refuse(const std::string& expected, const std::string& got) const {
    throw InputError(Place{file_, 0, 0, ""}, fmt::format("expected {}, got {}", expected, got));
  }

  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f'; }

  // The next number, after white space and comments.
  std::size_t number(std::string_view what, std::size_t most) {
    while (at_ < text_.size() && (is_space(text_[at_]) || text_[at_] == '#')) {
      if (text_[at_] == '#') {
        while (at_ < text_.size() && text_[at_] != '\n') ++at_;
      } else {
        ++at_;
      }
    }
    const std::size_t first = at_;
    std::size_t value = 0;
    while (at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9' && value <= most) {
      value = 10 * value + static_cast<std::size_t>(text_[at_++] - '0');
    }
    if (at_ == first || value > most) {
      refuse(std::string(what), at_ == text_.size() && at_ == first ? "the end" : in_quotes(text_.substr(first, 12)));
    }
    return value;
  }

  float grey(unsigned level) const {
    if (level > greatest_) refuse(fmt::format("levels up to {}", greatest_), fmt::format("{}", level));
    return static_cast<float>(level) / static_cast<float>(greatest_);
  }

  void take_bytes(std::size_t count, std::vector<float>& greys) {
    const std::size_t width = greatest_ > 255 ? 2 : 1;
    const std::size_t left = text_.size() - std::min(at_, text_.size());
    if (left < width * count) refuse(fmt::format("{} bytes of pixels", width * count), fmt::format("{}", left));
    greys.reserve(count);
    const auto byte = [&](std::size_t i) { return static_cast<unsigned>(static_cast<unsigned char>(text_[at_ + i])); };
    for (std::size_t i = 0; i < count; ++i) {
      greys.push_back(grey(width == 1 ? byte(i) : 256U * byte(2 * i) + byte(2 * i + 1)));
    }
  }

  void take_figures(std::size_t count, std::vector<float>& greys) {
    // Each takes two bytes or more.
    if (text_.size() - at_ < 2 * count - 1) refuse(fmt::format("{} pixels", count), "fewer");
    greys.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      greys.push_back(grey(static_cast<unsigned>(number("a level for each pixel", most_level))));
    }
  }

  std::string file_;
  std::string_view text_;
  std::size_t at_ = 0;
  unsigned greatest_ = 0;
};

}  // namespace

GreyMapFile grey_map_of_file(const std::filesystem::path& file, const Place& place) {
  const std::string text = input_text(file, largest_outline_bytes, place);
  GreyMapFile result;
  GreymapReader(file.string(), text).read(result);
  Sha256 hash;
  hash.add_text(text);
  result.sum = hash.sum();
  return result;
}

}  // namespace shatterpave::scene
