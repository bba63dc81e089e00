#pragma once

#include <array>
#include <opencv2/core/matx.hpp>
#include <utility>

#include "fovea/v1/geometry.pb.h"

namespace fovea::cli {

// The corners in the camera frame; bit 0, 1, 2 of an index says on which side of x, y, z it lies.
std::array<cv::Vec3d, 8> CornersOf(const v1::OrientedBox& box);

// Pairs of corners that an edge joins: those that differ in one bit.
inline constexpr std::array<std::pair<std::size_t, std::size_t>, 12> kBoxEdges{{{0, 1},
                                                                                {2, 3},
                                                                                {4, 5},
                                                                                {6, 7},
                                                                                {0, 2},
                                                                                {1, 3},
                                                                                {4, 6},
                                                                                {5, 7},
                                                                                {0, 4},
                                                                                {1, 5},
                                                                                {2, 6},
                                                                                {3, 7}}};

}  // namespace fovea::cli
