#include "core/segmentation/mean_color.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "core/segmentation/labels.h"
#include "core/types/lab.h"

namespace fovea {
namespace {

// The weights of colours were fitted to frames whose light places have at least this lightness and
// that are not grey.
constexpr double kLightShare = 0.95;  // of the pixels are darker than the light places
constexpr double kMinLightness = 50;
constexpr double kMaxGain = 4;  // in darker frames there is mostly noise
constexpr double kGreyChroma = 4;
constexpr double kGreyGain = 1.75;  // of differences in lightness alone

constexpr double kUnitsOfL = 2.55;  // OpenCV scales L to 255, and a and b to 128 ± 127
constexpr int kNeutral = 128;

// The value that a share of the histogram lies below.
int Quantile(const std::array<int, 256>& histogram, double share) {
  const double total = std::accumulate(histogram.begin(), histogram.end(), 0.0);
  double below = 0;
  int value = 0;
  for (; value < 255 && below + histogram[value] < share * total; ++value) {
    below += histogram[value];
  }
  return value;
}

// By how much colours are farther apart than they look, in a frame that is dark or grey.
double ColorGain(const cv::Mat& lab) {
  std::array<int, 256> lightness{}, chroma{};
  for (int row = 0; row < lab.rows; ++row) {
    const cv::Vec3b* color = lab.ptr<cv::Vec3b>(row);
    for (int col = 0; col < lab.cols; ++col) {
      ++lightness[color[col][0]];
      ++chroma[std::max(std::abs(color[col][1] - kNeutral), std::abs(color[col][2] - kNeutral))];
    }
  }
  const double light = Quantile(lightness, kLightShare) / kUnitsOfL;
  const double gain = std::clamp(kMinLightness / std::max(light, 1.0), 1.0, kMaxGain);
  const bool is_grey = gain * Quantile(chroma, kLightShare) < kGreyChroma;
  return is_grey ? kGreyGain * gain : gain;
}

}  // namespace

std::vector<MeanColor> ColorsOfVoxels(const VoxelGrid& grid, const std::vector<int>& labels,
                                      const cv::Mat& color_rgb) {
  std::vector<MeanColor> colors(grid.voxels.size());
  const cv::Rect bounds = cv::boundingRect(LabelImage(grid, labels) != 0);
  if (bounds.empty()) return colors;
  const cv::Mat lab = LabOf(color_rgb(bounds));
  const double gain = ColorGain(lab);
  const cv::Mat voxel_of_pixel = grid.voxel_of_pixel(bounds);
  for (int row = 0; row < lab.rows; ++row) {
    const int* voxel = voxel_of_pixel.ptr<int>(row);
    const cv::Vec3b* color = lab.ptr<cv::Vec3b>(row);
    for (int col = 0; col < lab.cols; ++col) {
      if (voxel[col] < 0) continue;
      const Eigen::Vector3d c(color[col][0] / kUnitsOfL, color[col][1], color[col][2]);
      colors[voxel[col]].Add({gain * c, 1});
    }
  }
  return colors;
}

}  // namespace fovea
