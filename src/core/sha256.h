// SHA-256 (FIPS 180-4), by OpenSSL: sums that any tool can check.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace shatterpave {

class Sha256 {
 public:
  Sha256();
  ~Sha256();
  Sha256(const Sha256&) = delete;
  Sha256& operator=(const Sha256&) = delete;

  void add(std::string_view bytes);
  // Adds the length of the text, then the text, so that two texts do not run into one another.
  void add_text(std::string_view text);
  // The sum of all bytes, as 64 hexadecimal digits. Nothing may be added after it.
  std::string sum();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

std::string sha256(std::string_view bytes);

}  // namespace shatterpave
