#pragma once

#include <cstdint>
#include <opencv2/core/types.hpp>

namespace fovea::cli {

// Of what is no object, as (B, G, R).
inline const cv::Scalar kRed(30, 30, 255), kYellow(40, 220, 255), kBlue(255, 140, 60),
    kWhite(255, 255, 255);

// The colour of object `label` (1, 2, …), as (B, G, R): neighbours in number differ clearly.
cv::Scalar ColorOf(std::uint32_t label);

// Black or white, whichever reads better on `background`.
cv::Scalar TextColorOn(const cv::Scalar& background);

}  // namespace fovea::cli
