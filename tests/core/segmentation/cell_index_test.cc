#include "core/segmentation/cell_index.h"

#include <gtest/gtest.h>

namespace fovea {
namespace {

TEST(CellIndex, FindsWhatWasAddedAndNothingElse) {
  CellIndex index;
  EXPECT_EQ(index.Find({0, 0, 0}), -1);
  EXPECT_EQ(index.FindOrAdd({1, -2, 3}, 7), 7);
  EXPECT_EQ(index.FindOrAdd({1, -2, 3}, 8), 7);
  EXPECT_EQ(index.Find({1, -2, 3}), 7);
  EXPECT_EQ(index.Find({1, 3, -2}), -1);
}

TEST(CellIndex, KeepsAllAsItGrows) {
  CellIndex index;
  constexpr int kSide = 20;
  const auto cell = [](int i) {
    return Eigen::Vector3i(i % kSide - 10, i / kSide % kSide - 10, i / kSide / kSide - 10);
  };
  for (int i = 0; i < kSide * kSide * kSide; ++i) ASSERT_EQ(index.FindOrAdd(cell(i), i), i);
  for (int i = 0; i < kSide * kSide * kSide; ++i) ASSERT_EQ(index.Find(cell(i)), i);
  EXPECT_EQ(index.Find({10, 10, 10}), -1);
}

}  // namespace
}  // namespace fovea
