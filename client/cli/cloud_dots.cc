#include <algorithm>
#include <cmath>

#include "client/cli/cloud.h"
#include "client/cli/overlay/grasps.h"
#include "client/cli/overlay/hand.h"
#include "client/cli/overlay/palette.h"
#include "client/cli/overlay/solid_lines.h"

namespace fovea::cli {
namespace {

constexpr double kStep_m = 0.001;      // of lines
constexpr double kFaceStep_m = 0.002;  // of faces
constexpr int kMostSteps = 2000;       // of one line, whatever a server sends

int StepsOver(double length_m, double step_m) {
  return static_cast<int>(std::clamp(std::ceil(length_m / step_m), 1.0, double{kMostSteps}));
}

cv::Vec3b Bytes(const cv::Scalar& color) {
  return {cv::saturate_cast<std::uint8_t>(color[0]), cv::saturate_cast<std::uint8_t>(color[1]),
          cv::saturate_cast<std::uint8_t>(color[2])};
}

void AddLine(const SpaceLine& line, const cv::Vec3b& color, std::vector<CloudPoint>* cloud) {
  const int steps = StepsOver(cv::norm(line.to - line.from), kStep_m);
  for (int i = 0; i < steps; ++i) {
    cloud->push_back({line.from + (line.to - line.from) * (static_cast<double>(i) / steps), color});
  }
}

// Both faces across one axis.
void AddFaces(const Block& block, int axis, const cv::Vec3b& color,
              std::vector<CloudPoint>* cloud) {
  const cv::Vec3d u = block.half_axes[(axis + 1) % 3], v = block.half_axes[(axis + 2) % 3];
  const int rows = StepsOver(2 * cv::norm(u), kFaceStep_m),
            cols = StepsOver(2 * cv::norm(v), kFaceStep_m);
  if (rows * cols > kMostSteps * 10) return;
  for (int row = 0; row <= rows; ++row) {
    for (int col = 0; col <= cols; ++col) {
      const cv::Vec3d offset = (2.0 * row / rows - 1) * u + (2.0 * col / cols - 1) * v;
      for (const double side : {-1.0, 1.0}) {
        cloud->push_back({block.center + offset + side * block.half_axes[axis], color});
      }
    }
  }
}

// Fingers as faces, the palm as edges, so that it hides nothing.
void AddHand(const Hand& hand, const cv::Vec3b& color, std::vector<CloudPoint>* cloud) {
  for (std::size_t i = 0; i + 1 < hand.blocks.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) AddFaces(hand.blocks[i], axis, color, cloud);
  }
  if (!hand.blocks.empty()) {
    for (const SpaceLine& edge : EdgesOf(hand.blocks.back())) AddLine(edge, color, cloud);
  }
  for (const SpaceLine& line : hand.lines) AddLine(line, color, cloud);
}

}  // namespace

std::vector<CloudPoint> DotsOf(const v1::Detections& detections) {
  std::vector<CloudPoint> cloud;
  for (const v1::Object& object : detections.objects()) {
    const cv::Vec3b color = Bytes(ColorOf(object.label()));
    for (const SpaceLine& line : LinesOf(object)) AddLine(line, color, &cloud);
    if (const auto axis = AxisOf(object)) AddLine(*axis, color, &cloud);
    for (const v1::Grasp* grasp : LikeliestGrasps(object)) {
      AddHand(HandOf(*grasp, detections.grippers()),
              Bytes(ColorOfProbability(grasp->probability())), &cloud);
    }
  }
  return cloud;
}

}  // namespace fovea::cli
