#include "client/cli/overlay/grasps.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <set>
#include <string>

#include "client/cli/overlay/drawing.h"
#include "client/cli/overlay/hand.h"

namespace fovea::cli {
namespace {

void FillBlock(cv::Mat& picture, const Block& block, const View& view, const cv::Scalar& color,
               double opacity) {
  std::vector<cv::Point> corners, hull;
  for (const cv::Vec3d& corner : CornersOf(block)) {
    const auto pixel = view.Project(corner);
    if (!pixel) return;
    corners.emplace_back(*pixel);
  }
  cv::convexHull(corners, hull);
  FillPolygon(picture, hull, color, opacity);
}

void DrawLines(cv::Mat& picture, const std::vector<SpaceLine>& lines, const View& view,
               const cv::Scalar& color, int thickness) {
  for (const SpaceLine& line : lines) {
    if (line.hidden) continue;
    const auto ends = view.Project(line);
    if (!ends) continue;
    if (thickness > 1) {
      DrawLine(picture, ends->first, ends->second, color, thickness);
    } else {
      DrawThinLine(picture, ends->first, ends->second, color, 1);
    }
  }
}

// Fingers are filled; the palm shows what is behind it.
void DrawHand(cv::Mat& picture, const Hand& hand, const View& view, const cv::Scalar& color) {
  for (std::size_t i = 0; i < hand.blocks.size(); ++i) {
    const bool is_palm = i + 1 == hand.blocks.size();
    FillBlock(picture, hand.blocks[i], view, color, is_palm ? 0.3 : 0.75);
    DrawLines(picture, EdgesOf(hand.blocks[i]), view, color, 1);
  }
  DrawLines(picture, hand.lines, view, color, 2);
}

void DrawHandOutline(cv::Mat& picture, const Hand& hand, const View& view,
                     const cv::Scalar& color) {
  for (const Block& block : hand.blocks) DrawLines(picture, EdgesOf(block), view, color, 1);
  DrawLines(picture, hand.lines, view, color, 1);
}

}  // namespace

cv::Scalar ColorOfProbability(double probability) {
  const double p = std::clamp(probability, 0.0, 1.0);
  return {40, 60 + 180 * std::min(2 * p, 1.0), 60 + 190 * std::min(2 - 2 * p, 1.0)};
}

std::vector<const v1::Grasp*> LikeliestGrasps(const v1::Object& object) {
  std::set<std::uint32_t> seen;  // grippers; grasps come likeliest first
  std::vector<const v1::Grasp*> best;
  for (const v1::Grasp& grasp : object.grasps()) {
    if (seen.insert(grasp.gripper_index()).second) best.push_back(&grasp);
  }
  return best;
}

void DrawGrasps(cv::Mat& picture, const v1::Object& object,
                const google::protobuf::RepeatedPtrField<v1::Gripper>& grippers, const View& view,
                bool all, Badges& badges) {
  if (all) {
    for (const v1::Grasp& grasp : object.grasps()) {
      DrawHandOutline(picture, HandOf(grasp, grippers), view,
                      ColorOfProbability(grasp.probability()));
    }
  }
  for (const v1::Grasp* grasp : LikeliestGrasps(object)) {
    const Hand hand = HandOf(*grasp, grippers);
    const cv::Scalar color = ColorOfProbability(grasp->probability());
    DrawHand(picture, hand, view, color);
    if (const auto back = view.Project(hand.back)) {
      badges.Add(*back, {"", std::to_string(std::lround(grasp->probability() * 100)) + "%"}, color);
    }
  }
}

}  // namespace fovea::cli
