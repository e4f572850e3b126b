// The container of a binary glTF (.glb): a header, a chunk of JSON, and one of data. Knows nothing of what they hold.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace shatterpave::exporting::gltf {

// Bytes that become many, in blocks: none of them moves when there are more.
class Data {
 public:
  std::size_t size() const { return size_; }
  void append(const void* data, std::size_t bytes);
  // So that what follows begins at a multiple of 4.
  void align();
  // Adds them to `out`, and frees them.
  void move_to(std::string& out);

 private:
  std::vector<std::string> blocks_;
  std::size_t size_ = 0;
};

// The file, with the data, which is empty then; spaces fill up the JSON. Throws InputError beyond 4 GB.
std::string container(std::string json, Data& data);

}  // namespace shatterpave::exporting::gltf
