#include "core/lens/distort_answer.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

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

// Calls visit(sent pixel, ideal pixel) for those of the rectangle that see something of the ideal
// image.
template <typename Visit>
void ForEachSeen(const Lens& lens, const cv::Rect& sent, Visit visit) {
  const cv::Rect image({0, 0}, lens.size());
  for (int y = sent.y; y < sent.y + sent.height; ++y) {
    InterruptionPoint();
    cv::Point2d off(0, 0);  // of the pixel before
    for (int x = sent.x; x < sent.x + sent.width; ++x) {
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

// The place of each pixel of the mask in row-major order, -1 elsewhere; of the size of its bounds.
cv::Mat OrderInMask(const cv::Mat& labels, const DetectedObject& object) {
  cv::Mat order(object.bounds_px.size(), CV_32SC1, cv::Scalar(-1));
  const cv::Mat own = labels(object.bounds_px) == object.label;
  int next = 0;
  for (int row = 0; row < order.rows; ++row) {
    for (int col = 0; col < order.cols; ++col) {
      if (own.at<std::uint8_t>(row, col) != 0) order.at<int>(row, col) = next++;
    }
  }
  return order;
}

void DistortObject(const Lens& lens, const cv::Mat& ideal_labels, DetectedObject& object,
                   cv::Mat& labels) {
  const cv::Mat order = OrderInMask(ideal_labels, object);
  const cv::Point origin = object.bounds_px.tl();
  const cv::Rect around = DistortRect(lens, object.bounds_px);
  // Beside its border pixels may be nearest to one within.
  const cv::Rect searched =
      (around + cv::Size(4, 4) - cv::Point(2, 2)) & cv::Rect({0, 0}, lens.size());
  std::vector<cv::Point> mask;
  std::vector<ColoredPoint> cloud;
  ForEachSeen(lens, searched, [&](const cv::Point& sent, const cv::Point& ideal) {
    if (!object.bounds_px.contains(ideal)) return;
    if (ideal_labels.at<std::uint16_t>(ideal) != object.label) return;
    labels.at<std::uint16_t>(sent) = static_cast<std::uint16_t>(object.label);
    mask.push_back(sent);
    const auto point = static_cast<std::size_t>(order.at<int>(ideal - origin));
    if (point < object.cloud.size()) cloud.push_back(object.cloud[point]);
  });
  object.bounds_px = mask.empty() ? around : cv::boundingRect(mask);
  object.num_pixels = mask.size();
  object.cloud = std::move(cloud);
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
  ForEachSeen(lens, {{0, 0}, lens.size()}, [&](const cv::Point& sent, const cv::Point& from) {
    for (std::size_t i = 0; i < ideal.size(); ++i) {
      // All have four bytes a pixel.
      if (!ideal[i].empty()) images[i].first->at<int>(sent) = ideal[i].at<int>(from);
    }
  });
}

}  // namespace

void DistortAnswer(const Lens& lens, Detections& detections, Trace& trace) {
  cv::Mat labels = cv::Mat::zeros(detections.labels.size(), CV_16UC1);
  for (DetectedObject& object : detections.objects) {
    DistortObject(lens, detections.labels, object, labels);
  }
  detections.labels = labels;
  for (RejectedObject& rejected : detections.rejected) {
    rejected.bounds_px = DistortRect(lens, rejected.bounds_px);
  }
  DistortSeeds(lens, trace.seeds);
  DistortSeeds(lens, trace.removed);
  DistortImages(lens, trace);
}

}  // namespace fovea
