#include "core/objects/describe_objects.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "core/objects/confidence.h"

namespace fovea {
namespace {

// Even of a tiny image, an object has more than noise does.
constexpr double kFewestPixels = 20;

using PixelsOfLabel = std::vector<std::vector<cv::Point>>;

PixelsOfLabel CollectPixels(const cv::Mat& labels) {
  double max_label = 0;
  cv::minMaxLoc(labels, nullptr, &max_label);
  PixelsOfLabel pixels(static_cast<std::size_t>(max_label) + 1);
  for (int row = 0; row < labels.rows; ++row) {
    const auto* label = labels.ptr<std::uint16_t>(row);
    for (int col = 0; col < labels.cols; ++col) {
      if (label[col] != 0) pixels[label[col]].emplace_back(col, row);
    }
  }
  return pixels;
}

void SetColoredCloud(const RgbdFrame& frame, const cv::Mat& points,
                     const std::vector<cv::Point>& pixels, DetectedObject& object) {
  std::array<double, 3> color_sum{};
  Eigen::Vector3d position_sum = Eigen::Vector3d::Zero();
  object.cloud.reserve(pixels.size());
  for (const cv::Point& pixel : pixels) {
    const cv::Vec3f& p = points.at<cv::Vec3f>(pixel);
    const cv::Vec3b& c = frame.color_rgb.at<cv::Vec3b>(pixel);
    object.cloud.push_back({p[0], p[1], p[2], c[0], c[1], c[2]});
    position_sum += Eigen::Vector3d(p[0], p[1], p[2]);
    for (int channel = 0; channel < 3; ++channel) color_sum[channel] += c[channel];
  }
  const double count = static_cast<double>(pixels.size());
  object.centroid = (position_sum / count).cast<float>();
  for (int channel = 0; channel < 3; ++channel) {
    object.mean_color[channel] = static_cast<std::uint8_t>(std::lround(color_sum[channel] / count));
  }
}

bool TouchesBorder(const cv::Rect& bounds, const cv::Size& image) {
  return bounds.x == 0 || bounds.y == 0 || bounds.br().x == image.width ||
         bounds.br().y == image.height;
}

float LowestHeight(const std::vector<Eigen::Vector3f>& positions, const SupportSurface& support) {
  float lowest = support.HeightOf(positions.front());
  for (const Eigen::Vector3f& p : positions) lowest = std::min(lowest, support.HeightOf(p));
  return lowest;
}

// The surface that most of the points are above: the highest one if there are several.
std::optional<SupportSurface> OwnSupport(const std::vector<Support>& supports,
                                         const std::vector<Eigen::Vector3f>& positions) {
  const auto is_below = [&](const Support& support) {
    const auto above = std::count_if(positions.begin(), positions.end(), [&](const auto& p) {
      return support.surface.HeightOf(p) > 0 && support.footprint.Covers(p);
    });
    return 2 * static_cast<std::size_t>(above) > positions.size();
  };
  std::optional<SupportSurface> highest;
  for (const Support& support : supports) {
    if (!is_below(support)) continue;
    const float height = support.surface.HeightOf(positions.front());
    if (!highest || height < highest->HeightOf(positions.front())) highest = support.surface;
  }
  if (!highest && !supports.empty()) return supports.front().surface;
  return highest;
}

DetectedObject Describe(const RgbdFrame& frame, const cv::Mat& points,
                        const std::vector<cv::Point>& pixels, const std::vector<Support>& supports,
                        const Eigen::Vector3f& gravity, const ObjectOptions& options) {
  DetectedObject object;
  object.bounds_px = cv::boundingRect(pixels);
  object.num_pixels = pixels.size();
  object.truncated = TouchesBorder(object.bounds_px, frame.depth_m.size());
  SetColoredCloud(frame, points, pixels, object);

  std::vector<Eigen::Vector3f> positions;
  for (const pcl::PointXYZRGB& p : object.cloud) positions.emplace_back(p.x, p.y, p.z);
  const std::optional<SupportSurface> support = OwnSupport(supports, positions);
  object.box =
      FitOrientedBox(positions, support ? support->normal : -gravity, support, options.box);
  if (support) object.height_above_support_m = LowestHeight(positions, *support);
  object.confidence = Confidence(object, frame.depth_m.size());
  object.grasps.push_back(GraspFromAbove(object.box, options.grasp));
  return object;
}

double VisibleArea_m2(const cv::Mat& points, const std::vector<cv::Point>& pixels,
                      const CameraIntrinsics& intrinsics) {
  double squares = 0;
  for (const cv::Point& pixel : pixels) {
    const double z = points.at<cv::Vec3f>(pixel)[2];
    squares += z * z;
  }
  return squares / (intrinsics.fx_px * intrinsics.fy_px);
}

float MeanOf(const cv::Mat& map, const std::vector<cv::Point>& pixels) {
  double sum = 0;
  for (const cv::Point& pixel : pixels) sum += map.at<float>(pixel);
  return static_cast<float>(sum / static_cast<double>(pixels.size()));
}

// Leaves the `max_objects` most salient of the labels, in their order; 0: all. `saliency`: one
// entry a label. Returns how many it drops.
std::size_t KeepMostSalient(const std::vector<float>& saliency, int max_objects,
                            std::vector<int>& labels) {
  const auto limit = static_cast<std::size_t>(max_objects);
  if (limit == 0 || labels.size() <= limit) return 0;
  std::vector<int> by_saliency = labels;
  std::stable_sort(by_saliency.begin(), by_saliency.end(),
                   [&](int a, int b) { return saliency[a] > saliency[b]; });
  by_saliency.resize(limit);
  return std::erase_if(labels, [&](int label) {
    return std::find(by_saliency.begin(), by_saliency.end(), label) == by_saliency.end();
  });
}

// Old labels of the objects to keep, in their new order: larger first, which is also the order of
// confidence.
template <typename IsLargeEnough>
std::vector<int> LabelsToKeep(const PixelsOfLabel& pixels, IsLargeEnough is_large_enough,
                              std::size_t& num_too_small) {
  std::vector<int> kept;
  for (int label = 1; label < static_cast<int>(pixels.size()); ++label) {
    if (pixels[label].empty()) continue;
    if (is_large_enough(pixels[label])) {
      kept.push_back(label);
    } else {
      ++num_too_small;
    }
  }
  std::stable_sort(kept.begin(), kept.end(),
                   [&](int a, int b) { return pixels[a].size() > pixels[b].size(); });
  return kept;
}

}  // namespace

void DescribeObjects(const RgbdFrame& frame, const cv::Mat& points, const cv::Mat& saliency,
                     const std::vector<Support>& supports, const ObjectOptions& options,
                     Detections& detections) {
  const PixelsOfLabel pixels = CollectPixels(detections.labels);
  const double area_scale = static_cast<double>(frame.depth_m.total()) / (640.0 * 480.0);
  const auto min_pixels = static_cast<std::size_t>(
      std::max(kFewestPixels, std::round(options.min_pixels * area_scale)));
  const auto is_large_enough = [&](const std::vector<cv::Point>& mask) {
    return mask.size() >= min_pixels &&
           VisibleArea_m2(points, mask, frame.intrinsics) >= options.min_area_m2;
  };
  Diagnostics& counts = detections.diagnostics;
  std::vector<int> kept = LabelsToKeep(pixels, is_large_enough, counts.segments_too_small);
  std::vector<float> saliency_of_label(pixels.size(), 0);
  for (const int label : kept) saliency_of_label[label] = MeanOf(saliency, pixels[label]);
  counts.objects_less_salient = KeepMostSalient(saliency_of_label, options.max_objects, kept);

  detections.labels = cv::Mat::zeros(frame.depth_m.size(), CV_16UC1);
  for (const int old_label : kept) {
    DetectedObject object =
        Describe(frame, points, pixels[old_label], supports, detections.gravity.direction, options);
    object.saliency = saliency_of_label[old_label];
    object.label = static_cast<int>(detections.objects.size()) + 1;
    for (const cv::Point& pixel : pixels[old_label]) {
      detections.labels.at<std::uint16_t>(pixel) = static_cast<std::uint16_t>(object.label);
    }
    detections.objects.push_back(std::move(object));
  }
}

}  // namespace fovea
