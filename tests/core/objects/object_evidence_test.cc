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
  tree.num_likely = 3;
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

TEST(CollectEvidence, KnowsTheJoinsWithinAndAround) {
  TestScene scene(2);
  const auto evidence = EvidenceOfPair(scene);
  EXPECT_EQ(evidence[0].inner_log_odds, 0);
  EXPECT_EQ(evidence[0].outer_log_odds, 1.5);
  EXPECT_FALSE(evidence[0].is_likely);
  EXPECT_EQ(evidence[2].inner_log_odds, 1.5);
  EXPECT_EQ(evidence[2].outer_log_odds, -6);
  EXPECT_TRUE(evidence[2].is_likely);
}

TEST(CollectEvidence, KnowsWhatLiesUnderASupport) {
  TestScene scene(2);
  const SupportSurface above{-Eigen::Vector3f::UnitY(), -0.5F, 1};  // half a metre up
  scene.supports = {{above, Footprint()}};
  const auto evidence = EvidenceOfPair(scene);
  EXPECT_EQ(evidence[2].placement.num_covered, 1200);
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
  EXPECT_EQ(Of(terms, ObjectTerm::kGoesOn), 1);
  EXPECT_EQ(Of(terms, ObjectTerm::kStands), 1);
  EXPECT_EQ(Of(terms, ObjectTerm::kLevelShare), 1);
  EXPECT_EQ(Of(terms, ObjectTerm::kEndsAnywhere), 0);
  EXPECT_EQ(Of(terms, ObjectTerm::kAlone), 0);
  EXPECT_NEAR(Of(terms, ObjectTerm::kNumSegments), std::log(2), 1e-12);
  EXPECT_EQ(Of(terms, ObjectTerm::kInnerOdds), 1.5);
  EXPECT_EQ(Of(terms, ObjectTerm::kOuterOdds), -6);
}

}  // namespace
}  // namespace fovea
