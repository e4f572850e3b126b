#include "core/random.h"

#include <Random123/philox.h>

#include <cmath>

#include "core/error.h"
#include "core/functions.h"

namespace shatterpave {

namespace {

struct UniformPair {
  double first;   // [0, 1)
  double second;  // [0, 1)
};

// The 128 bits of one block, as two numbers of 53 bits.
UniformPair uniform_pair(std::uint64_t seed, const Address& address) {
  const std::uint64_t element = address.element.value();
  const r123::Philox4x32::ctr_type counter = {{static_cast<std::uint32_t>(element), static_cast<std::uint32_t>(element >> 32U),
                                               address.draw, static_cast<std::uint32_t>(address.stream)}};
  const r123::Philox4x32::key_type key = {{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32U)}};
  const r123::Philox4x32::ctr_type bits = r123::Philox4x32()(counter, key);
  const auto real = [](std::uint64_t high, std::uint64_t low) {
    return static_cast<double>((high << 21U) | (low >> 11U)) * 0x1p-53;
  };
  return {real(bits[0], bits[1]), real(bits[2], bits[3])};
}

}  // namespace

double uniform(std::uint64_t seed, const Address& address) { return uniform_pair(seed, address).first; }

double normal(std::uint64_t seed, const Address& address) {
  // Box and Muller, "A note on the generation of random normal deviates", Ann. Math. Stat. 29 (1958).
  const UniformPair u = uniform_pair(seed, address);
  return std::sqrt(-2.0 * logarithm(1.0 - u.first)) * cosine(2.0 * pi * u.second);
}

int poisson(std::uint64_t seed, const Address& address, double mean) {
  ENSURE(mean >= 0.0 && mean <= 1e6);
  // Walk the distribution function outwards from 0 in logarithms, so that no mean underflows.
  const double u = uniform(seed, address);
  double log_probability = -mean;
  double cumulative = exponential(log_probability);
  const int last = static_cast<int>(mean + 40.0 * std::sqrt(mean) + 40.0);
  int k = 0;
  while (cumulative <= u && k < last) {
    ++k;
    log_probability += logarithm(mean / k);
    cumulative += exponential(log_probability);
  }
  return k;
}

}  // namespace shatterpave
