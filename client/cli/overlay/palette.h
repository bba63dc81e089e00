#pragma once

#include <cstdint>
#include <opencv2/core/types.hpp>

namespace fovea::cli {

// The colour of object `label` (1, 2, …), as (B, G, R): neighbours in number differ clearly.
cv::Scalar ColorOf(std::uint32_t label);

// Black or white, whichever reads better on `background`.
cv::Scalar TextColorOn(const cv::Scalar& background);

}  // namespace fovea::cli
