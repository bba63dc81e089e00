#include "core/objects/outline.h"

#include <array>
#include <cmath>
#include <cstdint>

#include "core/depth/depth_gap.h"
#include "core/objects/measured_area.h"
#include "core/scene/image_direction.h"
#include "core/segmentation/labels.h"
#include "core/types/interruption.h"
#include "core/types/pixels.h"

namespace fovea {
namespace {

// In an image 640 wide:
constexpr double kEdgePx = 6;    // what sensors mix at an edge
constexpr double kReachPx = 60;  // how far to look for depth beyond it: the front of a table may
                                 // be nearer than sensors measure
constexpr double kEndPx = 40;    // how far to look for the end of the image

Eigen::Vector3f PointAt(const cv::Mat& points, const cv::Point& pixel) {
  const cv::Vec3f& p = points.at<cv::Vec3f>(pixel);
  return {p[0], p[1], p[2]};
}

class Search {
 public:
  Search(const cv::Mat& labels, const cv::Mat& points, const cv::Mat& on_wall,
         const Eigen::Vector3f& up)
      : labels_(labels),
        points_(points),
        on_wall_(on_wall),
        up_(up),
        edge_px_(ScaledPx(kEdgePx, labels.cols, 1)),
        reach_px_(ScaledPx(kReachPx, labels.cols, 4)),
        end_px_(ScaledPx(kEndPx, labels.cols, 4)),
        measured_(MeasuredArea(points)) {}

  void CountSides(const cv::Point& pixel, Outline& outline) const {
    const std::uint16_t label = labels_.at<std::uint16_t>(pixel);
    const cv::Rect image({}, labels_.size());
    for (const cv::Point& side :
         {cv::Point(1, 0), cv::Point(-1, 0), cv::Point(0, 1), cv::Point(0, -1)}) {
      const cv::Point next = pixel + side;
      if (image.contains(next) && labels_.at<std::uint16_t>(next) == label) continue;
      ++outline.num_sides;
      if (!measured_.contains(pixel + edge_px_ * side)) ++outline.num_sides_at_end;
    }
  }

  // Counts what lies above a pixel if the upper border is there.
  void CountUpper(const cv::Point& pixel, const cv::Point2f& direction,
                  Outline::Upper& upper) const {
    const std::uint16_t label = labels_.at<std::uint16_t>(pixel);
    const cv::Rect image({}, labels_.size());
    for (int step = 1; step <= reach_px_; ++step) {
      const cv::Point beyond(cvRound(static_cast<float>(pixel.x) + step * direction.x),
                             cvRound(static_cast<float>(pixel.y) + step * direction.y));
      if (!image.contains(beyond)) {
        ++(step <= end_px_ ? upper.at_end : upper.open);
        return;
      }
      const std::uint16_t other = labels_.at<std::uint16_t>(beyond);
      if (other == label) return;
      if (other != 0) {
        ++upper.open;
        return;
      }
      if (step < edge_px_ || std::isnan(points_.at<cv::Vec3f>(beyond)[2])) continue;
      Compare(pixel, beyond, upper);
      return;
    }
    ++upper.open;  // nothing measured
  }

 private:
  void Compare(const cv::Point& pixel, const cv::Point& beyond_px, Outline::Upper& upper) const {
    const Eigen::Vector3f own = PointAt(points_, pixel);
    const Eigen::Vector3f beyond = PointAt(points_, beyond_px);
    const bool on_wall = on_wall_.at<std::uint16_t>(beyond_px) != 0;
    const float step_m = beyond.z() - own.z();
    const float gap_m = DepthGap_m(own.z());
    if (step_m < -gap_m) {
      ++upper.hidden;
    } else if (step_m <= gap_m && up_.dot(beyond - own) > 0.004F * own.z()) {
      ++(on_wall ? upper.at_wall : upper.attached);
    } else {
      ++upper.open;
    }
  }

  const cv::Mat& labels_;
  const cv::Mat& points_;
  const cv::Mat& on_wall_;
  const Eigen::Vector3f& up_;
  const int edge_px_;
  const int reach_px_;
  const int end_px_;
  const cv::Rect measured_;
};

}  // namespace

std::vector<Outline> FindOutlines(const cv::Mat& labels, const cv::Mat& points,
                                  const cv::Mat& on_wall, const CameraIntrinsics& intrinsics,
                                  const Eigen::Vector3f& up) {
  std::vector<Outline> outlines(1);
  const Search search(labels, points, on_wall, up);
  for (int row = 0; row < labels.rows; ++row) {
    InterruptionPoint();
    const auto* label = labels.ptr<std::uint16_t>(row);
    for (int col = 0; col < labels.cols; ++col) {
      if (label[col] == 0) continue;
      if (label[col] >= outlines.size()) outlines.resize(label[col] + std::size_t{1});
      if (IsInterior(labels, row, col)) continue;
      const cv::Point pixel(col, row);
      search.CountSides(pixel, outlines[label[col]]);
      const auto direction = UpInImage(PointAt(points, pixel), intrinsics, up);
      if (direction) search.CountUpper(pixel, *direction, outlines[label[col]].upper);
    }
  }
  return outlines;
}

}  // namespace fovea
