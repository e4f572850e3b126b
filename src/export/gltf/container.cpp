#include "export/gltf/container.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "core/error.h"

namespace shatterpave::exporting::gltf {

namespace {

void append_word(std::string& out, std::size_t word) {
  const auto narrow = static_cast<std::uint32_t>(word);
  out.append(reinterpret_cast<const char*>(&narrow), sizeof narrow);
}

}  // namespace

void Data::append(const void* data, std::size_t bytes) {
  constexpr std::size_t block = std::size_t{16} << 20;
  if (blocks_.empty() || blocks_.back().size() + bytes > blocks_.back().capacity()) {
    blocks_.emplace_back().reserve(std::max(block, bytes));
  }
  blocks_.back().append(static_cast<const char*>(data), bytes);
  size_ += bytes;
}

void Data::align() {
  constexpr std::array<char, 4> zeros{};
  append(zeros.data(), (4 - size_ % 4) % 4);
}

void Data::move_to(std::string& out) {
  for (std::string& block : blocks_) {
    out += block;
    block = {};
  }
  blocks_.clear();
  size_ = 0;
}

std::string container(std::string json, Data& data) {
  constexpr std::size_t magic = 0x46546C67;  // "glTF"
  constexpr std::size_t json_chunk = 0x4E4F534A;
  constexpr std::size_t data_chunk = 0x004E4942;
  data.align();
  json.append((4 - json.size() % 4) % 4, ' ');
  const std::size_t length = 12 + 8 + json.size() + 8 + data.size();
  if (length > std::numeric_limits<std::uint32_t>::max()) {
    throw InputError("target gltf: expected at most 4 GB, which its format holds, got more");
  }
  std::string out;
  out.reserve(length);
  for (const std::size_t word : {magic, std::size_t{2}, length, json.size(), json_chunk}) append_word(out, word);
  out += json;
  for (const std::size_t word : {data.size(), data_chunk}) append_word(out, word);
  data.move_to(out);
  return out;
}

}  // namespace shatterpave::exporting::gltf
