// Pictures of the steps between a frame and its objects, as the figures of the paper show them.
#pragma once

#include <opencv2/core/mat.hpp>

#include "client/cli/depth_points.h"
#include "fovea/v1/detection.pb.h"
#include "fovea/v1/frame.pb.h"

namespace fovea::cli {

// All pictures are CV_8UC3, B first. They throw std::runtime_error for parts of an answer that do
// not fit the frame.

// Near is warm, far is cold, black is nothing. `depth_m`: CV_32FC1, 0 = none.
cv::Mat DepthPicture(const cv::Mat& depth_m);

// Bright is salient.
cv::Mat SaliencyPicture(const v1::SaliencyMap& map, const cv::Size& frame);

// The kept seeds as a red plus, the removed ones by reason, with a legend.
cv::Mat SeedPicture(const cv::Mat& color, const v1::Trace& trace);

// Eq. 5 of some hypotheses side by side: bright where a point is likely theirs. `depth_m` as of
// FilledDepth.
cv::Mat HypothesesPicture(const cv::Mat& color, const cv::Mat& depth_m,
                          const v1::CameraIntrinsics& intrinsics, const v1::Trace& trace);

// A labelling in the palette's colours over the grey frame.
cv::Mat LabelsPicture(const cv::Mat& color, const v1::LabelImage& labels);

// What was considered and is not reported, boxed, with its probability, the likeliest brightest.
cv::Mat RejectedPicture(const cv::Mat& color, const v1::Detections& detections);

// The trace's depth, CV_32FC1 in metres, 0 = none.
cv::Mat FilledDepth(const v1::Trace& trace, const cv::Size& frame);

// Measured depth where the colour camera sees it, CV_32FC1 in metres, 0 = none.
cv::Mat MeasuredDepth(const std::vector<DepthPoint>& points, const cv::Size& frame);

}  // namespace fovea::cli
