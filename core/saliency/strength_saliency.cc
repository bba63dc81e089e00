#include "core/saliency/strength_saliency.h"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/types/lab.h"

namespace fovea {
namespace {

int PaddingToMultiple(int size, int factor) { return (factor - size % factor) % factor; }

// Averages blocks of factor × factor pixels; the last row and column are repeated where the size
// is no multiple of the factor.
cv::Mat Reduce(const cv::Mat& image, int factor) {
  if (factor == 1) return image;
  cv::Mat padded, reduced;
  cv::copyMakeBorder(image, padded, 0, PaddingToMultiple(image.rows, factor), 0,
                     PaddingToMultiple(image.cols, factor), cv::BORDER_REPLICATE);
  cv::resize(padded, reduced, padded.size() / factor, 0, 0, cv::INTER_AREA);
  return reduced;
}

// Undoes Reduce in size: each value becomes a flat block.
cv::Mat Enlarge(const cv::Mat& map, int factor, cv::Size size) {
  if (factor == 1) return map;
  cv::Mat enlarged;
  cv::resize(map, enlarged, map.size() * factor, 0, 0, cv::INTER_NEAREST);
  return enlarged(cv::Rect({0, 0}, size)).clone();
}

void Accumulate(const cv::Mat& strength, cv::Mat& saliency) {
  for (int y = 0; y < saliency.rows; ++y) {
    const float* from = strength.ptr<float>(y);
    float* to = saliency.ptr<float>(y);
    for (int x = 0; x < saliency.cols; ++x) to[x] += 1.0F - from[x];
  }
}

// In a fixed order, unlike cv::norm: the sum must not depend on the machine's vector width.
void NormalizeL2(cv::Mat& map) {
  double sum = 0;
  for (int y = 0; y < map.rows; ++y) {
    const float* row = map.ptr<float>(y);
    for (int x = 0; x < map.cols; ++x) sum += static_cast<double>(row[x]) * row[x];
  }
  if (sum == 0) return;
  const auto norm = static_cast<float>(std::sqrt(sum));
  for (int y = 0; y < map.rows; ++y) {
    float* row = map.ptr<float>(y);
    for (int x = 0; x < map.cols; ++x) row[x] /= norm;
  }
}

}  // namespace

cv::Mat StrengthSaliency(const cv::Mat& color_rgb, const StrengthSaliencyOptions& options) {
  const cv::Mat lab = LabOf(Reduce(color_rgb, options.downscale));
  std::vector<cv::Mat> channels;
  cv::split(lab, channels);

  cv::Mat saliency = cv::Mat::zeros(lab.size(), CV_32F);
  for (int scale = 1; scale <= options.num_scales; ++scale) {
    for (const cv::Mat& channel : channels) {
      Accumulate(PropagateStrength(channel, scale), saliency);
    }
  }
  saliency = Enlarge(saliency, options.downscale, color_rgb.size());
  NormalizeL2(saliency);
  return saliency;
}

}  // namespace fovea
