// Images of a request → matrices of the core.
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>

#include "fovea/v1/frame.pb.h"

namespace fovea::server {

// Both throw std::invalid_argument that starts with the field ("frame.color.data: …"), and never
// allocate for more than `max_pixels`.

// CV_8UC3, R first.
cv::Mat ColorFromProto(const v1::ColorImage& color, std::uint64_t max_pixels);

// CV_32FC1 in metres; NaN where nothing was measured.
cv::Mat DepthFromProto(const v1::DepthImage& depth, std::uint64_t max_pixels);

}  // namespace fovea::server
