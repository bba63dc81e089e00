#include "client/cli/overlay/overlay.h"

#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <vector>

#include "client/cli/labels.h"
#include "client/cli/overlay/badges.h"
#include "client/cli/overlay/drawing.h"
#include "client/cli/overlay/extras.h"
#include "client/cli/overlay/grasps.h"
#include "client/cli/overlay/palette.h"
#include "client/cli/overlay/solid_lines.h"
#include "client/cli/overlay/view.h"

namespace fovea::cli {
namespace {

// A little darker and greyer, so that the objects stand out.
cv::Mat Dimmed(const cv::Mat& color) {
  cv::Mat grey, dimmed;
  cv::cvtColor(color, grey, cv::COLOR_BGR2GRAY);
  cv::cvtColor(grey, grey, cv::COLOR_GRAY2BGR);
  cv::addWeighted(color, 0.55, grey, 0.25, 0, dimmed);
  return dimmed;
}

// On the frame's own pixels.
void TintMask(cv::Mat& frame, const cv::Mat& color, const v1::Object& object) {
  const cv::Rect bounds = BoundsOf(object.mask().bounds(), color.size());
  if (bounds.empty()) return;
  cv::Mat tinted;
  cv::addWeighted(color(bounds), 0.62, cv::Mat(bounds.size(), CV_8UC3, ColorOf(object.label())),
                  0.38, 0, tinted);
  tinted.copyTo(frame(bounds), MaskImage(object));
}

// The outline of the mask, smooth where the picture is larger than the frame. Specks have none.
void OutlineMask(cv::Mat& picture, const v1::Object& object, const View& view) {
  constexpr double kSpeckArea = 40, kTolerance_px = 0.8;
  const cv::Rect bounds = BoundsOf(object.mask().bounds(), view.frame);
  if (bounds.empty()) return;
  cv::Mat mask;
  cv::copyMakeBorder(MaskImage(object), mask, 1, 1, 1, 1, cv::BORDER_CONSTANT);
  if (view.scale != 1) {
    cv::resize(mask, mask, {}, view.scale, view.scale, cv::INTER_LINEAR);
    mask = mask > 127;
  }
  std::vector<std::vector<cv::Point>> contours, drawn;
  cv::findContours(mask, contours, cv::RETR_CCOMP, cv::CHAIN_APPROX_SIMPLE,
                   (bounds.tl() - cv::Point(1, 1)) * view.scale);
  for (std::vector<cv::Point>& contour : contours) {
    if (cv::contourArea(contour) < kSpeckArea) continue;
    cv::approxPolyDP(contour, contour, kTolerance_px, true);
    drawn.push_back(std::move(contour));
  }
  DrawContours(picture, drawn, ColorOf(object.label()));
}

void DrawSolid(cv::Mat& picture, const v1::Object& object, const View& view) {
  const cv::Scalar color = 0.45 * ColorOf(object.label()) + 0.55 * cv::Scalar::all(255);
  for (const SpaceLine& line : LinesOf(object)) {
    const auto ends = view.Project(line);
    if (ends) DrawThinLine(picture, ends->first, ends->second, color, line.hidden ? 0.35 : 1);
  }
  if (const auto axis = AxisOf(object)) {
    const auto ends = view.Project(*axis);
    if (ends) DrawDashes(picture, ends->first, ends->second, color);
  }
}

}  // namespace

cv::Mat DrawOverlay(const cv::Mat& color, const v1::CameraIntrinsics& intrinsics,
                    const v1::Detections& detections, const OverlayExtras& extras) {
  constexpr int kSmall = 1000;
  const View view{color.size(), color.cols < kSmall ? 2 : 1, intrinsics};
  cv::Mat frame = extras.saliency ? WarmedBySaliency(color, detections) : Dimmed(color), picture;
  for (const v1::Object& object : detections.objects()) TintMask(frame, color, object);
  cv::resize(frame, picture, {}, view.scale, view.scale, cv::INTER_LINEAR);

  // What says more is drawn later and covers what says less.
  for (const v1::FreePlace& place : detections.free_places()) DrawPlace(picture, place, view);
  for (const v1::Object& object : detections.objects()) OutlineMask(picture, object, view);
  for (const v1::Object& object : detections.objects()) DrawSolid(picture, object, view);
  if (extras.collisions) DrawCollisions(picture, detections, view);
  if (extras.rejected) DrawRejected(picture, detections, view);
  if (extras.seeds) DrawSeeds(picture, detections, view);
  Badges badges(picture.size());
  for (const v1::Object& object : detections.objects()) {
    DrawGrasps(picture, object, detections.grippers(), view, extras.grasps, badges);
  }
  for (const v1::Object& object : detections.objects()) AddBadge(object, view, badges);
  badges.Draw(picture);
  return picture;
}

}  // namespace fovea::cli
