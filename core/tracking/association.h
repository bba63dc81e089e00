// Which detection is which track.
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/tracking/sighting.h"
#include "core/tracking/track.h"
#include "core/types/rgbd_frame.h"

namespace fovea {

// What tracks and detections of a frame are compared in.
struct AssociationFrame {
  const cv::Mat& labels;  // CV_16UC1, of the frame
  CameraIntrinsics intrinsics;
  double camera_error_m = 0;  // of the motion since the frame before
};

// The track of each detection, by index, or -1: the assignment of least cost in two passes, as in
// ByteTrack (Zhang et al. 2022): detections of some confidence first, then the others to what is
// left of the tracks. Unlike there these may be hidden: what is hard to see is found now and then.
// O(tracks · (points + detections²)).
std::vector<int> Associate(const std::vector<Track>& tracks,
                           const std::vector<Sighting>& detections, const AssociationFrame& frame);

}  // namespace fovea
