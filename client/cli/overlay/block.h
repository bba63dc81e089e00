// Boxes in space, as a camera at the origin sees them.
#pragma once

#include <array>
#include <opencv2/core/matx.hpp>
#include <vector>

#include "fovea/v1/geometry.pb.h"

namespace fovea::cli {

// A line in space, in metres in the camera frame.
struct SpaceLine {
  cv::Vec3d from, to;
  bool hidden = false;  // behind the solid that it is of
};

struct Block {
  cv::Vec3d center;
  std::array<cv::Vec3d, 3> half_axes;  // across each other; from the centre to three faces
};

Block BlockOf(const v1::OrientedBox& box);

// Bit 0, 1, 2 of an index says on which side of which axis the corner lies.
std::array<cv::Vec3d, 8> CornersOf(const Block& block);

// The twelve edges.
std::vector<SpaceLine> EdgesOf(const Block& block);

}  // namespace fovea::cli
