#include "core/objects/rejection.h"

#include <gtest/gtest.h>

namespace fovea {
namespace {

// Segments 0 to 3; 4 joins 0 and 1, 5 joins 4 and 2; 3 is alone.
struct Scene {
  Scene() : evidence(6) {
    tree.num_segments = 4;
    tree.nodes = {{.parent = 4},
                  {.parent = 4},
                  {.parent = 5},
                  {},
                  {.left = 0, .right = 1, .parent = 5},
                  {.left = 4, .right = 2}};
    for (std::size_t n = 0; n < evidence.size(); ++n) {
      evidence[n].num_pixels = 500;
      evidence[n].part.num_voxels = 1;
      evidence[n].part.area_m2 = 0.01;
      evidence[n].part.extent.extend(Eigen::Vector3f::Zero());
      evidence[n].bounds_px = cv::Rect(static_cast<int>(n), 0, 10, 10);
    }
  }

  std::vector<RejectedObject> Rejected(const std::vector<int>& chosen,
                                       const std::vector<double>& probabilities) const {
    auto rejected = FindRejected(tree, chosen, evidence, probabilities, FittedObjectModel());
    KeepLikeliest(rejected);
    return rejected;
  }

  MergeTree tree;
  std::vector<ObjectEvidence> evidence;
};

TEST(FindRejected, TellsTheLikeliestOfEachPartThatIsLeft) {
  const auto rejected = Scene().Rejected({}, {0.1, 0.05, 0.02, 0.15, 0.12, 0.04});
  ASSERT_EQ(rejected.size(), 2U);
  EXPECT_EQ(rejected[0].bounds_px.x, 3);
  EXPECT_FLOAT_EQ(rejected[0].probability, 0.15F);
  EXPECT_EQ(rejected[1].bounds_px.x, 4);
  EXPECT_FALSE(rejected[1].reason.empty());
}

TEST(FindRejected, LeavesOutWhatIsChosenWithinOrAroundIt) {
  const auto rejected = Scene().Rejected({4}, {0.1, 0.05, 0.02, 0.15, 0.9, 0.04});
  ASSERT_EQ(rejected.size(), 2U);
  EXPECT_EQ(rejected[0].bounds_px.x, 3);
  EXPECT_EQ(rejected[1].bounds_px.x, 2);
}

TEST(FindRejected, LeavesOutSpecks) {
  Scene scene;
  scene.evidence[3].num_pixels = 5;
  EXPECT_EQ(scene.Rejected({5}, {0, 0, 0, 0.2, 0, 0.9}).size(), 0U);
}

TEST(KeepLikeliest, KeepsAHundred) {
  std::vector<RejectedObject> rejected;
  for (int i = 0; i < 150; ++i) rejected.push_back({{}, static_cast<float>(i % 50) / 100, ""});
  KeepLikeliest(rejected);
  ASSERT_EQ(rejected.size(), 100U);
  EXPECT_FLOAT_EQ(rejected.front().probability, 0.49F);
  EXPECT_FLOAT_EQ(rejected.back().probability, 0.16F);
}

TEST(ObjectModel, NamesWhatIsFarthestBelowItsUsualValue) {
  ObjectModel model;
  model.functions[static_cast<std::size_t>(ObjectTerm::kArea)].slopes[0] = 1;
  model.functions[static_cast<std::size_t>(ObjectTerm::kClosed)].slopes[0] = -3;
  model.usual[static_cast<std::size_t>(ObjectTerm::kArea)] = -4;
  ObjectTerms terms{};
  terms[static_cast<std::size_t>(ObjectTerm::kArea)] = -6;
  EXPECT_EQ(model.StrongestAgainst(terms), ObjectTerm::kArea);
  terms[static_cast<std::size_t>(ObjectTerm::kClosed)] = 1;
  EXPECT_EQ(model.StrongestAgainst(terms), ObjectTerm::kClosed);
}

}  // namespace
}  // namespace fovea
