#include "tests/evaluation/object_figures/relation_counts.h"

#include <gtest/gtest.h>

namespace fovea::evaluation {
namespace {

// Three answers, of which the first two are the true objects 2 and 1; the last is none.
GeneratedFrame ThreeAnswers() {
  GeneratedFrame frame;
  frame.detections.objects.resize(3);
  for (int i = 0; i < 3; ++i) frame.detections.objects[static_cast<std::size_t>(i)].label = i + 1;
  frame.matches = {{.truth = 1, .answer = 0, .visible_share = 1, .what = ""},
                   {.truth = 0, .answer = 1, .visible_share = 1, .what = ""}};
  return frame;
}

TEST(RelationCounts, AreOfMatchedObjects) {
  GeneratedFrame frame = ThreeAnswers();
  frame.detections.objects[0].stands_on = {2, 3};
  frame.detections.objects[2].stands_on = {1};
  ObjectRun run;
  AddRelations(frame, {{}, {1, 3}}, run);
  EXPECT_EQ(run.on_objects.truth, 1);
  EXPECT_EQ(run.on_objects.answered, 1);
  EXPECT_EQ(run.on_objects.right, 1);
  EXPECT_EQ(run.stands_right, 2);
}

TEST(RelationCounts, OfWhatLeansAreOfMatchedObjects) {
  GeneratedFrame frame = ThreeAnswers();
  frame.detections.objects[0].leans_on = {2, 3};
  frame.detections.objects[2].leans_on = {1};
  scenes::LeaningThing truth;
  truth.label = 2;
  truth.against = 1;
  Relations leaning;
  AddLeaning(truth, frame, leaning);
  EXPECT_EQ(leaning.truth, 1);
  EXPECT_EQ(leaning.answered, 1);
  EXPECT_EQ(leaning.right, 1);
}

TEST(RelationCounts, KnowWhatDoesNotTrulyLean) {
  GeneratedFrame frame = ThreeAnswers();
  frame.detections.objects[1].leans_on = {1};
  Relations leaning;
  AddLeaning(std::nullopt, frame, leaning);
  EXPECT_EQ(leaning.truth, 0);
  EXPECT_EQ(leaning.answered, 1);
  EXPECT_EQ(leaning.right, 0);
}

}  // namespace
}  // namespace fovea::evaluation
