// Training-free segmentation from the Point Cloud Library, to compare the detector with.
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "core/types/rgbd_frame.h"

namespace fovea::evaluation {

// All of them first take the largest plane (RANSAC) for the support and drop it and what lies
// below. lccp: supervoxels joined by local convexity (Stein et al. 2014). cpc: the same, then cut
// along constrained planes (Schoeler et al. 2015). plane_clusters: Euclidean clusters of what is
// left.
std::vector<std::string> PeerNames();

// Returns CV_16UC1 of the frame's size: 0 = no object, k = object k. Throws std::invalid_argument
// for an unknown name. The RANSAC draws are the same on every run; PCL's supervoxels may still
// differ a little from run to run.
cv::Mat SegmentWithPeer(const std::string& name, const RgbdFrame& frame);

}  // namespace fovea::evaluation
