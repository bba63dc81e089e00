#include "tests/evaluation/kinship_samples.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>

#include "core/detector.h"
#include "core/segmentation/labels.h"
#include "core/segmentation/segment_graph.h"

namespace fovea::evaluation {
namespace {

constexpr double kMinPurity = 0.75;  // share of a segment's pixels that are of its object
constexpr double kSpeckPx = 100;     // segments of which nothing depends
constexpr double kSpeckWeight = 0.02;
constexpr double kBackgroundPx = 1500;      // from which background counts fully,
constexpr double kBackgroundWeight = 0.08;  // but for this much: it is most of many scenes
constexpr double kWholeShare = 0.5;         // of an object that is as good as all of it

// The pixels of a segment by object of the ground truth, 0 = none.
struct TruePixels {
  std::map<int, double> of_object;

  void Add(const TruePixels& other) {
    for (const auto& [object, count] : other.of_object) of_object[object] += count;
  }
  double Total() const {
    double total = 0;
    for (const auto& [object, count] : of_object) total += count;
    return total;
  }
  std::optional<int> Object() const {
    for (const auto& [object, count] : of_object) {
      if (count > kMinPurity * Total()) return object;
    }
    return std::nullopt;
  }
};

class Sampler {
 public:
  Sampler(const Scene& scene, const Trace& trace, const Eigen::Vector3f& up)
      : graph_(trace.voxels, trace.segments, trace.colors, scene.frame.intrinsics, up),
        pixels_(CountLabels(trace.segments) + 1) {
    const cv::Mat labels = LabelImage(trace.voxels, trace.segments);
    for (int row = 0; row < labels.rows; ++row) {
      for (int col = 0; col < labels.cols; ++col) {
        if (scene.valid.at<std::uint8_t>(row, col) == 0) continue;
        const int object = scene.truth.at<std::uint16_t>(row, col);
        ++area_px_[object];
        ++pixels_[labels.at<std::uint16_t>(row, col)].of_object[object];
      }
    }
  }

  std::vector<KinshipSample> Run() {
    for (const auto& [pair, kinship] : graph_.Pairs()) Take(pair, kinship);
    for (auto pair = MostLikelyRightPair(); pair; pair = MostLikelyRightPair()) {
      const auto [into, from] = *pair;
      graph_.Join(*pair);
      pixels_[into].Add(pixels_[from]);
      for (const auto& [other, kinship] : graph_.Pairs()) {
        if (other.first == into || other.second == into) Take(other, kinship);
      }
    }
    return std::move(samples_);
  }

 private:
  std::optional<SegmentPair> MostLikelyRightPair() const {
    std::optional<SegmentPair> best;
    double best_odds = 0;
    for (const auto& [pair, kinship] : graph_.Pairs()) {
      const auto object = pixels_[pair.first].Object();
      if (!object || object != pixels_[pair.second].Object()) continue;
      if (best && LogOdds(kinship) <= best_odds) continue;
      best = pair;
      best_odds = LogOdds(kinship);
    }
    return best;
  }

  double WeightOf(const TruePixels& segment) const {
    const double total = segment.Total();
    if (total <= kSpeckPx) return kSpeckWeight;
    const int object = *segment.Object();
    if (object == 0) return std::min(1.0, total / kBackgroundPx) * kBackgroundWeight;
    return std::min(1.0, total / (kWholeShare * area_px_.at(object)));
  }

  void Take(const SegmentPair& pair, const Kinship& kinship) {
    const TruePixels& a = pixels_[pair.first];
    const TruePixels& b = pixels_[pair.second];
    if (!a.Object() || !b.Object()) return;
    samples_.push_back(
        {kinship, a.Object() == b.Object(), WeightOf(a.Total() < b.Total() ? a : b)});
  }

  SegmentGraph graph_;
  std::vector<TruePixels> pixels_;  // of each segment
  std::map<int, double> area_px_;   // of each object
  std::vector<KinshipSample> samples_;
};

}  // namespace

std::vector<KinshipSample> SampleKinship(const Scene& scene, const DetectorOptions& options) {
  Trace trace;
  const Detections detections = Detect(scene.frame, options, &trace);
  return Sampler(scene, trace, -detections.gravity.direction).Run();
}

}  // namespace fovea::evaluation
