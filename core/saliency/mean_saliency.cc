#include "core/saliency/mean_saliency.h"

#include <opencv2/core.hpp>

#include "core/types/interruption.h"

namespace fovea {

cv::Mat MeanSaliency(const cv::Mat& color_saliency, const cv::Mat& depth_saliency) {
  const auto scale = [](const cv::Mat& map) {
    InterruptionPoint();
    double max = 0;
    cv::minMaxLoc(map, nullptr, &max);
    return max > 0 ? 0.5 / max : 0.0;
  };
  return color_saliency * scale(color_saliency) + depth_saliency * scale(depth_saliency);
}

}  // namespace fovea
