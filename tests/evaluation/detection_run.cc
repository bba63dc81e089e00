#include "tests/evaluation/detection_run.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <mutex>

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

void AddFolds(Summary& summary, const std::vector<SceneResult>& results, int num_folds) {
  const int folds = std::min<int>(num_folds, static_cast<int>(results.size()));
  if (folds < 2) return;
  std::vector<double> f1;
  for (int k = 0; k < folds; ++k) {
    ObjectCounts counts;
    const std::size_t end = results.size() * (k + 1) / folds;
    for (std::size_t i = results.size() * k / folds; i < end; ++i) {
      Add(counts, results[i].scores.counts);
    }
    f1.push_back(BoxScore(counts).f);
  }
  const Spread spread = SpreadOf(f1);
  summary.fold_mean = spread.mean;
  summary.fold_deviation = spread.deviation;
}

}  // namespace

DetectFunction DetectWith(const DetectorOptions& options) {
  return [options](const RgbdFrame& frame) { return Detect(frame, options); };
}

DetectFunction DetectWithPeer(const std::string& name) {
  return [name](const RgbdFrame& frame) {
    Detections detections;
    detections.labels = SegmentWithPeer(name, frame);
    return detections;
  };
}

std::vector<SceneResult> RunDetection(const std::vector<Scene>& scenes,
                                      const DetectFunction& detect, int num_threads,
                                      const SceneDone& done) {
  std::vector<SceneResult> results(scenes.size());
  std::mutex mutex;  // guards done
  ForEachIndex(scenes.size(), num_threads, [&](std::size_t i) {
    const auto start = std::chrono::steady_clock::now();
    const Detections detections = detect(scenes[i].frame);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    results[i] = {scenes[i].name, ScoreScene(scenes[i].truth, detections.labels, scenes[i].valid),
                  time.count(), detections.stage_times};
    const std::scoped_lock lock(mutex);
    if (done) done(scenes[i], detections);
  });
  return results;
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
  const ObjectCounts& counts = summary.counts;
  summary.share_75 = counts.truth > 0 ? double(counts.matched_75) / counts.truth : 1.0;
  summary.median_ms = Median(times);
  summary.median_stage_ms = MedianStages(results);
  AddFolds(summary, results, num_folds);
  return summary;
}

}  // namespace fovea::evaluation
