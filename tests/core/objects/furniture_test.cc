#include "core/objects/furniture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/objects/plausibility.h"

namespace fovea {
namespace {

const Eigen::Vector3f kUp = -Eigen::Vector3f::UnitY();
constexpr SupportOptions kSupport{.tolerance_m = 0.002};

// What a level camera half a metre above the floor sees: a segment, 0 = none, and a depth in every
// pixel, which is 2 cm wide 2 m away.
struct View {
  cv::Mat segments{60, 40, CV_8UC1, cv::Scalar(0)};
  cv::Mat z_m{60, 40, CV_32FC1, cv::Scalar(3.5)};

  void Add(int label, const cv::Rect& pixels, float z) {
    segments(pixels).setTo(label);
    z_m(pixels).setTo(z);
  }
  // Whether each of the labels stays.
  std::vector<bool> Stay(int num_labels) const {
    constexpr CameraIntrinsics kCamera{100, 100, 19.5, 19.5};
    cv::Mat points(z_m.size(), CV_32FC3);
    for (int row = 0; row < points.rows; ++row) {
      for (int col = 0; col < points.cols; ++col) {
        const float z = z_m.at<float>(row, col);
        points.at<cv::Vec3f>(row, col) = {(static_cast<float>(col) - 19.5F) / 100 * z,
                                          (static_cast<float>(row) - 19.5F) / 100 * z, z};
      }
    }
    const cv::Mat normals(points.size(), CV_32FC3, cv::Scalar(0, 0, -1));
    const VoxelGrid grid = BuildVoxelGrid(points, {normals}, {.size_m = 0.02});
    std::vector<int> labels(grid.voxels.size(), 0);
    for (int row = 0; row < points.rows; ++row) {
      for (int col = 0; col < points.cols; ++col) {
        labels[grid.voxel_of_pixel.at<int>(row, col)] = segments.at<uchar>(row, col);
      }
    }
    const Support floor{{kUp, 0.5F, 1}, Footprint()};
    const auto plausible =
        RemoveImplausible(grid, labels, points, kCamera, {floor}, kSupport, {.max_height_m = 0.4});
    std::vector<bool> stay;
    for (int label = 1; label <= num_labels; ++label) {
      stay.push_back(std::count(plausible.labels.begin(), plausible.labels.end(), label) > 0);
    }
    return stay;
  }
};

// A segment 27 to 49 cm above the floor, and something below it.
View WithSegmentAbove(float below_m) {
  View view;
  view.Add(1, {10, 20, 20, 12}, 2);
  view.Add(0, {0, 32, 40, 8}, below_m);
  return view;
}

TEST(Furniture, CountsTheHeightFromTheSupportWhereNothingIsSeenBelow) {
  EXPECT_FALSE(WithSegmentAbove(1).Stay(1)[0]) << "something in front hides it";
  EXPECT_FALSE(WithSegmentAbove(3).Stay(1)[0]) << "one sees past";
  EXPECT_TRUE(WithSegmentAbove(2).Stay(1)[0]) << "it may stand on that";
}

TEST(Furniture, RemovesAStoolWithTheLegsThatItTouches) {
  View view;
  view.Add(1, {8, 20, 24, 3}, 2);  // the seat,
  view.Add(1, {8, 23, 3, 5}, 2);   // with the upper ends
  view.Add(1, {29, 23, 3, 5}, 2);  // of its legs
  view.Add(2, {8, 28, 3, 16}, 2);  // and their lower ones
  view.Add(3, {29, 28, 3, 16}, 2);
  view.Add(4, {16, 36, 8, 8}, 2);   // a box between them
  view.Add(5, {32, 34, 6, 10}, 2);  // a box that touches a leg
  EXPECT_EQ(view.Stay(5), (std::vector<bool>{false, false, false, true, true}));
}

}  // namespace
}  // namespace fovea
