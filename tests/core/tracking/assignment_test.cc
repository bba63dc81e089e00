#include "core/tracking/assignment.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace fovea {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(MaximumAssignment, GivesUpABestPairForABetterSum) {
  Eigen::MatrixXd gains(2, 2);
  gains << 0.9, 0.8, 0.8, 0.1;
  EXPECT_THAT(MaximumAssignment(gains), ElementsAre(1, 0));
}

TEST(MaximumAssignment, LeavesRowsOrColumnsOver) {
  Eigen::MatrixXd gains(3, 1);
  gains << 1, 3, 2;
  EXPECT_THAT(MaximumAssignment(gains), ElementsAre(-1, 0, -1));
  EXPECT_THAT(MaximumAssignment(gains.transpose()), ElementsAre(1));
  EXPECT_THAT(MaximumAssignment(Eigen::MatrixXd(0, 3)), IsEmpty());
  EXPECT_THAT(MaximumAssignment(Eigen::MatrixXd(2, 0)), ElementsAre(-1, -1));
}

TEST(MaximumAssignment, EqualsTheBestOfAllPermutations) {
  std::mt19937_64 random(7);
  for (int trial = 0; trial < 200; ++trial) {
    Eigen::MatrixXd gains(5, 5);
    for (double& gain : gains.reshaped()) gain = static_cast<double>(random() % 100);
    std::vector<int> permutation(5);
    std::iota(permutation.begin(), permutation.end(), 0);
    const auto sum = [&](const std::vector<int>& columns) {
      double total = 0;
      for (int i = 0; i < 5; ++i) total += gains(i, columns[i]);
      return total;
    };
    double best = 0;
    do {
      best = std::max(best, sum(permutation));
    } while (std::next_permutation(permutation.begin(), permutation.end()));
    EXPECT_DOUBLE_EQ(sum(MaximumAssignment(gains)), best) << "trial " << trial;
  }
}

}  // namespace
}  // namespace fovea
