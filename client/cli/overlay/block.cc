#include "client/cli/overlay/block.h"

#include "client/cli/geometry.h"

namespace fovea::cli {
namespace {

// Of the face on one side of an axis.
bool IsSeen(const Block& block, int axis, bool positive) {
  const cv::Vec3d normal = (positive ? 1 : -1) * block.half_axes[axis];
  return normal.dot(block.center + normal) < 0;
}

}  // namespace

Block BlockOf(const v1::OrientedBox& box) {
  const cv::Matx33d axes = RotationOf(box.pose().orientation());
  const cv::Vec3d size = ToVec(box.size());
  Block block{ToVec(box.pose().position()), {}};
  for (int i = 0; i < 3; ++i) {
    block.half_axes[i] = size[i] / 2 * cv::Vec3d(axes(0, i), axes(1, i), axes(2, i));
  }
  return block;
}

std::array<cv::Vec3d, 8> CornersOf(const Block& block) {
  std::array<cv::Vec3d, 8> corners;
  for (unsigned i = 0; i < corners.size(); ++i) {
    corners[i] = block.center;
    for (unsigned axis = 0; axis < 3; ++axis) {
      corners[i] += (i >> axis & 1 ? 1 : -1) * block.half_axes[axis];
    }
  }
  return corners;
}

std::vector<SpaceLine> EdgesOf(const Block& block) {
  const auto corners = CornersOf(block);
  std::vector<SpaceLine> edges;
  for (unsigned axis = 0; axis < 3; ++axis) {
    const unsigned bit = 1U << axis, next = (axis + 1) % 3, last = (axis + 2) % 3;
    for (unsigned i = 0; i < corners.size(); ++i) {
      if (i & bit) continue;
      // An edge lies between two faces.
      const bool seen = IsSeen(block, static_cast<int>(next), i >> next & 1) ||
                        IsSeen(block, static_cast<int>(last), i >> last & 1);
      edges.push_back({corners[i], corners[i | bit], !seen});
    }
  }
  return edges;
}

}  // namespace fovea::cli
