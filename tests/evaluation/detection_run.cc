#include "tests/evaluation/detection_run.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <mutex>
#include <span>
#include <utility>

#include "tests/evaluation/parallel.h"
#include "tests/evaluation/peers/peer.h"
#include "tests/evaluation/statistics.h"

namespace fovea::evaluation {
namespace {

void Add(ObjectCounts& sum, const ObjectCounts& counts) {
  sum.truth += counts.truth;
  sum.predicted += counts.predicted;
  sum.matched_boxes += counts.matched_boxes;
  sum.matched_75 += counts.matched_75;
}

void AddShare(Score& mean, const Score& score, std::size_t count) {
  mean.precision += score.precision / static_cast<double>(count);
  mean.recall += score.recall / static_cast<double>(count);
  mean.f += score.f / static_cast<double>(count);
}

Score BoxScore(const ObjectCounts& counts) {
  return MakeScore(counts.matched_boxes, counts.predicted, counts.matched_boxes, counts.truth);
}

Score MeanBoxScore(const std::vector<SceneResult>& results) {
  Score mean;
  for (const SceneResult& result : results) {
    AddShare(mean, BoxScore(result.scores.counts), results.size());
  }
  const double sum = mean.precision + mean.recall;
  mean.f = sum > 0 ? 2 * mean.precision * mean.recall / sum : 0;
  return mean;
}

std::vector<StageTime> MedianStages(const std::vector<SceneResult>& results) {
  std::vector<std::string> order;
  std::map<std::string, std::vector<double>> times;
  for (const SceneResult& result : results) {
    for (const StageTime& time : result.stage_times) {
      if (!times.contains(time.stage)) order.push_back(time.stage);
      times[time.stage].push_back(time.duration_ms);
    }
  }
  std::vector<StageTime> medians;
  medians.reserve(order.size());
  for (const std::string& stage : order) medians.push_back({stage, Median(times[stage])});
  return medians;
}

// Group k of `folds` groups of consecutive scenes.
std::span<const SceneResult> Fold(const std::vector<SceneResult>& results, int k, int folds) {
  const std::size_t begin = results.size() * k / folds, end = results.size() * (k + 1) / folds;
  return std::span(results).subspan(begin, end - begin);
}

struct Timed {
  Detections detections;  // each stage's time is its shortest
  double total_ms = 0;    // likewise
};

Timed DetectTimed(const DetectFunction& detect, const Scene& scene, int num_repeats) {
  Timed best;
  for (int k = 0; k < num_repeats; ++k) {
    const auto start = std::chrono::steady_clock::now();
    Detections detections = detect(scene);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    for (std::size_t i = 0; i < best.detections.stage_times.size(); ++i) {
      double& duration_ms = detections.stage_times.at(i).duration_ms;
      duration_ms = std::min(duration_ms, best.detections.stage_times[i].duration_ms);
    }
    best = {std::move(detections), k == 0 ? time.count() : std::min(best.total_ms, time.count())};
  }
  return best;
}

std::vector<Prediction> Judge(const Detections& detections, const SceneScores& scores) {
  std::vector<Prediction> predictions;
  for (const DetectedObject& object : detections.objects) {
    const auto found = scores.box_matched.find(object.label);
    if (found != scores.box_matched.end()) {
      predictions.push_back({object.confidence, found->second});
    }
  }
  return predictions;
}

void AddFolds(Summary& summary, const std::vector<SceneResult>& results, int num_folds) {
  const int folds = std::min<int>(num_folds, static_cast<int>(results.size()));
  if (folds < 2) return;
  std::vector<double> f1;
  for (int k = 0; k < folds; ++k) {
    ObjectCounts counts;
    for (const SceneResult& result : Fold(results, k, folds)) Add(counts, result.scores.counts);
    f1.push_back(BoxScore(counts).f);
  }
  const Spread spread = SpreadOf(f1);
  summary.fold_mean = spread.mean;
  summary.fold_deviation = spread.deviation;
}

}  // namespace

DetectFunction DetectWith(const DetectorOptions& options) {
  return [options](const Scene& scene) { return Detect(scene.frame, options); };
}

DetectFunction DetectWithPeer(const std::string& name) {
  return [name](const Scene& scene) {
    Detections detections;
    detections.labels = SegmentWithPeer(name, scene.frame);
    return detections;
  };
}

std::vector<std::string> DetectionMethodNames() {
  std::vector<std::string> names = ProfileNames();
  for (const std::string& peer : PeerNames()) names.push_back(peer);
  return names;
}

std::vector<SceneResult> RunDetection(const std::vector<Scene>& scenes,
                                      const DetectFunction& detect, int num_threads,
                                      const SceneDone& done, int num_repeats) {
  std::vector<SceneResult> results(scenes.size());
  std::mutex mutex;  // guards done
  ForEachIndex(scenes.size(), num_threads, [&](std::size_t i) {
    const Timed timed = DetectTimed(detect, scenes[i], num_repeats);
    const SceneScores scores =
        ScoreScene(scenes[i].truth, timed.detections.labels, scenes[i].valid);
    results[i] = {scenes[i].name, scores, timed.total_ms, timed.detections.stage_times,
                  Judge(timed.detections, scores)};
    const std::scoped_lock lock(mutex);
    if (done) done(scenes[i], timed.detections);
  });
  return results;
}

std::vector<std::vector<Prediction>> PredictionsOfFolds(const std::vector<SceneResult>& results,
                                                        int num_folds) {
  const int folds = std::clamp<int>(num_folds, 1, std::max<int>(1, results.size()));
  std::vector<std::vector<Prediction>> groups(folds);
  for (int k = 0; k < folds; ++k) {
    for (const SceneResult& result : Fold(results, k, folds)) {
      groups[k].insert(groups[k].end(), result.predictions.begin(), result.predictions.end());
    }
  }
  return groups;
}

Summary Summarize(const std::vector<SceneResult>& results, int num_folds) {
  Summary summary;
  std::vector<double> times;
  for (const SceneResult& result : results) {
    Add(summary.counts, result.scores.counts);
    AddShare(summary.overlap, result.scores.overlap, results.size());
    AddShare(summary.boundary, result.scores.boundary, results.size());
    times.push_back(result.total_ms);
  }
  summary.boxes = BoxScore(summary.counts);
  summary.boxes_by_image = MeanBoxScore(results);
  const ObjectCounts& counts = summary.counts;
  summary.share_75 = counts.truth > 0 ? double(counts.matched_75) / counts.truth : 1.0;
  summary.median_ms = Median(times);
  summary.median_stage_ms = MedianStages(results);
  AddFolds(summary, results, num_folds);
  return summary;
}

}  // namespace fovea::evaluation
