#include "tests/evaluation/statistics.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <stdexcept>

#include "tests/evaluation/parallel.h"

namespace fovea::evaluation {
namespace {

TEST(Statistics, ByHand) {
  EXPECT_DOUBLE_EQ(Median({3, 1, 2}), 2);
  EXPECT_DOUBLE_EQ(Median({4, 1, 3, 2}), 3);
  EXPECT_DOUBLE_EQ(Median({}), 0);
  EXPECT_DOUBLE_EQ(SpreadOf({1, 2, 6}).mean, 3);
  EXPECT_DOUBLE_EQ(SpreadOf({1, 2, 6}).deviation, std::sqrt(7));
  EXPECT_DOUBLE_EQ(SpreadOf({5}).deviation, 0);
  EXPECT_DOUBLE_EQ(LineAt(10, {1, 2, 3}, {2, 5, 5}), 16);  // 1 + 1.5 x
  EXPECT_DOUBLE_EQ(LineAt(10, {2, 2}, {1, 4}), 2.5);
  EXPECT_DOUBLE_EQ(LineAt(10, {}, {}), 0);
}

TEST(ForEachIndex, CallsEachOnceAndPassesFailuresOn) {
  std::vector<std::atomic<int>> calls(100);
  ForEachIndex(calls.size(), 3, [&](std::size_t i) { ++calls[i]; });
  for (const auto& count : calls) EXPECT_EQ(count, 1);
  EXPECT_THROW(ForEachIndex(5, 2, [](std::size_t) { throw std::runtime_error("no"); }),
               std::runtime_error);
}

}  // namespace
}  // namespace fovea::evaluation
