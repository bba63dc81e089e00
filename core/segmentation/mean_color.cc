#include "core/segmentation/mean_color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <opencv2/core.hpp>

#include "core/types/interruption.h"

namespace fovea {
namespace {

constexpr double kLightnessWeight = 0.5;
constexpr double kUnit = 66;  // L + 16 where L is 50

// The weights of colours were fitted to frames that are not grey.
constexpr double kColorfulShare = 0.05;  // of the pixels have at least
constexpr double kGreyChroma = 4;        // in frames that are not grey

constexpr double kUnitsOfL = 2.55;  // OpenCV scales L to 255, and a and b to 128 ± 127
constexpr int kNeutral = 128;

// Of CIELAB as OpenCV scales it, to the colours of the header.
class ColorTable {
 public:
  ColorTable() {
    for (int value = 0; value < 256; ++value) {
      const double light = value / kUnitsOfL + 16;
      lightness_[value] = kLightnessWeight * kUnit * std::log(light / kUnit);
      chroma_scale_[value] = kUnit / light;
      int chroma = 0;
      while (chroma_scale_[value] * chroma < kGreyChroma) ++chroma;
      min_colorful_[value] = chroma;
    }
  }

  Eigen::Vector3d Of(const cv::Vec3b& lab) const {
    const double scale = chroma_scale_[lab[0]];
    return {lightness_[lab[0]], scale * (lab[1] - kNeutral), scale * (lab[2] - kNeutral)};
  }
  bool IsColorful(const cv::Vec3b& lab) const {
    const int chroma = std::max(std::abs(lab[1] - kNeutral), std::abs(lab[2] - kNeutral));
    return chroma >= min_colorful_[lab[0]];
  }

 private:
  std::array<double, 256> lightness_, chroma_scale_;
  std::array<int, 256> min_colorful_;
};

const ColorTable& Table() {
  static const ColorTable table;
  return table;
}

bool IsGrey(const cv::Mat& lab) {
  const ColorTable& table = Table();
  const double enough = kColorfulShare * static_cast<double>(lab.total());
  std::size_t num_colorful = 0;
  for (int row = 0; row < lab.rows; ++row) {
    if (static_cast<double>(num_colorful) >= enough) return false;
    const cv::Vec3b* pixel = lab.ptr<cv::Vec3b>(row);
    for (int col = 0; col < lab.cols; ++col) num_colorful += table.IsColorful(pixel[col]) ? 1 : 0;
  }
  return static_cast<double>(num_colorful) < enough;
}

// Adds the pixels first … end - 1 of a row to a voxel's.
void AddPixels(const cv::Vec3b* lab, int first, int end, MeanColor& color) {
  const ColorTable& table = Table();
  Eigen::Vector3d sum = color.sum;
  for (int col = first; col < end; ++col) sum += table.Of(lab[col]);
  color.sum = sum;
  color.num_pixels += end - first;
}

}  // namespace

std::vector<MeanColor> ColorsOfVoxels(const VoxelGrid& grid, const cv::Mat& lab) {
  std::vector<MeanColor> colors(grid.voxels.size());
  for (int row = 0; row < lab.rows; ++row) {
    InterruptionPoint();
    const int* voxel = grid.voxel_of_pixel.ptr<int>(row);
    const cv::Vec3b* pixel = lab.ptr<cv::Vec3b>(row);
    for (int first = 0, end = 1; first < lab.cols; first = end++) {
      while (end < lab.cols && voxel[end] == voxel[first]) ++end;
      if (voxel[first] >= 0) AddPixels(pixel, first, end, colors[voxel[first]]);
    }
  }
  if (IsGrey(lab)) {
    for (MeanColor& color : colors) color.is_grey = true;
  }
  return colors;
}

}  // namespace fovea
