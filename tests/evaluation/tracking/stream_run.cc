#include "tests/evaluation/tracking/stream_run.h"

#include <algorithm>
#include <chrono>
#include <opencv2/core.hpp>
#include <optional>
#include <utility>

#include "core/detector.h"
#include "core/tracking/tracker.h"
#include "tests/evaluation/regions.h"
#include "tests/support/labelled_frame.h"
#include "tests/support/random.h"

namespace fovea::evaluation {
namespace {

// CV_8UC1, 255 where depth was measured.
cv::Mat IsMeasured(const scenes::LabelledFrame& truth) {
  return truth.frame.depth_m == truth.frame.depth_m;
}

std::optional<ObjectTrack> TrackOf(int label, const Detections& found) {
  for (const DetectedObject& object : found.objects) {
    if (object.label == label) return object.track;
  }
  return std::nullopt;
}

// The truth as an answer: masks where there is depth, and boxes of the visible points along the
// camera's axes.
Detections TrueDetections(const scenes::LabelledFrame& truth) {
  Detections detections;
  detections.labels = truth.labels.clone();
  detections.labels.setTo(0, ~IsMeasured(truth));
  const CameraIntrinsics& k = truth.frame.intrinsics;
  for (const Region& region : Regions(detections.labels)) {
    DetectedObject object;
    object.label = region.label;
    object.confidence = 1;
    object.bounds_px = region.bounds;
    object.num_pixels = region.num_pixels;
    Eigen::Vector3f low, high, sum = Eigen::Vector3f::Zero(), color = Eigen::Vector3f::Zero();
    low.setConstant(1e9F);
    high = -low;
    for (int y = region.bounds.y; y < region.bounds.br().y; ++y) {
      for (int x = region.bounds.x; x < region.bounds.br().x; ++x) {
        if (detections.labels.at<std::uint16_t>(y, x) != region.label) continue;
        const float z = truth.frame.depth_m.at<float>(y, x);
        const Eigen::Vector3f p(static_cast<float>((x - k.cx_px) / k.fx_px) * z,
                                static_cast<float>((y - k.cy_px) / k.fy_px) * z, z);
        const cv::Vec3b& c = truth.frame.color_rgb.at<cv::Vec3b>(y, x);
        object.cloud.push_back({p.x(), p.y(), p.z(), c[0], c[1], c[2]});
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
        sum += p;
        color += Eigen::Vector3f(c[0], c[1], c[2]);
      }
    }
    const auto count = static_cast<float>(region.num_pixels);
    object.centroid = sum / count;
    object.box.center = (low + high) / 2;
    object.box.size_m = high - low;
    for (int c = 0; c < 3; ++c) object.mean_color[c] = static_cast<std::uint8_t>(color(c) / count);
    detections.objects.push_back(std::move(object));
  }
  return detections;
}

// `found`: with tracks.
TrackFrame Compare(const scenes::LabelledFrame& truth, const Detections& found) {
  cv::Mat true_labels = truth.labels.clone(), labels = found.labels;
  true_labels.setTo(0, ~IsMeasured(truth) & (labels == 0));
  const std::vector<Region> things = Regions(true_labels), masks = Regions(labels);
  const Eigen::MatrixXd common = Intersections(true_labels, things, labels, masks);
  std::vector<Eigen::Index> rows, columns;
  TrackFrame frame;
  for (Eigen::Index i = 0; i < common.rows(); ++i) {
    if (things[i].num_pixels < kFewestPixels) continue;
    rows.push_back(i);
    frame.things.push_back(things[i].label);
  }
  for (Eigen::Index j = 0; j < common.cols(); ++j) {
    double ignored = 0;
    for (Eigen::Index i = 0; i < common.rows(); ++i) {
      if (things[i].num_pixels < kFewestPixels) ignored += common(i, j);
    }
    const auto track = TrackOf(masks[j].label, found);
    if (2 * ignored > masks[j].num_pixels || !track) continue;
    columns.push_back(j);
    frame.tracks.push_back(track->id);
  }
  frame.similarity.resize(rows.size(), columns.size());
  for (std::size_t a = 0; a < rows.size(); ++a) {
    for (std::size_t b = 0; b < columns.size(); ++b) {
      const double both = common(rows[a], columns[b]);
      frame.similarity(a, b) =
          both / (things[rows[a]].num_pixels + masks[columns[b]].num_pixels - both);
    }
  }
  return frame;
}

Eigen::Isometry3d Measured(const Eigen::Isometry3d& pose, scenes::Random& random) {
  const auto vector = [&] {
    return Eigen::Vector3d(random.Normal(), random.Normal(), random.Normal());
  };
  const Eigen::Vector3d turn = 0.05 * 3.14159 / 180 / std::sqrt(3) * vector();
  return pose * Eigen::Translation3d(0.001 / std::sqrt(3) * vector()) *
         Eigen::AngleAxisd(turn.norm(), turn.normalized());
}

// The track on the thing in a frame, if any.
std::optional<std::uint64_t> TrackOn(std::uint64_t thing, const TrackFrame& frame) {
  for (std::size_t i = 0; i < frame.things.size(); ++i) {
    if (frame.things[i] != thing || frame.tracks.empty()) continue;
    Eigen::Index best = 0;
    const double similarity = frame.similarity.row(static_cast<Eigen::Index>(i)).maxCoeff(&best);
    if (similarity >= 0.5) return frame.tracks[best];
  }
  return std::nullopt;
}

void JudgeCovered(int thing, TrackedStream& stream) {
  std::optional<std::uint64_t> before, after;
  bool is_away = false;
  for (const TrackFrame& frame : stream.frames) {
    const bool is_seen = std::count(frame.things.begin(), frame.things.end(), thing) > 0;
    if (!is_seen && before) is_away = true;
    const auto track = TrackOn(thing, frame);
    if (track && !is_away) before = track;
    if (track && is_away && !after) after = track;
  }
  stream.was_covered = is_away && after;
  stream.is_same_after = stream.was_covered && *before == *after;
}

}  // namespace

std::array<TrackedStream, 2> TrackStream(const StreamSpec& spec, const DetectorOptions& options,
                                         Masks masks) {
  const Stream stream = RandomStream(spec.motion, spec.kind, spec.seed);
  scenes::Random random(spec.seed);
  std::array<Tracker, 2> trackers = {Tracker(1), Tracker(1)};
  std::array<TrackedStream, 2> results;
  for (std::size_t i = 0; i < stream.frames.size(); ++i) {
    const scenes::Scene& scene = stream.frames[i];
    const scenes::LabelledFrame truth = MakeFrame(scene, spec.sensor, spec.seed * 1000 + i);
    const Detections detections =
        masks == Masks::kTrue ? TrueDetections(truth) : Detect(truth.frame, options);
    const std::int32_t tenths = static_cast<std::int32_t>(i % 10);
    FrameContext context;
    context.captured_at =
        CaptureTime{1'000'000 + static_cast<std::int64_t>(i / 10), tenths * 100'000'000};
    context.camera_pose = Measured(scene.camera.world_from_camera, random);
    for (const Poses poses : {Poses::kGiven, Poses::kNone}) {
      const auto k = static_cast<std::size_t>(poses);
      if (poses == Poses::kNone) context.camera_pose.reset();
      Detections found = detections;
      const auto began = std::chrono::steady_clock::now();
      trackers[k].Add(truth.frame, context, found);
      const std::chrono::duration<double, std::milli> took =
          std::chrono::steady_clock::now() - began;
      results[k].times_ms.push_back(took.count());
      ++results[k].motion_sources[found.tracking->motion.source];
      results[k].frames.push_back(Compare(truth, found));
    }
  }
  for (TrackedStream& result : results) {
    if (stream.covered != 0) JudgeCovered(stream.covered, result);
  }
  return results;
}

}  // namespace fovea::evaluation
