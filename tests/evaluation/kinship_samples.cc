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
    for (auto pair = MostLikelyPair(); pair; pair = MostLikelyPair()) {
      const Kinship kinship = graph_.Pairs().at(*pair);
      const auto [first, second] = *pair;
      const std::optional<int> a = pixels_[first].Object(), b = pixels_[second].Object();
      if (!a || !b || a != b) {
        refused_[*pair] = LogOdds(kinship);
        if (a && b) TakeLikelier(std::minmax(*a, *b), {kinship, false, WeightOf(*pair)});
        continue;
      }
      samples_.push_back({kinship, true, WeightOf(*pair)});
      graph_.Join(*pair);
      pixels_[first].Add(pixels_[second]);
    }
    for (const auto& [objects, sample] : of_two_objects_) samples_.push_back(sample);
    return std::move(samples_);
  }

 private:
  // Of those that are not refused as they are now.
  std::optional<SegmentPair> MostLikelyPair() const {
    std::optional<SegmentPair> best;
    double best_odds = 0;
    for (const auto& [pair, kinship] : graph_.Pairs()) {
      const double log_odds = LogOdds(kinship);
      const auto refused = refused_.find(pair);
      if (refused != refused_.end() && refused->second == log_odds) continue;
      if (best && log_odds <= best_odds) continue;
      best = pair;
      best_odds = log_odds;
    }
    return best;
  }

  double WeightOf(const SegmentPair& pair) const {
    const TruePixels& a = pixels_[pair.first];
    const TruePixels& b = pixels_[pair.second];
    const TruePixels& smaller = a.Total() < b.Total() ? a : b;
    const double total = smaller.Total();
    if (total <= kSpeckPx) return kSpeckWeight;
    const int object = *smaller.Object();
    if (object == 0) return std::min(1.0, total / kBackgroundPx) * kBackgroundWeight;
    return std::min(1.0, total / (kWholeShare * area_px_.at(object)));
  }

  void TakeLikelier(const std::pair<int, int>& objects, const KinshipSample& sample) {
    const auto [known, is_new] = of_two_objects_.try_emplace(objects, sample);
    if (!is_new && LogOdds(sample.kinship) > LogOdds(known->second.kinship)) known->second = sample;
  }

  SegmentGraph graph_;
  std::vector<TruePixels> pixels_;         // of each segment
  std::map<int, double> area_px_;          // of each object
  std::map<SegmentPair, double> refused_;  // log odds then; they change when either is joined
  std::map<std::pair<int, int>, KinshipSample> of_two_objects_;
  std::vector<KinshipSample> samples_;
};

}  // namespace

std::vector<KinshipSample> SampleKinship(const Scene& scene, const DetectorOptions& options) {
  Trace trace;
  const Detections detections = Detect(scene.frame, options, &trace);
  return Sampler(scene, trace, -detections.gravity.direction).Run();
}

}  // namespace fovea::evaluation
