// Parts of furniture among the segments: legs under a table, seats of chairs and their legs. Goes
// beyond the paper. One entry a label each, the background's first, not 0 for what was found.
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/objects/placed_segment.h"
#include "core/segmentation/voxel_grid.h"
#include "core/types/rgbd_frame.h"

namespace fovea {

// Segments that lie under a support for the most part and reach up to less than max_hang_m below
// it, and what lies under it and stands right below one of them: the lower end of a leg. `up`: unit
// vector.
std::vector<char> FindTableLegs(const std::vector<PlacedSegment>& segments,
                                const Eigen::Vector3f& up, double max_hang_m);

// Segments high above their support that end higher than max_height_m above it, where for the most
// part nothing is seen right below them: something in front hides it, or one sees past. `labels`:
// CV_16UC1 image of the segments; `points`: CV_32FC3, NaN = none. Cost: that of FindLowerBorders,
// if any segment is so high.
std::vector<char> FindSeats(const std::vector<PlacedSegment>& segments, const cv::Mat& labels,
                            const cv::Mat& points, const CameraIntrinsics& intrinsics,
                            const Eigen::Vector3f& up, double max_height_m);

// Segments that touch a seat, begin lower than it and lie, seen from above, within it. `labels`:
// one entry a voxel; `contacts`: pairs of voxels of segments that touch.
std::vector<char> FindLegsOf(const std::vector<char>& seats,
                             const std::vector<PlacedSegment>& segments,
                             const std::vector<int>& labels, const std::vector<VoxelEdge>& contacts,
                             const Eigen::Vector3f& up);

}  // namespace fovea
