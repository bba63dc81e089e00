// Runs a detector over scenes and adds up how it did.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/detector.h"
#include "tests/evaluation/dataset.h"
#include "tests/evaluation/reliability.h"
#include "tests/evaluation/scores.h"

namespace fovea::evaluation {

struct SceneResult {
  std::string name;
  SceneScores scores;
  double total_ms = 0;  // wall time of detecting
  std::vector<StageTime> stage_times;
  std::vector<Prediction> predictions;  // those in sight of the ground truth; none of peers
};

// Called once per scene, one call at a time, from the thread that ran it.
using SceneDone = std::function<void(const Scene&, const Detections&)>;

using DetectFunction = std::function<Detections(const Scene&)>;

// Our detector.
DetectFunction DetectWith(const DetectorOptions& options);

// Another one, which fills Detections::labels only.
DetectFunction DetectWithPeer(const std::string& name);

// Profiles and peers.
std::vector<std::string> DetectionMethodNames();

// Detects in every scene, `num_threads` scenes at a time, and scores the answers. Results come in
// the order of `scenes`. Each scene is detected `num_repeats` times (at least once), of which the
// shortest times count. Throws what `detect` throws.
std::vector<SceneResult> RunDetection(const std::vector<Scene>& scenes,
                                      const DetectFunction& detect, int num_threads,
                                      const SceneDone& done = {}, int num_repeats = 1);

struct Summary {
  ObjectCounts counts;
  Score boxes;  // over all objects of all scenes
  // Mean precision and recall over the scenes, as MakeScore has them where a scene has no objects
  // or predictions, and F1 of the two.
  Score boxes_by_image;
  Score overlap;        // mean over the scenes
  Score boundary;       // mean over the scenes
  double share_75 = 0;  // of all true objects
  double median_ms = 0;
  std::vector<StageTime> median_stage_ms;  // in the order of the pipeline
  // Spread of the box F1 over groups of consecutive scenes; 0 with fewer than two groups.
  double fold_mean = 0;
  double fold_deviation = 0;
};

// The predictions of each of `num_folds` groups of consecutive scenes, of which there is at least
// one and not more than scenes.
std::vector<std::vector<Prediction>> PredictionsOfFolds(const std::vector<SceneResult>& results,
                                                        int num_folds);

Summary Summarize(const std::vector<SceneResult>& results, int num_folds = 0);

}  // namespace fovea::evaluation
