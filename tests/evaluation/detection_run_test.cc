#include "tests/evaluation/detection_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "tests/support/labelled_frame.h"
#include "tests/support/random_scene.h"

namespace fovea::evaluation {
namespace {

SceneResult Result(int truth, int predicted, int matched, double overlap_f, double total_ms) {
  SceneResult result;
  result.scores.counts = {truth, predicted, matched, matched};
  result.scores.overlap.f = overlap_f;
  result.total_ms = total_ms;
  result.stage_times = {{"normals", total_ms / 2}, {"graph cut", total_ms / 4}};
  return result;
}

TEST(Summarize, PoolsObjectsAndAveragesScenes) {
  const Summary summary =
      Summarize({Result(4, 2, 2, 0.5, 10), Result(1, 2, 1, 1.0, 30), Result(5, 4, 3, 0.9, 20)});
  EXPECT_DOUBLE_EQ(summary.boxes.precision, 6.0 / 8);
  EXPECT_DOUBLE_EQ(summary.boxes.recall, 6.0 / 10);
  EXPECT_DOUBLE_EQ(summary.boxes.f, 2 * 0.75 * 0.6 / 1.35);
  EXPECT_DOUBLE_EQ(summary.overlap.f, 0.8);
  EXPECT_DOUBLE_EQ(summary.share_75, 0.6);
  EXPECT_DOUBLE_EQ(summary.median_ms, 20);
  ASSERT_EQ(summary.median_stage_ms.size(), 2U);
  EXPECT_EQ(summary.median_stage_ms[0].stage, "normals") << "the order of the pipeline";
  EXPECT_DOUBLE_EQ(summary.median_stage_ms[1].duration_ms, 5);
}

// Precision 1, 0.5, 1 (nothing predicted) and recall 0.5, 1, 0.
TEST(Summarize, AveragesBoxScoresOverImages) {
  const Score boxes =
      Summarize({Result(4, 2, 2, 0, 1), Result(1, 2, 1, 0, 1), Result(5, 0, 0, 0, 1)})
          .boxes_by_image;
  EXPECT_DOUBLE_EQ(boxes.precision, 2.5 / 3);
  EXPECT_DOUBLE_EQ(boxes.recall, 0.5);
  EXPECT_DOUBLE_EQ(boxes.f, 2 * (2.5 / 3) * 0.5 / (2.5 / 3 + 0.5));
}

TEST(Summarize, FoldsAreGroupsOfConsecutiveScenes) {
  const std::vector<SceneResult> results = {Result(1, 1, 1, 1, 1), Result(1, 1, 1, 1, 1),
                                            Result(1, 1, 0, 1, 1), Result(1, 1, 1, 1, 1)};
  const Summary summary = Summarize(results, 2);  // F1 of 1 and 0.5
  EXPECT_DOUBLE_EQ(summary.fold_mean, 0.75);
  EXPECT_DOUBLE_EQ(summary.fold_deviation, 0.25 * std::sqrt(2));
  EXPECT_DOUBLE_EQ(Summarize(results, 1).fold_mean, 0) << "one group has no spread";
}

TEST(PredictionsOfFolds, KeepScenesTogether) {
  std::vector<SceneResult> results(3);
  for (std::size_t i = 0; i < 3; ++i) results[i].predictions = {{0.25 * double(i), true}};
  const auto groups = PredictionsOfFolds(results, 2);
  ASSERT_EQ(groups.size(), 2U);
  ASSERT_EQ(groups[0].size(), 1U);
  ASSERT_EQ(groups[1].size(), 2U);
  EXPECT_EQ(groups[1][0].confidence, 0.25);
  EXPECT_EQ(PredictionsOfFolds(results, 0).size(), 1U);
  EXPECT_EQ(PredictionsOfFolds(results, 9).size(), 3U);
}

std::vector<Scene> TwoScenes() {
  std::vector<Scene> scenes;
  for (const std::uint64_t seed : {1, 2}) {
    const auto labelled = scenes::MakeFrame(scenes::RandomScene("tabletop", seed, {160, 120}),
                                            scenes::SensorKind::kIdeal, seed);
    scenes.push_back({"scene" + std::to_string(seed), labelled.frame, labelled.labels,
                      labelled.frame.depth_m == labelled.frame.depth_m});
  }
  return scenes;
}

TEST(RunDetection, KeepsTheOrderAndCallsBackOncePerScene) {
  std::multiset<std::string> done;
  const auto results =
      RunDetection(TwoScenes(), DetectWith(OptionsOfProfile("")), 2,
                   [&](const Scene& scene, const Detections&) { done.insert(scene.name); });
  ASSERT_EQ(results.size(), 2U);
  EXPECT_EQ(results[0].name, "scene1");
  EXPECT_EQ(results[1].name, "scene2");
  EXPECT_GT(results[0].scores.counts.truth, 0);
  EXPECT_EQ(std::ssize(results[0].predictions), results[0].scores.counts.predicted);
  EXPECT_EQ(std::count_if(results[0].predictions.begin(), results[0].predictions.end(),
                          [](const Prediction& prediction) { return prediction.correct; }),
            results[0].scores.counts.matched_boxes);
  EXPECT_EQ(done, (std::multiset<std::string>{"scene1", "scene2"}));
}

TEST(RunDetection, ScoresPeersByTheirLabels) {
  const auto results = RunDetection(TwoScenes(), DetectWithPeer("plane_clusters"), 1);
  EXPECT_GT(results[0].scores.counts.truth, 0);
  EXPECT_TRUE(results[0].stage_times.empty());
}

TEST(RunDetection, PassesFailuresOn) {
  std::vector<Scene> scenes = TwoScenes();
  scenes[1].frame.intrinsics.fx_px = -1;
  EXPECT_THROW(RunDetection(scenes, DetectWith(OptionsOfProfile("")), 2), std::invalid_argument);
}

// The shortest of each stage, whichever run it is of.
TEST(RunDetection, TakesTheShortestTimesOfItsRepeats) {
  int runs = 0;
  const auto detect = [&](const Scene& scene) {
    Detections detections;
    detections.labels = cv::Mat::zeros(scene.frame.depth_m.size(), CV_16UC1);
    const double k = ++runs;
    detections.stage_times = {{"normals", 10 + k}, {"seeds", 20 - k}};
    return detections;
  };
  const std::vector<Scene> scenes = {TwoScenes().front()};
  const SceneResult result = RunDetection(scenes, detect, 1, {}, 3).front();
  EXPECT_EQ(runs, 3);
  EXPECT_EQ(result.stage_times[0].duration_ms, 11);
  EXPECT_EQ(result.stage_times[1].duration_ms, 17);
}

}  // namespace
}  // namespace fovea::evaluation
