#include "core/objects/confidence.h"

#include <cmath>

namespace fovea {

float Confidence(const DetectedObject& object, const cv::Size& image) {
  const double typical_pixels = image.area() / 300.0;
  return static_cast<float>(1 - std::exp(-static_cast<double>(object.num_pixels) / typical_pixels));
}

}  // namespace fovea
