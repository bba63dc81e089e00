#include "core/objects/object_evidence.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/objects/object_terms.h"
#include "tests/core/objects/test_scene.h"

namespace fovea {
namespace {

// Two segments side by side and what joins them.
MergeTree PairTree() {
  MergeTree tree;
  tree.num_segments = 2;
  tree.min_log_odds = -6;
  tree.nodes = {{.parent = 2}, {.parent = 2}, {.left = 0, .right = 1, .log_odds = 1.5}};
  return tree;
}

std::vector<ObjectEvidence> EvidenceOfPair(TestScene& scene) {
  scene.Put({80, 40, 20, 30}, 1, 1);
  scene.Put({100, 40, 20, 30}, 1, 2);
  const LabelledScene labelled = scene.Labelled();
  return CollectEvidence(LookAtSegments(labelled, scene.segments, {}), PairTree());
}

TEST(CollectEvidence, AddsUpWithoutInnerBorders) {
  TestScene scene(2);
  const auto evidence = EvidenceOfPair(scene);
  ASSERT_EQ(evidence.size(), 3U);
  EXPECT_EQ(evidence[0].borders.Total(), 100);
  EXPECT_EQ(evidence[0].borders.Of(Beyond::kLevelSegment), 30);
  EXPECT_EQ(evidence[2].borders.Total(), 140);
  EXPECT_EQ(evidence[2].borders.Of(Beyond::kFarther), 140);
  EXPECT_EQ(evidence[2].borders.Of(Beyond::kLevelSegment), 0);
  EXPECT_EQ(evidence[2].num_pixels, 1200);
  EXPECT_EQ(evidence[2].bounds_px, cv::Rect(80, 40, 40, 30));
  EXPECT_EQ(evidence[2].num_segments, 2);
  EXPECT_NEAR(evidence[2].part.extent.sizes().x(), 0.39, 1e-4);
}

// Four segments, two over two: each pair is joined, then the pairs.
TEST(CollectEvidence, AddsUpPairsOfPairs) {
  TestScene scene(2);
  scene.Put({80, 40, 20, 30}, 1, 1);
  scene.Put({100, 40, 20, 30}, 1, 2);
  scene.Put({80, 70, 20, 30}, 1, 3);
  scene.Put({100, 70, 20, 30}, 1, 4);
  scene.standing = cv::Mat::zeros(scene.labels.size(), CV_8UC1);
  scene.standing(cv::Rect(90, 65, 20, 10)).setTo(255);
  MergeTree tree;
  tree.num_segments = 4;
  tree.nodes = {{.parent = 4},
                {.parent = 4},
                {.parent = 5},
                {.parent = 5},
                {.left = 0, .right = 1, .parent = 6},
                {.left = 2, .right = 3, .parent = 6},
                {.left = 4, .right = 5}};
  const LabelledScene labelled = scene.Labelled();
  const auto evidence = CollectEvidence(LookAtSegments(labelled, scene.segments, {}), tree);
  EXPECT_EQ(evidence[4].borders.Total(), 140);
  EXPECT_EQ(evidence[4].borders.Of(Beyond::kLevelSegment), 40);
  EXPECT_EQ(evidence[4].num_missing, 100);
  EXPECT_EQ(evidence[6].borders.Total(), 200);
  EXPECT_EQ(evidence[6].borders.Of(Beyond::kLevelSegment), 0);
  EXPECT_EQ(evidence[6].num_missing, 200);
}

TEST(CollectEvidence, KnowsTheJoinAround) {
  TestScene scene(2);
  const auto evidence = EvidenceOfPair(scene);
  EXPECT_EQ(evidence[0].outer_log_odds, 1.5);
  EXPECT_EQ(evidence[2].outer_log_odds, -6);
}

TEST(LookAtSegments, CountsWhatFacesUp) {
  TestScene scene(2);
  scene.Put({80, 40, 20, 30}, 1, 1);
  const LabelledScene labelled = scene.Labelled();
  std::vector<Voxel*> voxels;
  for (std::size_t v = 0; v < scene.segments.size(); ++v) {
    if (scene.segments[v] == 1) voxels.push_back(&scene.grid.voxels[v]);
  }
  voxels[0]->normal = labelled.up;
  voxels[1]->normal = {0, -0.95F, -0.31F};  // 18° from up
  voxels[2]->normal = {0, -0.8F, -0.6F};    // 37°
  EXPECT_EQ(LookAtSegments(labelled, scene.segments, {}).of_segments[0].placement.num_level, 2);
}

double Of(const ObjectTerms& terms, ObjectTerm term) {
  return terms[static_cast<std::size_t>(term)];
}

TEST(ObjectTerms, SayWhatTheEvidenceIs) {
  TestScene scene(1);
  const auto evidence = EvidenceOfPair(scene);
  const ObjectTerms terms = TermsOf(evidence[2]);
  EXPECT_NEAR(Of(terms, ObjectTerm::kArea), std::log(0.12), 1e-6);
  EXPECT_NEAR(Of(terms, ObjectTerm::kLargestExtent), std::log(0.39), 1e-4);
  EXPECT_NEAR(Of(terms, ObjectTerm::kHeight), std::log(0.29), 1e-4);
  EXPECT_NEAR(Of(terms, ObjectTerm::kDistance), 1, 1e-6);
  EXPECT_EQ(Of(terms, ObjectTerm::kClosed), 1);  // background rises behind all of its upper border
  EXPECT_EQ(Of(terms, ObjectTerm::kEndsAnywhere), 0);
  EXPECT_NEAR(Of(terms, ObjectTerm::kNumSegments), std::log(2), 1e-12);
  EXPECT_EQ(Of(terms, ObjectTerm::kOuterOdds), -6);
}

TEST(ObjectTerms, CountTheBorderByWhatIsBeyond) {
  TestScene scene(2);
  const auto evidence = EvidenceOfPair(scene);
  const ObjectTerms of_one = TermsOf(evidence[0]), of_both = TermsOf(evidence[2]);
  EXPECT_DOUBLE_EQ(Of(of_one, ObjectTerm::kFarther), 0.7);
  EXPECT_DOUBLE_EQ(Of(of_one, ObjectTerm::kLevelSegment), 0.3);
  EXPECT_EQ(Of(of_both, ObjectTerm::kFarther), 1);
  EXPECT_EQ(Of(of_both, ObjectTerm::kLevelSegment), 0);
  EXPECT_EQ(Of(of_both, ObjectTerm::kUnmeasured), 0);
}

}  // namespace
}  // namespace fovea
