// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>

#include "smore/mapping/bit_counts.h"

namespace smore {
namespace {

TEST(BitCounts, AgreeWithCountingOneByOne) {
  std::mt19937_64 random(2);
  BitCounts<2> counts;
  std::array<int, 128> expected{};
  for (int set = 0; set < 1000; ++set) {
    // Both dense and sparse sets.
    std::array<std::uint64_t, 2> bits = {random(), random() & random() & random()};
    if (set % 7 == 0) bits = {0, ~std::uint64_t{0}};
    counts.add(bits);
    for (int i = 0; i < 128; ++i) expected[i] += static_cast<int>((bits[i / 64] >> (i % 64)) & 1U);
  }
  EXPECT_EQ(counts.counts(), expected);
}

TEST(BitCounts, StartAtZero) { EXPECT_EQ(BitCounts<4>().counts(), (std::array<int, 256>{})); }

}  // namespace
}  // namespace smore
