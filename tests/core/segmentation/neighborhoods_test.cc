#include "core/segmentation/neighborhoods.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <vector>

namespace fovea {
namespace {

std::vector<Eigen::Vector3f> RandomPositions(unsigned seed, int count) {
  std::mt19937 random(seed);
  const auto uniform = [&] { return static_cast<float>(random() % 2001) / 1000.0F - 1; };
  std::vector<Eigen::Vector3f> positions;
  for (int i = 0; i < count; ++i) {
    const float x = uniform(), y = uniform();
    positions.emplace_back(x, y, uniform());
  }
  return positions;
}

TEST(ForEachNeighborhood, HasEachCenterOnceAndAllWithinReach) {
  const std::vector<Eigen::Vector3f> centers = RandomPositions(1, 50);
  const std::vector<Eigen::Vector3f> others = RandomPositions(2, 400);
  constexpr float kReach_m = 0.2F;
  std::vector<int> num_met(centers.size(), 0);
  std::size_t num_pairs = 0;
  ForEachNeighborhood(centers, others, kReach_m,
                      [&](const std::vector<int>& members, const std::vector<int>& near) {
                        EXPECT_TRUE(std::ranges::is_sorted(members));
                        EXPECT_TRUE(std::ranges::is_sorted(near));
                        const std::set<int> is_near(near.begin(), near.end());
                        EXPECT_EQ(is_near.size(), near.size());
                        for (const int i : members) {
                          ++num_met[i];
                          num_pairs += near.size();
                          for (int j = 0; j < 400; ++j) {
                            const bool beyond = (centers[i] - others[j]).norm() > kReach_m;
                            EXPECT_TRUE(beyond || is_near.contains(j)) << i << " " << j;
                          }
                        }
                      });
  EXPECT_EQ(num_met, std::vector<int>(centers.size(), 1));
  EXPECT_LT(num_pairs, centers.size() * others.size() / 10) << "looks at far more than it must";
}

TEST(ForEachNeighborhood, OfWhatReachesFarIsAll) {
  const std::vector<Eigen::Vector3f> positions{{0, 0, 0}, {90, 0, 0}, {0, 0, 90}};
  ForEachNeighborhood(positions, positions, 100, [&](const auto& /*members*/, const auto& near) {
    EXPECT_EQ(near, (std::vector<int>{0, 1, 2}));
  });
}

}  // namespace
}  // namespace fovea
