#include "core/segmentation/segment_color.h"

#include "core/segmentation/labels.h"
#include "core/types/lab.h"

namespace fovea {

std::vector<SegmentColor> ColorsOfSegments(const VoxelGrid& grid, const std::vector<int>& labels,
                                           const cv::Mat& color_rgb) {
  const cv::Mat lab = LabOf(color_rgb);
  std::vector<SegmentColor> colors(CountLabels(labels) + 1);
  for (int row = 0; row < lab.rows; ++row) {
    const int* voxel = grid.voxel_of_pixel.ptr<int>(row);
    const cv::Vec3b* color = lab.ptr<cv::Vec3b>(row);
    for (int col = 0; col < lab.cols; ++col) {
      if (voxel[col] < 0) continue;
      const cv::Vec3b& c = color[col];  // OpenCV scales L to 255; one unit of L is 2.55 there
      colors[labels[voxel[col]]].Add({{c[0] / 2.55, double(c[1]), double(c[2])}, 1});
    }
  }
  return colors;
}

}  // namespace fovea
