#include "client/cli/overlay.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "client/cli/box_corners.h"
#include "client/cli/drawing.h"
#include "client/cli/labels.h"
#include "client/cli/palette.h"

namespace fovea::cli {
namespace {

const cv::Scalar kWhite(255, 255, 255), kRed(30, 30, 255);

// Where things of the frame lie in the picture.
struct View {
  cv::Size frame;
  int scale = 1;
  v1::CameraIntrinsics intrinsics;

  // The middle of a frame pixel.
  cv::Point2d At(double x, double y) const {
    return {(x + 0.5) * scale - 0.5, (y + 0.5) * scale - 0.5};
  }
  // Empty behind the camera.
  std::optional<cv::Point2d> Project(const cv::Vec3d& point) const {
    if (!(point[2] > 0.01)) return std::nullopt;
    return At(intrinsics.fx() * point[0] / point[2] + intrinsics.cx(),
              intrinsics.fy() * point[1] / point[2] + intrinsics.cy());
  }
};

cv::Vec3d ToVec(const v1::Vector3& vector) { return {vector.x(), vector.y(), vector.z()}; }

cv::Mat Background(const cv::Mat& color, int scale) {
  cv::Mat picture, grey;
  cv::resize(color, picture, {}, scale, scale, cv::INTER_CUBIC);
  // A little darker and greyer, so that the objects stand out.
  cv::cvtColor(picture, grey, cv::COLOR_BGR2GRAY);
  cv::cvtColor(grey, grey, cv::COLOR_GRAY2BGR);
  cv::addWeighted(picture, 0.55, grey, 0.25, 0, picture);
  return picture;
}

// The mask in the picture, with smooth instead of stepped edges.
cv::Mat PictureMask(const v1::Object& object, const View& view) {
  cv::Mat mask = cv::Mat::zeros(view.frame, CV_8UC1);
  MaskImage(object).copyTo(mask(BoundsOf(object.mask().bounds(), view.frame)));
  if (view.scale == 1) return mask;
  cv::resize(mask, mask, {}, view.scale, view.scale, cv::INTER_LINEAR);
  return mask > 127;
}

void DrawMask(cv::Mat& picture, const cv::Mat& bright, const v1::Object& object, const View& view) {
  const cv::Mat mask = PictureMask(object, view);
  const cv::Scalar color = ColorOf(object.label());
  bright.copyTo(picture, mask);
  Tint(picture, mask, color, 0.4);
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(mask, contours, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
  DrawContours(picture, contours, color);
}

void DrawUprightBox(cv::Mat& picture, const v1::Object& object, const View& view) {
  const auto& bounds = object.bounding_box();
  const cv::Size size(static_cast<int>(bounds.width()), static_cast<int>(bounds.height()));
  const cv::Rect box(cv::Point(view.At(bounds.x(), bounds.y())), size * view.scale);
  cv::rectangle(picture, box, ColorOf(object.label()), 1);
}

void DrawOrientedBox(cv::Mat& picture, const v1::Object& object, const View& view) {
  const cv::Scalar color = 0.5 * ColorOf(object.label()) + 0.5 * kWhite;
  const auto corners = CornersOf(object.oriented_box());
  for (const auto& [from, to] : kBoxEdges) {
    const auto start = view.Project(corners[from]), end = view.Project(corners[to]);
    if (start && end) cv::line(picture, *start, *end, color, 1, cv::LINE_AA);
  }
}

// Boxes shine through: in a pile they would else hide what is in them.
void DrawBoxes(cv::Mat& picture, const v1::Detections& detections, const View& view) {
  cv::Mat boxes = picture.clone();
  for (const v1::Object& object : detections.objects()) {
    DrawUprightBox(boxes, object, view);
    DrawOrientedBox(boxes, object, view);
  }
  cv::addWeighted(picture, 0.35, boxes, 0.65, 0, picture);
}

// The best grasp: a line between the finger tips, a bar at each.
void DrawGrasp(cv::Mat& picture, const v1::Object& object, const View& view) {
  if (object.grasps().empty()) return;
  const v1::Grasp& grasp = object.grasps(0);
  const cv::Vec3d middle = ToVec(grasp.tool_center_point());
  const cv::Vec3d half = ToVec(grasp.closing()) * (grasp.opening_m() / 2);
  const auto left = view.Project(middle - half), right = view.Project(middle + half);
  if (!left || !right) return;
  DrawLine(picture, *left, *right, kWhite, 2);
  const cv::Point2d along = *right - *left;
  const double length = std::hypot(along.x, along.y);
  if (length < 1) return;
  const cv::Point2d across(-along.y / length * 6, along.x / length * 6);
  for (const cv::Point2d& tip : {*left, *right}) {
    DrawLine(picture, tip - across, tip + across, kWhite, 3);
  }
}

// Moves a badge down until it covers none of those placed before, and keeps it in the picture.
cv::Rect PlaceBadge(cv::Rect badge, const std::vector<cv::Rect>& placed, const cv::Size& picture) {
  badge.x = std::clamp(badge.x, 0, std::max(0, picture.width - badge.width - 1));
  badge.y = std::clamp(badge.y, 0, std::max(0, picture.height - badge.height - 1));
  for (const cv::Rect& other : placed) {
    if ((badge & other).area() > 0) badge.y = other.y + other.height + 1;
  }
  return badge;
}

void DrawBadges(cv::Mat& picture, const v1::Detections& detections, const View& view) {
  std::vector<cv::Rect> placed;
  for (const v1::Object& object : detections.objects()) {
    const std::string text = std::to_string(object.label()) + "  " +
                             std::to_string(std::lround(object.confidence() * 100)) + "%";
    const cv::Size size = BadgeSize(text);
    const cv::Point corner = view.At(object.bounding_box().x(), object.bounding_box().y());
    const cv::Rect wanted(corner - cv::Point(0, size.height), size);
    placed.push_back(PlaceBadge(wanted, placed, picture.size()));
    DrawBadge(picture, placed.back().tl(), text, ColorOf(object.label()));
  }
}

}  // namespace

cv::Mat DrawOverlay(const cv::Mat& color, const v1::CameraIntrinsics& intrinsics,
                    const v1::Detections& detections) {
  constexpr int kSmall = 1000;
  const View view{color.size(), color.cols < kSmall ? 2 : 1, intrinsics};
  cv::Mat picture = Background(color, view.scale), bright;
  cv::resize(color, bright, picture.size(), 0, 0, cv::INTER_CUBIC);

  // What says more is drawn later and covers what says less.
  for (const v1::Object& object : detections.objects()) DrawMask(picture, bright, object, view);
  DrawBoxes(picture, detections, view);
  for (const v1::Seed& seed : detections.seeds()) {
    DrawCross(picture, view.At(seed.x(), seed.y()), 6, kRed);
  }
  for (const v1::Object& object : detections.objects()) DrawGrasp(picture, object, view);
  DrawBadges(picture, detections, view);
  return picture;
}

}  // namespace fovea::cli
