#include "core/segmentation/mean_color.h"

#include <opencv2/imgproc.hpp>

#include "core/segmentation/labels.h"
#include "core/types/lab.h"

namespace fovea {

std::vector<MeanColor> ColorsOfVoxels(const VoxelGrid& grid, const std::vector<int>& labels,
                                      const cv::Mat& color_rgb) {
  std::vector<MeanColor> colors(grid.voxels.size());
  const cv::Rect bounds = cv::boundingRect(LabelImage(grid, labels) != 0);
  if (bounds.empty()) return colors;
  const cv::Mat lab = LabOf(color_rgb(bounds));
  const cv::Mat voxel_of_pixel = grid.voxel_of_pixel(bounds);
  for (int row = 0; row < lab.rows; ++row) {
    const int* voxel = voxel_of_pixel.ptr<int>(row);
    const cv::Vec3b* color = lab.ptr<cv::Vec3b>(row);
    for (int col = 0; col < lab.cols; ++col) {
      if (voxel[col] < 0) continue;
      const cv::Vec3b& c = color[col];  // OpenCV scales L to 255; one unit of L is 2.55 there
      colors[voxel[col]].Add({{c[0] / 2.55, double(c[1]), double(c[2])}, 1});
    }
  }
  return colors;
}

}  // namespace fovea
