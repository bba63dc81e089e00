#include "tests/evaluation/tracking/frame_comparison.h"

#include <opencv2/core.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "tests/evaluation/regions.h"

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

}  // namespace

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

}  // namespace fovea::evaluation
