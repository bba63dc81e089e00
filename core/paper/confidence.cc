#include "core/paper/confidence.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/types/interruption.h"

namespace fovea::paper {

float Confidence(double visible_area_m2, double distance_m) {
  constexpr double kAmpleM2 = 0.005;  // more than this makes no difference
  constexpr double kNearM = 1;        // nor does being nearer
  const double logit = 3.5 + 2.53 * std::min(0.0, std::log(visible_area_m2 / kAmpleM2)) -
                       0.71 * std::max(0.0, distance_m - kNearM);
  return static_cast<float>(1 / (1 + std::exp(-logit)));
}

std::vector<float> Confidences(const cv::Mat& labels, const cv::Mat& depth_m,
                               const CameraIntrinsics& intrinsics) {
  struct Pixels {
    double count = 0;
    double squares = 0;  // of their z
  };
  std::vector<Pixels> pixels;  // of each label, the background's first
  for (int row = 0; row < labels.rows; ++row) {
    InterruptionPoint();
    const auto* label = labels.ptr<std::uint16_t>(row);
    const float* z = depth_m.ptr<float>(row);
    for (int col = 0; col < labels.cols; ++col) {
      if (label[col] == 0) continue;
      if (label[col] >= pixels.size()) pixels.resize(std::size_t{label[col]} + 1);
      pixels[label[col]].count += 1;
      pixels[label[col]].squares += static_cast<double>(z[col]) * z[col];
    }
  }
  std::vector<float> confidences;
  for (std::size_t k = 1; k < pixels.size(); ++k) {
    const auto [count, squares] = pixels[k];
    const double area_m2 = squares / (intrinsics.fx_px * intrinsics.fy_px);
    confidences.push_back(count > 0 ? Confidence(area_m2, std::sqrt(squares / count)) : 0);
  }
  return confidences;
}

}  // namespace fovea::paper
