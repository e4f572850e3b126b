// What all harnesses of libFuzzer have in common: any bytes become a value, or an InputError of one line. All else is a find:
// another exception, a crash, what the sanitizers see, and input that takes longer or more memory than .ci/long/fuzz allows.
#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "core/error.h"

namespace shatterpave::fuzz {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};  // bytes as they are
}

template <typename Read>
int value_or_input_error(const Read& read) {
  try {
    read();
  } catch (const InputError& error) {
    if (std::string_view(error.what()).find('\n') == std::string_view::npos) return 0;
    std::fprintf(stderr, "a message of several lines: %s\n", error.what());
    std::abort();
  }
  return 0;
}

// A file of this process that holds the bytes, in memory where the system has a place for that. The same at each call.
inline std::filesystem::path file_with(std::string_view bytes, const std::string& extension) {
  static const std::filesystem::path folder =
      std::filesystem::is_directory("/dev/shm") ? std::filesystem::path("/dev/shm") : std::filesystem::temp_directory_path();
  const std::filesystem::path file = folder / ("shatterpave_fuzz_" + std::to_string(::getpid()) + extension);
  std::ofstream(file, std::ios::binary | std::ios::trunc).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return file;
}

}  // namespace shatterpave::fuzz

// The body of a harness: `text` are the bytes, as a text.
#define SHATTERPAVE_FUZZ(text)                                                                                         \
  static void shatterpave_read(std::string_view text);                                                                 \
  extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {                                  \
    return shatterpave::fuzz::value_or_input_error([&] { shatterpave_read(shatterpave::fuzz::text_of(data, size)); }); \
  }                                                                                                                    \
  static void shatterpave_read(std::string_view text)
