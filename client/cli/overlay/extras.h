// What an overlay shows beside the objects.
#pragma once

#include <opencv2/core/mat.hpp>

#include "client/cli/overlay/view.h"
#include "fovea/v1/detection.pb.h"

namespace fovea::cli {

// The frame darkened, what stands out in colour or depth in warm colours; darkened only where the
// answer has no saliency maps. Throws std::runtime_error for maps of another size.
cv::Mat WarmedBySaliency(const cv::Mat& color, const v1::Detections& detections);

// Where something of the size that was asked for can be put down.
void DrawPlace(cv::Mat& picture, const v1::FreePlace& place, const View& view);

// Of objects and of what they stand on, as far as the answer has them.
void DrawCollisions(cv::Mat& picture, const v1::Detections& detections, const View& view);

void DrawSeeds(cv::Mat& picture, const v1::Detections& detections, const View& view);

// What was considered and is not reported, boxed, with its probability, the likeliest brightest.
void DrawRejected(cv::Mat& picture, const v1::Detections& detections, const View& view);

}  // namespace fovea::cli
