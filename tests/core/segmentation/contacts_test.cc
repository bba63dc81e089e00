#include "core/segmentation/contacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace fovea {
namespace {

// Voxels in random cells around the origin, each cell once.
VoxelGrid RandomGrid(int num_voxels, std::mt19937& random) {
  std::uniform_int_distribution<int> coordinate(-6, 6);
  std::set<std::vector<int>> cells;
  while (static_cast<int>(cells.size()) < num_voxels) {
    cells.insert({coordinate(random), coordinate(random), coordinate(random)});
  }
  VoxelGrid grid;
  for (const auto& cell : cells) grid.voxels.push_back({.cell = {cell[0], cell[1], cell[2]}});
  std::shuffle(grid.voxels.begin(), grid.voxels.end(), random);
  return grid;
}

std::set<std::pair<int, int>> ContactsOfAllPairs(const VoxelGrid& grid,
                                                 const std::vector<int>& labels, int reach) {
  std::set<std::pair<int, int>> contacts;
  for (int a = 0; a < static_cast<int>(labels.size()); ++a) {
    for (int b = a + 1; b < static_cast<int>(labels.size()); ++b) {
      const Eigen::Vector3i step = grid.voxels[a].cell - grid.voxels[b].cell;
      if (labels[a] == 0 || labels[b] == 0 || labels[a] == labels[b]) continue;
      if (step.cwiseAbs().maxCoeff() <= reach) contacts.emplace(a, b);
    }
  }
  return contacts;
}

TEST(FindContacts, FindsEveryPairOfTwoSegmentsOnce) {
  constexpr unsigned kSeed = 5;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  std::mt19937 random(kSeed);
  const VoxelGrid grid = RandomGrid(500, random);
  std::vector<int> labels;
  for (std::size_t v = 0; v < grid.voxels.size(); ++v) labels.push_back(static_cast<int>(v) % 4);
  for (const int reach : {1, 2, 3}) {
    const std::vector<VoxelEdge> contacts = FindContacts(grid, labels, reach);
    std::set<std::pair<int, int>> found;
    for (const VoxelEdge& contact : contacts) found.emplace(contact.a, contact.b);
    EXPECT_EQ(found.size(), contacts.size()) << "a contact is there twice";
    EXPECT_EQ(found, ContactsOfAllPairs(grid, labels, reach)) << "reach " << reach;
  }
}

TEST(FindContacts, FindsNothingWithoutSegments) {
  std::mt19937 random(1);
  const VoxelGrid grid = RandomGrid(50, random);
  EXPECT_TRUE(FindContacts(grid, std::vector<int>(50, 0), 2).empty());
  EXPECT_TRUE(FindContacts({}, {}, 2).empty());
}

}  // namespace
}  // namespace fovea
