#include "core/segmentation/stability_merge.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "core/segmentation/labels.h"

namespace fovea {
namespace {

const Eigen::Vector3f kUp = -Eigen::Vector3f::UnitY();
constexpr CameraIntrinsics kCamera{500, 500, 99.5, 99.5};
constexpr float kTable_m = 0.19F;  // below the optical axis
constexpr StabilityMergeOptions kOptions{.max_overhang_m = 0.01};

// A post, label 2, that stands on a table 1 m away and carries a beam, label 1; a wall at 1.5 m.
class Scene {
 public:
  // The beam's extent along x; metres.
  Scene(float left_m, float right_m) : points_(200, 200, CV_32FC3) {
    labels_ = cv::Mat::zeros(200, 200, CV_32SC1);
    Paint({0, 0, 200, 200}, 1.5F, 0);
    Paint({95, 120, 10, 75}, 1, 2);
    const int left = cvRound(99.5F + 500 * left_m);
    Paint({left, 100, cvRound(99.5F + 500 * right_m) - left, 20}, 1, 1);
  }

  void Paint(const cv::Rect& area, float z, int label) {
    for (int row = area.y; row < area.br().y; ++row) {
      for (int col = area.x; col < area.br().x; ++col) {
        points_.at<cv::Vec3f>(row, col) = {(static_cast<float>(col) - 99.5F) / 500 * z,
                                           (static_cast<float>(row) - 99.5F) / 500 * z, z};
        labels_.at<int>(row, col) = label;
      }
    }
  }

  std::size_t SegmentsLeft(const std::vector<Support>& supports = {{{kUp, kTable_m, 1}, {}}},
                           const StabilityMergeOptions& options = kOptions) const {
    const cv::Mat normals(200, 200, CV_32FC3, cv::Scalar(0, 0, -1));
    const VoxelGrid grid = BuildVoxelGrid(points_, {normals}, {.size_m = 0.01});
    std::vector<int> labels(grid.voxels.size());
    for (int i = 0; i < 200 * 200; ++i) {
      labels[grid.voxel_of_pixel.at<int>(i / 200, i % 200)] = labels_.at<int>(i / 200, i % 200);
    }
    return CountLabels(MergeUnstable(grid, labels, points_, kCamera, supports, {}, kUp, options));
  }

 private:
  cv::Mat points_;
  cv::Mat labels_;
};

TEST(MergeUnstable, JoinsWhatWouldFallWithWhatHoldsIt) {
  EXPECT_EQ(Scene(-0.02F, 0.1F).SegmentsLeft(), 1U);
  EXPECT_EQ(Scene(-0.1F, 0.02F).SegmentsLeft(), 1U);
}

TEST(MergeUnstable, LeavesWhatIsInBalance) { EXPECT_EQ(Scene(-0.1F, 0.1F).SegmentsLeft(), 2U); }

TEST(MergeUnstable, LeavesWhatMayRestOnSomethingHidden) {
  Scene scene(-0.02F, 0.1F);
  scene.Paint({105, 120, 95, 75}, 0.9F, 0);  // in front of what may carry the beam
  EXPECT_EQ(scene.SegmentsLeft(), 2U);
}

TEST(MergeUnstable, LeavesWhatRestsOnASurface) {
  const Scene scene(-0.02F, 0.1F);
  EXPECT_EQ(scene.SegmentsLeft({{{kUp, 0.05F, 1}, {}}}), 2U);  // right below the beam
}

TEST(MergeUnstable, LeavesWhatTouchesNothing) {
  Scene scene(-0.02F, 0.1F);
  scene.Paint({90, 120, 20, 20}, 1.5F, 0);
  EXPECT_EQ(scene.SegmentsLeft(), 2U);
}

TEST(MergeUnstable, NeedsASurfaceAndALimit) {
  const Scene scene(-0.02F, 0.1F);
  EXPECT_EQ(scene.SegmentsLeft({}), 2U);
  EXPECT_EQ(scene.SegmentsLeft({{{kUp, kTable_m, 1}, {}}}, {.max_overhang_m = 0}), 2U);
}

}  // namespace
}  // namespace fovea
