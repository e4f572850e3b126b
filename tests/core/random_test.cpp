#include "core/random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "support/laws.h"

namespace shatterpave {
namespace {

using support::chi_square_p;
using support::kolmogorov_p;
using support::significance;

// Philox 4x32-10 after §2 and table 2 of Salmon et al. 2011, written anew: the oracle.
std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> c, std::array<std::uint32_t, 2> k) {
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t first = std::uint64_t{0xD2511F53} * c[0];
    const std::uint64_t second = std::uint64_t{0xCD9E8D57} * c[2];
    c = {static_cast<std::uint32_t>(second >> 32U) ^ c[1] ^ k[0], static_cast<std::uint32_t>(second),
         static_cast<std::uint32_t>(first >> 32U) ^ c[3] ^ k[1], static_cast<std::uint32_t>(first)};
    k[0] += 0x9E3779B9U;
    k[1] += 0xBB67AE85U;
  }
  return c;
}

constexpr std::uint32_t sample_size = 20000;

template <typename Draw>
std::vector<double> sample_of(const Draw& draw) {
  std::vector<double> sample;
  for (std::uint32_t i = 0; i < sample_size; ++i) sample.push_back(draw(i));
  return sample;
}

double gauss_distribution(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

TEST(Random, DrawDependsOnItsAddressOnly) {
  std::vector<double> forwards;
  for (std::uint32_t i = 0; i < 100; ++i) forwards.push_back(uniform(7, {Stream::turn, Id("pane"), i}));
  for (std::uint32_t i = 100; i-- > 0;) {
    static_cast<void>(uniform(7, {Stream::large_speed, Id("elsewhere"), i}));
    EXPECT_EQ(forwards[i], uniform(7, {Stream::turn, Id("pane"), i}));
  }
}

TEST(Random, IsPhilox) {
  // Known answers of the Random123 distribution, for the oracle.
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}), (std::array<std::uint32_t, 4>{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (std::array<std::uint32_t, 4>{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
  for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{7}, ~std::uint64_t{0}, std::uint64_t{1} << 40U}) {
    const Id element = Id("pane").child(seed);
    const auto bits = philox({static_cast<std::uint32_t>(element.value()), static_cast<std::uint32_t>(element.value() >> 32U),
                              5, static_cast<std::uint32_t>(Stream::turn)},
                             {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32U)});
    const std::uint64_t high_53 = ((std::uint64_t{bits[0]} << 32U) | bits[1]) >> 11U;
    EXPECT_EQ(uniform(seed, {Stream::turn, element, 5}), std::ldexp(static_cast<double>(high_53), -53));
  }
}

// Renumbering a stream would change every user's pictures.
TEST(Random, StreamsKeepTheirNumbers) {
  const std::vector<std::pair<Stream, std::uint32_t>> numbers = {
      {Stream::radial_count, 1},  {Stream::large_speed, 2},   {Stream::radial_speed, 3},    {Stream::ring_radius, 4},
      {Stream::ring_speed, 5},    {Stream::turn, 6},          {Stream::first_direction, 7}, {Stream::large_choice, 8},
      {Stream::stone_seed, 20},   {Stream::packing, 21},      {Stream::stone_height, 22},   {Stream::stone_inset, 23},
      {Stream::stone_colour, 24}, {Stream::stone_relief, 25}, {Stream::relief_lattice, 26}, {Stream::stone_tilt, 27},
      {Stream::debris, 40}};
  for (const auto& [stream, number] : numbers) EXPECT_EQ(static_cast<std::uint32_t>(stream), number);
}

TEST(Random, UniformIsUniform) {
  const auto identity = [](double x) { return x; };
  const auto over_draws = sample_of([](std::uint32_t i) { return uniform(7, {Stream::turn, Id("pane"), i}); });
  for (const double u : over_draws) {
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
  }
  EXPECT_GT(kolmogorov_p(over_draws, identity), significance());
  EXPECT_GT(kolmogorov_p(sample_of([](std::uint32_t i) {
                           return uniform(7, {Stream::turn, Id("pane").child(i), 0});
                         }),
                         identity),
            significance());
  EXPECT_GT(kolmogorov_p(sample_of([](std::uint32_t i) {
                           return uniform(i, {Stream::turn, Id("pane"), 0});
                         }),
                         identity),
            significance());
  EXPECT_LT(kolmogorov_p(over_draws, [](double x) { return std::pow(x, 1.06); }), significance()) << "the wrong twin";
}

TEST(Random, NeighboursAreIndependent) {
  constexpr std::size_t cells = 8;
  const auto cell = [](double u) { return static_cast<std::size_t>(u * cells); };
  const auto draw = [](std::uint32_t i) { return uniform(3, {Stream::packing, Id("stone"), i}); };
  // `copied` is the share of pairs whose second number is the first again: 0 for the right law.
  const auto p_of = [&](double copied) {
    std::vector<double> observed(cells * cells, 0.0);
    for (std::uint32_t i = 0; i < sample_size; ++i) {
      const bool copy = uniform(4, {Stream::packing, Id("stone"), i}) < copied;
      observed[cell(draw(i)) * cells + cell(draw(copy ? i : i + 1))] += 1.0;
    }
    return chi_square_p(observed, std::vector<double>(observed.size(), sample_size / static_cast<double>(observed.size())));
  };
  EXPECT_GT(p_of(0.0), significance());
  EXPECT_LT(p_of(0.05), significance()) << "the wrong twin";
}

TEST(Random, NormalIsNormal) {
  const auto sample = sample_of([](std::uint32_t i) { return normal(11, {Stream::turn, Id("tip"), i}); });
  EXPECT_GT(kolmogorov_p(sample, gauss_distribution), significance());
  EXPECT_LT(kolmogorov_p(sample, [](double x) { return gauss_distribution(x / 1.06); }), significance()) << "the wrong twin";
}

std::vector<double> poisson_law(double mean, std::size_t cells) {
  std::vector<double> law;
  double rest = sample_size;
  for (std::size_t k = 0; k + 1 < cells; ++k) {
    const auto count = static_cast<double>(k);
    law.push_back(sample_size * std::exp(count * std::log(mean) - mean - std::lgamma(count + 1.0)));
    rest -= law.back();
  }
  law.push_back(rest);
  return law;
}

TEST(Random, PoissonIsPoisson) {
  for (const double mean : {0.4, 3.5, 105.0, 300.0}) {
    const auto cells = static_cast<std::size_t>(mean + 12.0 * std::sqrt(mean) + 12.0);
    std::vector<double> observed(cells, 0.0);
    for (std::uint32_t i = 0; i < sample_size; ++i) {
      const int count = poisson(5, {Stream::radial_count, Id("impact"), i}, mean);
      ASSERT_GE(count, 0);
      observed[std::min(static_cast<std::size_t>(count), cells - 1)] += 1.0;
    }
    EXPECT_GT(chi_square_p(observed, poisson_law(mean, cells)), significance()) << mean;
    EXPECT_LT(chi_square_p(observed, poisson_law(mean * (1.0 + 0.15 / std::sqrt(mean)), cells)), significance())
        << "the wrong twin of " << mean << ", off by 0.15 of a standard deviation";
  }
}

TEST(Random, PoissonAtItsLimits) {
  for (std::uint32_t i = 0; i < 5; ++i) {
    EXPECT_EQ(poisson(5, {Stream::radial_count, Id("impact"), i}, 0.0), 0);
    EXPECT_NEAR(poisson(5, {Stream::radial_count, Id("impact"), i}, 1e6), 1e6, 5000.0) << "five standard deviations";
  }
}

TEST(Id, IsFnv1a) {
  // Test vectors of the authors (Fowler, Noll, Vo).
  EXPECT_EQ(Id("").value(), 0xcbf29ce484222325ULL);
  EXPECT_EQ(Id("a").value(), 0xaf63dc4c8601ec8cULL);
  EXPECT_EQ(Id("foobar").value(), 0x85944171f73967e8ULL);
}

TEST(Id, TellsElementsApart) {
  EXPECT_FALSE(Id("ab").child("c") == Id("a").child("bc"));
  EXPECT_FALSE(Id("pane").child(std::uint64_t{1}).child(std::uint64_t{2}) ==
               Id("pane").child(std::uint64_t{2}).child(std::uint64_t{1}));
  EXPECT_FALSE(Id("pane").child(std::uint64_t{1}) == Id("pane").child(std::uint64_t{256}));
}

}  // namespace
}  // namespace shatterpave
