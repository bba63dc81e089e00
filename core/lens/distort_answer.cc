#include "core/lens/distort_answer.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "core/objects/color_names.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

// The rectangle of the sent image around what this one of the ideal image holds; not empty.
cv::Rect DistortRect(const Lens& lens, const cv::Rect& ideal) {
  const cv::Size size = lens.size();
  const auto sent = [&](int x, int y) {
    const cv::Point2d pixel = lens.Distort(cv::Point2d(x, y));
    return cv::Point(cvRound(std::clamp(pixel.x, 0.0, size.width - 1.0)),
                     cvRound(std::clamp(pixel.y, 0.0, size.height - 1.0)));
  };
  const cv::Point last = ideal.br() - cv::Point(1, 1);
  std::vector<cv::Point> border;
  for (int x = ideal.x; x <= last.x; ++x) {
    border.push_back(sent(x, ideal.y));
    border.push_back(sent(x, last.y));
  }
  for (int y = ideal.y; y <= last.y; ++y) {
    border.push_back(sent(ideal.x, y));
    border.push_back(sent(last.x, y));
  }
  return cv::boundingRect(border);
}

// Calls visit(sent pixel, ideal pixel) once, row by row, for each sent pixel that is not 0 in
// `where` (CV_8UC1) and sees something of the ideal image.
template <typename Visit>
void ForEachSeen(const Lens& lens, const cv::Mat& where, Visit visit) {
  const cv::Rect image({0, 0}, lens.size());
  for (int y = 0; y < where.rows; ++y) {
    InterruptionPoint();
    const auto* is_wanted = where.ptr<std::uint8_t>(y);
    cv::Point2d off(0, 0);  // of the pixel before
    for (int x = 0; x < where.cols; ++x) {
      if (is_wanted[x] == 0) {
        off = {0, 0};
        continue;
      }
      const cv::Point2d pixel(x, y), ideal = lens.Undistort(pixel, pixel + off);
      if (std::isnan(ideal.x)) {
        off = {0, 0};
        continue;
      }
      off = ideal - pixel;
      const cv::Point nearest = ideal;  // rounds
      if (image.contains(nearest)) visit(cv::Point(x, y), nearest);
    }
  }
}

// The place of each labelled pixel in row-major order among those of its label.
cv::Mat OrderInMasks(const cv::Mat& labels) {
  cv::Mat order(labels.size(), CV_32SC1);
  std::vector<int> next(std::size_t{1} << 16, 0);
  for (int row = 0; row < labels.rows; ++row) {
    const auto* label = labels.ptr<std::uint16_t>(row);
    for (int col = 0; col < labels.cols; ++col) {
      if (label[col] != 0) order.at<int>(row, col) = next[label[col]]++;
    }
  }
  return order;
}

// What the camera shows of an object.
struct Shown {
  cv::Rect bounds_px;
  std::size_t num_pixels = 0;
  std::vector<ColoredPoint> cloud;
};

void SetShown(Shown&& shown, DetectedObject& object) {
  object.bounds_px = shown.bounds_px;
  object.num_pixels = shown.num_pixels;
  object.cloud = std::move(shown.cloud);
  if (object.cloud.empty()) return;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(), color_sum = sum;
  for (const ColoredPoint& p : object.cloud) {
    sum += Eigen::Vector3d(p.x, p.y, p.z);
    color_sum += Eigen::Vector3d(p.r, p.g, p.b);
  }
  const auto count = static_cast<double>(object.cloud.size());
  object.centroid = (sum / count).cast<float>();
  for (int i = 0; i < 3; ++i) {
    object.mean_color[i] = static_cast<std::uint8_t>(std::lround(color_sum[i] / count));
  }
  object.colors = ColorPartsOf(object.cloud);
}

// Each sent pixel is looked at once, for all objects, so that masks and clouds are of the same
// ones.
void DistortObjects(const Lens& lens, Detections& detections) {
  const cv::Mat ideal_labels = detections.labels, order = OrderInMasks(ideal_labels);
  cv::Mat may_show = cv::Mat::zeros(lens.size(), CV_8UC1);
  std::vector<Shown> shown(detections.objects.size());
  for (DetectedObject& object : detections.objects) {
    // Between its border and the pixels beside it some may be nearest to the border.
    may_show(DistortRect(lens, object.bounds_px + cv::Size(2, 2) - cv::Point(1, 1))) = 255;
    object.bounds_px = DistortRect(lens, object.bounds_px);
  }
  cv::Mat labels = cv::Mat::zeros(lens.size(), CV_16UC1);
  ForEachSeen(lens, may_show, [&](const cv::Point& sent, const cv::Point& ideal) {
    const std::uint16_t label = ideal_labels.at<std::uint16_t>(ideal);
    if (label == 0) return;
    labels.at<std::uint16_t>(sent) = label;
    Shown& of_it = shown[label - 1U];
    of_it.bounds_px |= cv::Rect(sent, cv::Size(1, 1));
    ++of_it.num_pixels;
    const std::vector<ColoredPoint>& cloud = detections.objects[label - 1U].cloud;
    const auto point = static_cast<std::size_t>(order.at<int>(ideal));
    if (point < cloud.size()) of_it.cloud.push_back(cloud[point]);
  });
  detections.labels = labels;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (shown[i].num_pixels == 0) shown[i].bounds_px = detections.objects[i].bounds_px;
    SetShown(std::move(shown[i]), detections.objects[i]);
  }
}

template <typename SeedType>
void DistortSeeds(const Lens& lens, std::vector<SeedType>& seeds) {
  for (SeedType& seed : seeds) {
    seed.pixel = DistortRect(lens, {seed.pixel, cv::Size(1, 1)}).tl();
  }
}

void DistortImages(const Lens& lens, Trace& trace) {
  const std::pair<cv::Mat*, double> images[] = {{&trace.depth_m, std::nan("")},
                                                {&trace.color_saliency, 0},
                                                {&trace.depth_saliency, 0},
                                                {&trace.voxels.voxel_of_pixel, -1}};
  std::vector<cv::Mat> ideal;
  const bool any = std::any_of(std::begin(images), std::end(images),
                               [](const auto& image) { return !image.first->empty(); });
  if (!any) return;
  for (const auto& [image, none] : images) {
    ideal.push_back(*image);
    if (!image->empty()) *image = cv::Mat(image->size(), image->type(), cv::Scalar(none));
  }
  const cv::Mat everywhere(lens.size(), CV_8UC1, cv::Scalar(255));
  ForEachSeen(lens, everywhere, [&](const cv::Point& sent, const cv::Point& from) {
    for (std::size_t i = 0; i < ideal.size(); ++i) {
      // All have four bytes a pixel.
      if (!ideal[i].empty()) images[i].first->at<int>(sent) = ideal[i].at<int>(from);
    }
  });
}

}  // namespace

void DistortAnswer(const Lens& lens, Detections& detections, Trace& trace) {
  DistortObjects(lens, detections);
  for (RejectedObject& rejected : detections.rejected) {
    rejected.bounds_px = DistortRect(lens, rejected.bounds_px);
  }
  DistortSeeds(lens, trace.seeds);
  DistortSeeds(lens, trace.removed);
  DistortImages(lens, trace);
}

}  // namespace fovea
