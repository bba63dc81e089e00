#include "tests/evaluation/grasp_figures/grasp_overlay.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "tests/evaluation/grasp_check/hand_boxes.h"

namespace fovea::evaluation {
namespace {

using Line = std::vector<Eigen::Vector3d>;  // in the hand's frame

constexpr int kScale = 2;
constexpr double kStem_m = 0.04;

std::vector<Line> LinesOf(const JawGripper& jaw, double opening_m) {
  const double half = opening_m / 2, side = jaw.finger_width_m / 2, back = -jaw.finger_length_m;
  std::vector<Line> lines = {{{-half, 0, back}, {half, 0, back}},
                             {{0, 0, back}, {0, 0, back - kStem_m}}};
  for (const double x : {-half, half}) {
    lines.push_back(
        {{x, -side, 0}, {x, side, 0}, {x, side, back}, {x, -side, back}, {x, -side, 0}});
  }
  return lines;
}

std::vector<Line> LinesOf(const SuctionGripper& cup) {
  constexpr int kCorners = 24;
  Line lip;
  for (int i = 0; i <= kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    lip.emplace_back(cup.diameter_m / 2 * std::cos(angle), cup.diameter_m / 2 * std::sin(angle), 0);
  }
  return {lip, {{0, 0, 0}, {0, 0, -kStem_m}}};
}

std::vector<Line> LinesOf(const Gripper& gripper, const Grasp& grasp) {
  if (const auto* cup = std::get_if<SuctionGripper>(&gripper.hand)) return LinesOf(*cup);
  return LinesOf(std::get<JawGripper>(gripper.hand), grasp.opening_m);
}

cv::Point InImage(const Eigen::Vector3d& p, const CameraIntrinsics& k) {
  const double z = std::max(p.z(), 0.05);  // what reaches behind the camera leaves the image
  return {static_cast<int>(std::lround(kScale * (k.fx_px * p.x() / z + k.cx_px))),
          static_cast<int>(std::lround(kScale * (k.fy_px * p.y() / z + k.cy_px)))};
}

void Draw(const EndedGrasp& ended, const Gripper& gripper, const CameraIntrinsics& intrinsics,
          cv::Mat& picture) {
  const bool succeeds = ended.outcome == Outcome::kSuccess;
  const cv::Scalar color = succeeds ? cv::Scalar(60, 220, 60) : cv::Scalar(50, 50, 255);
  const Eigen::Vector3d tip = ended.grasp.tool_center_point.cast<double>();
  const Eigen::Vector3d approach = ended.grasp.approach.cast<double>();
  const bool jaw = std::holds_alternative<JawGripper>(gripper.hand);
  const Eigen::Matrix3d axes = HandAxes(
      approach, jaw ? ended.grasp.closing.cast<double>().eval() : approach.unitOrthogonal());
  for (const Line& line : LinesOf(gripper, ended.grasp)) {
    std::vector<cv::Point> points;
    for (const Eigen::Vector3d& point : line) {
      points.push_back(InImage(tip + axes * point, intrinsics));
    }
    cv::polylines(picture, points, false, color, 2, cv::LINE_AA);
  }
  const std::string text = fmt::format("{:.2f}{}{}", ended.grasp.probability, succeeds ? "" : " ",
                                       succeeds ? "" : NameOf(ended.outcome));
  cv::putText(picture, text, InImage(tip, intrinsics) + cv::Point(6, 14), cv::FONT_HERSHEY_SIMPLEX,
              0.5, color, 1, cv::LINE_AA);
}

}  // namespace

cv::Mat DrawGrasps(const RgbdFrame& frame, const Gripper& gripper,
                   const std::vector<EndedGrasp>& grasps) {
  cv::Mat picture;
  cv::cvtColor(frame.color_rgb, picture, cv::COLOR_RGB2BGR);
  cv::resize(picture, picture, {}, kScale, kScale, cv::INTER_LINEAR);
  for (const EndedGrasp& ended : grasps) Draw(ended, gripper, frame.intrinsics, picture);
  return picture;
}

}  // namespace fovea::evaluation
