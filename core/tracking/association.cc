#include "core/tracking/association.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/tracking/assignment.h"
#include "core/types/interruption.h"
#include "core/types/projection.h"

namespace fovea {
namespace {

// Of the confidence, which is a probability: the others are mistakes as often as not.
constexpr float kConfident = 0.5F;
// CIELAB: the mean colour of one thing rarely changes by more, with light and what is seen of it.
constexpr float kFarColor = 40;
constexpr float kFarSize = 4;
constexpr double kLongestReach_s = 0.5;
constexpr double kErrorsInReach = 3;
constexpr double kSlack_m = 0.01;  // beside which distances and sizes count
constexpr double kColorWeight = 0.5, kSizeWeight = 0.5;
constexpr double kMaxCost = 1.6;

// At least one pixel, however near or small it is.
double AreaPx(const Sighting& sighting, const CameraIntrinsics& k) {
  const double z = std::max(0.01F, sighting.centroid.z());
  return std::max(1.0, sighting.visible_m2 * k.fx_px * k.fy_px / (z * z));
}

// How many of the track's points the camera now sees in the mask of each label.
using Coverage = std::unordered_map<int, int>;

Coverage CoverageOf(const Sighting& track, const AssociationFrame& frame) {
  Coverage coverage;
  const cv::Rect2d image(-0.5, -0.5, frame.labels.cols, frame.labels.rows);
  for (const Eigen::Vector3f& point : track.points) {
    if (!(point.z() > 0)) continue;
    const cv::Point2d pixel = Project(point, frame.intrinsics);
    if (!image.contains(pixel)) continue;
    const int label = frame.labels.at<std::uint16_t>(cvRound(pixel.y), cvRound(pixel.x));
    if (label != 0) ++coverage[label];
  }
  return coverage;
}

double OverlapOf(const Coverage& coverage, const Sighting& track, const Sighting& detection,
                 const AssociationFrame& frame) {
  const auto found = coverage.find(detection.label);
  if (found == coverage.end()) return 0;
  const double share =
      static_cast<double>(found->second) / static_cast<double>(track.points.size());
  const double track_px = AreaPx(track, frame.intrinsics);
  const double detection_px = AreaPx(detection, frame.intrinsics);
  const double smaller_px = std::min(track_px, detection_px);
  const double common_px = std::min(share * track_px, smaller_px);
  return common_px / 2 * (1 / (track_px + detection_px - common_px) + 1 / smaller_px);
}

// How much speaks against the two being one thing: 0 (nothing) to kMaxCost, the same where they are
// out of each other's reach. The sum of
// - 1 - overlap of the track's points, seen by this camera, with the detection's mask (as areas;
//   half of it is intersection over union, half the share of the smaller one, which is 1 where
//   one of them is partly hidden),
// - the distance of their middles or centroids in space, whichever is nearer, beside half their
//   size and the motion's error,
// - difference of mean colours, beside kFarColor,
// - ratio of their sizes, beside kFarSize, on a logarithmic scale.
// `expected`: of the track, as it was seen last or as most of it was; what is likelier counts.
// What was taken away comes back in its own colour: another one in its place is something else.
double CostOf(const Track& track, const Sighting& expected, const Coverage& coverage,
              const Sighting& detection, const AssociationFrame& frame) {
  const double distance_m = std::min((expected.centroid - detection.centroid).norm(),
                                     (expected.box.center - detection.box.center).norm());
  const double half_size_m = 0.25 * (expected.box.size_m.norm() + detection.box.size_m.norm());
  const double reach_m = half_size_m + kErrorsInReach * frame.camera_error_m +
                         kFastest_m_s * std::min(track.seconds_hidden(), kLongestReach_s);
  if (!(distance_m < reach_m)) return kMaxCost;
  const double color = (expected.lab - detection.lab).norm() / kFarColor;
  if (track.was_gone() && color > 1) return kMaxCost;
  const double overlap = OverlapOf(coverage, expected, detection, frame);
  const double ratio =
      (detection.box.size_m.norm() + kSlack_m) / (expected.box.size_m.norm() + kSlack_m);
  const double size = std::abs(std::log(ratio)) / std::log(kFarSize);
  const double cost = 1 - overlap + distance_m / (half_size_m + frame.camera_error_m + kSlack_m) +
                      kColorWeight * std::min(1.0, color) + kSizeWeight * std::min(1.0, size);
  return std::min(cost, kMaxCost);
}

struct Matching {
  const Eigen::MatrixXd gains;  // detections × tracks, 0 = none
  std::vector<int> track_of_detection;
  std::vector<char> is_taken;  // of the tracks

  // Matches what is let in and not matched yet.
  template <typename LetDetection>
  void Pass(const LetDetection& let_detection) {
    Eigen::MatrixXd open = gains;
    for (Eigen::Index d = 0; d < open.rows(); ++d) {
      if (track_of_detection[d] >= 0 || !let_detection(d)) open.row(d).setZero();
    }
    for (Eigen::Index t = 0; t < open.cols(); ++t) {
      if (is_taken[t] != 0) open.col(t).setZero();
    }
    const std::vector<int> columns = MaximumAssignment(open);
    for (std::size_t d = 0; d < columns.size(); ++d) {
      const int t = columns[d];
      if (t < 0 || open(static_cast<Eigen::Index>(d), t) <= 0) continue;
      track_of_detection[d] = t;
      is_taken[t] = 1;
    }
  }
};

Eigen::MatrixXd GainsOf(const std::vector<Track>& tracks, const std::vector<Sighting>& detections,
                        const AssociationFrame& frame) {
  Eigen::MatrixXd gains = Eigen::MatrixXd::Zero(detections.size(), tracks.size());
  for (Eigen::Index t = 0; t < gains.cols(); ++t) {
    InterruptionPoint();
    for (const Sighting* expected : {&tracks[t].expected(), &tracks[t].fullest()}) {
      const Coverage coverage = CoverageOf(*expected, frame);
      for (Eigen::Index d = 0; d < gains.rows(); ++d) {
        const double cost = CostOf(tracks[t], *expected, coverage, detections[d], frame);
        gains(d, t) = std::max(gains(d, t), kMaxCost - cost);
      }
    }
  }
  return gains;
}

}  // namespace

std::vector<int> Associate(const std::vector<Track>& tracks,
                           const std::vector<Sighting>& detections, const AssociationFrame& frame) {
  Matching matching{GainsOf(tracks, detections, frame), std::vector<int>(detections.size(), -1),
                    std::vector<char>(tracks.size(), 0)};
  const auto is_confident = [&](Eigen::Index d) { return detections[d].confidence >= kConfident; };
  matching.Pass(is_confident);
  matching.Pass([](Eigen::Index) { return true; });
  return matching.track_of_detection;
}

}  // namespace fovea
