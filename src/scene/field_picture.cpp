#include "scene/field_picture.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <exception>
#include <stdexcept>

#include "core/error.h"
#include "scene/input_file.h"

namespace shatterpave::scene {

namespace {

class ContentStream final : public Imf::IStream {
 public:
  ContentStream(const std::string& content, const std::string& file) : Imf::IStream(file.c_str()), content_(content) {}

  bool read(char out[], int count) override {
    if (static_cast<std::size_t>(count) > content_.size() - at_) throw std::runtime_error("the file ends too early");
    std::memcpy(out, content_.data() + at_, static_cast<std::size_t>(count));
    at_ += static_cast<std::size_t>(count);
    return at_ < content_.size();
  }
  std::uint64_t tellg() override { return at_; }
  void seekg(std::uint64_t to) override { at_ = std::min<std::size_t>(to, content_.size()); }

 private:
  const std::string& content_;
  std::size_t at_ = 0;
};

[[noreturn]] void refuse_picture(const std::string& file, const std::string& expected, const std::string& got) {
  throw InputError(Place{file, 0, 0, ""}, fmt::format("expected {}, got {}", expected, got));
}

const ChannelPair& pair_of(const Imf::ChannelList& channels, const std::string& file, std::span<const ChannelPair> pairs) {
  const auto is_whole = [&](std::string_view name) {
    const Imf::Channel* channel = channels.findChannel(std::string(name));
    return channel != nullptr && channel->xSampling == 1 && channel->ySampling == 1;
  };
  const auto found =
      std::ranges::find_if(pairs, [&](const ChannelPair& pair) { return is_whole(pair.first) && is_whole(pair.second); });
  if (found != pairs.end()) return *found;
  std::vector<std::string> expected;
  expected.reserve(pairs.size());
  for (const ChannelPair& pair : pairs) expected.push_back(fmt::format("{} and {}", pair.first, pair.second));
  std::vector<std::string> got;
  for (auto channel = channels.begin(); channel != channels.end(); ++channel) got.emplace_back(channel.name());
  refuse_picture(file, fmt::format("channels {}", fmt::join(expected, ", or ")),
                 in_quotes(fmt::format("{}", fmt::join(got, ", "))));
}

PairPicture read_pair(Imf::InputFile& input, const std::string& file, std::span<const ChannelPair> pairs) {
  const ChannelPair& pair = pair_of(input.header().channels(), file, pairs);
  const Imath::Box2i window = input.header().dataWindow();
  const auto width = std::int64_t{window.max.x} - window.min.x + 1;
  const auto height = std::int64_t{window.max.y} - window.min.y + 1;
  if (width < 1 || height < 1 || width > static_cast<std::int64_t>(most_field_pixels) / height) {
    refuse_picture(file, fmt::format("1 to {} pixels", most_field_pixels), fmt::format("{} x {}", width, height));
  }
  PairPicture picture{static_cast<std::size_t>(width), static_cast<std::size_t>(height), {}, {}};
  picture.first.resize(picture.columns * picture.rows);
  picture.second.resize(picture.columns * picture.rows);
  Imf::FrameBuffer buffer;
  const auto slice = [&](std::vector<float>& values) {
    return Imf::Slice::Make(Imf::FLOAT, values.data(), window, sizeof(float), sizeof(float) * picture.columns);
  };
  buffer.insert(std::string(pair.first), slice(picture.first));
  buffer.insert(std::string(pair.second), slice(picture.second));
  input.setFrameBuffer(buffer);
  input.readPixels(window.min.y, window.max.y);
  return picture;
}

}  // namespace

PairPicture pair_of_exr(const std::string& content, const std::string& file, std::span<const ChannelPair> pairs) {
  ContentStream stream(content, file);
  try {
    Imf::InputFile input(stream, 0);  // no threads of its own
    return read_pair(input, file, pairs);
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    refuse_picture(file, "an OpenEXR picture", in_quotes(error.what()));
  }
}

}  // namespace shatterpave::scene
