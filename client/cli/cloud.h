// The frame in space, with what was found, as files that viewers open.
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "client/cli/depth_points.h"

namespace fovea::cli {

struct CloudPoint {
  cv::Vec3f position;  // metres, camera frame
  cv::Vec3b bgr;
};

// The points of the depth camera: objects tinted in their palette colour, the background in dimmed
// true colour. `color` CV_8UC3 (B first); the detections' masks must be of its size, else throws
// std::runtime_error, and it must have all pixels of the points.
std::vector<CloudPoint> TintedCloud(const cv::Mat& color, const std::vector<DepthPoint>& points,
                                    const v1::Detections& detections);

// The solids that the objects are taken for and the likeliest grasp of each gripper, as dots a
// millimetre or two apart: every viewer shows points, few show lines. Colours as in overlays.
std::vector<CloudPoint> DotsOf(const v1::Detections& detections);

// Binary files: PLY, and PCL's PCD 0.7 with the fields x, y, z, rgb.
std::string MakePly(const std::vector<CloudPoint>& cloud);
std::string MakePcd(const std::vector<CloudPoint>& cloud);

}  // namespace fovea::cli
