#include "geometry/growing_store.h"

#include <gtest/gtest.h>

#include <array>

namespace shatterpave::geometry {
namespace {

// Of an odd size, so that it fills no block, and larger than one, so that blocks hold one value.
template <std::size_t bytes>
void expect_values_kept_in_place() {
  struct Value {
    int number = 0;
    std::array<char, bytes - sizeof(int)> rest{};
  };
  GrowingStore<Value> store;
  EXPECT_TRUE(store.empty());
  const Value* first = &store.push_back({0, {}});
  for (int i = 1; i < 3000; ++i) EXPECT_EQ(store.push_back({i, {}}).number, i);
  EXPECT_EQ(store.size(), 3000U);
  EXPECT_FALSE(store.empty());
  EXPECT_EQ(first, &store[0]);
  for (std::size_t i = 0; i < store.size(); ++i) EXPECT_EQ(store[i].number, static_cast<int>(i));
}

TEST(GrowingStore, KeepsValuesInOrderAndInPlace) {
  expect_values_kept_in_place<20>();
  expect_values_kept_in_place<264>();
  expect_values_kept_in_place<9000>();
}

}  // namespace
}  // namespace shatterpave::geometry
