// How sure a detection is.
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/types/rgbd_frame.h"

namespace fovea::paper {

// The probability that a segment of `default` is an object with the right box (IoU above 0.5),
// from its visible area and its distance: what shows little of itself is a fragment more often,
// and what is far away is blurred by noise. Logistic regression over generated scenes of both
// sensors; docs/quality.md has the reliability on others. 0 … 1.
float Confidence(double visible_area_m2, double distance_m);

// That of each segment, of label k at k − 1; 0 for labels that no pixel has. `labels`: CV_16UC1, 0
// = background; `depth_m`: CV_32FC1, with depth wherever there is a label.
std::vector<float> Confidences(const cv::Mat& labels, const cv::Mat& depth_m,
                               const CameraIntrinsics& intrinsics);

}  // namespace fovea::paper
