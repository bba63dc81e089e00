#include "core/segmentation/mean_color.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <opencv2/imgproc.hpp>

#include "core/types/interruption.h"
#include "core/types/lab.h"

namespace fovea {
namespace {

constexpr double kLightnessWeight = 0.5;
constexpr double kUnit = 66;  // L + 16 where L is 50

// The weights of colours were fitted to frames that are not grey.
constexpr double kColorfulShare = 0.05;  // of the pixels have at least
constexpr double kGreyChroma = 4;        // in frames that are not grey
constexpr double kGreyGain = 3;

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
    }
  }

  Eigen::Vector3d Of(const cv::Vec3b& lab) const {
    const double scale = chroma_scale_[lab[0]];
    return {lightness_[lab[0]], scale * (lab[1] - kNeutral), scale * (lab[2] - kNeutral)};
  }

 private:
  std::array<double, 256> lightness_, chroma_scale_;
};

}  // namespace

std::vector<MeanColor> ColorsOfVoxels(const VoxelGrid& grid, const cv::Mat& color_rgb) {
  std::vector<MeanColor> colors(grid.voxels.size());
  static const ColorTable table;
  const cv::Mat lab = LabOf(color_rgb);
  InterruptionPoint();
  std::size_t num_colorful = 0;
  for (int row = 0; row < lab.rows; ++row) {
    InterruptionPoint();
    const int* voxel = grid.voxel_of_pixel.ptr<int>(row);
    const cv::Vec3b* pixel = lab.ptr<cv::Vec3b>(row);
    for (int col = 0; col < lab.cols; ++col) {
      const Eigen::Vector3d color = table.Of(pixel[col]);
      if (color.tail<2>().cwiseAbs().maxCoeff() >= kGreyChroma) ++num_colorful;
      if (voxel[col] >= 0) colors[voxel[col]].Add({color, 1});
    }
  }
  if (static_cast<double>(num_colorful) < kColorfulShare * static_cast<double>(lab.total())) {
    for (MeanColor& color : colors) color.sum *= kGreyGain;
  }
  return colors;
}

}  // namespace fovea
