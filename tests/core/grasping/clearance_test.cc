#include "core/grasping/clearance.h"

#include <gtest/gtest.h>

#include <limits>
#include <opencv2/core.hpp>

namespace fovea {
namespace {

const CameraIntrinsics kCameraAbove{500, 500, 320, 240};

// A box of 0.06 x 0.04 x 0.1 m on a floor, seen from 1 m above the floor. A hand that is open by
// 0.08 m takes it from above, its tips 0.05 m over the floor, its palm 0.01 m under the box's top.
class TakenFromAbove {
 public:
  TakenFromAbove() {
    Add({-4, -4}, {4, 4}, 1, 0);
    Add({-0.03F, -0.02F}, {0.03F, 0.02F}, 0.92F, 1);
    DetectedObject& box = objects_.emplace_back();
    box.label = 1;
    box.box = UprightBox({0, 0, 0.96F}, {0.06F, 0.04F, 0.08F});
    grasp_.tool_center_point = {0, 0, 0.95F};
    grasp_.opening_m = 0.06F;
    grasp_.pre_grasp_opening_m = 0.08F;
  }

  // Upright against the camera.
  static OrientedBox UprightBox(const Eigen::Vector3f& center, const Eigen::Vector3f& size_m) {
    OrientedBox box;
    box.center = center;
    box.size_m = size_m;
    box.rotation << 1, 0, 0, 0, -1, 0, 0, 0, -1;
    return box;
  }

  // A level surface; metres, as far from the camera as `z`.
  void Add(const Eigen::Vector2f& low, const Eigen::Vector2f& high, float z, int label) {
    for (int row = 0; row < points_.rows; ++row) {
      for (int col = 0; col < points_.cols; ++col) {
        const float x = z * static_cast<float>(col - 320) / 500;
        const float y = z * static_cast<float>(row - 240) / 500;
        if (x < low.x() || x > high.x() || y < low.y() || y > high.y()) continue;
        points_.at<cv::Vec3f>(row, col) = {x, y, z};
        labels_.at<std::uint16_t>(row, col) = static_cast<std::uint16_t>(label);
      }
    }
  }
  void Forget(const cv::Rect& part) {
    points_(part).setTo(cv::Scalar::all(std::numeric_limits<double>::quiet_NaN()));
  }
  void AddBox(const OrientedBox& box) {
    DetectedObject& object = objects_.emplace_back();
    object.label = static_cast<int>(objects_.size());
    object.box = box;
    object.shape.kind = Shape::Kind::kBox;
  }
  Grasp& grasp() { return grasp_; }

  float Clearance() const {
    return ClearanceOf({points_, labels_, kCameraAbove, -Eigen::Vector3f::UnitZ()}, objects_, 0,
                       JawGripper{}, grasp_);
  }

 private:
  cv::Mat points_ = cv::Mat(480, 640, CV_32FC3);
  cv::Mat labels_{480, 640, CV_16UC1, cv::Scalar(0)};
  std::vector<DetectedObject> objects_;
  Grasp grasp_;
};

constexpr float kPixel_m = 0.002F;

TEST(ClearanceOf, TheObjectItselfDoesNotCount) {
  EXPECT_EQ(TakenFromAbove().Clearance(), kFarthestClearance_m);  // 10 mm under the palm
}

TEST(ClearanceOf, CountsWhatIsBesideThePalm) {
  TakenFromAbove scene;  // the palm, from 0.91 m on, is 0.105 m by 0.04 m
  scene.Add({0.0605F, -0.01F}, {0.1F, 0.01F}, 0.89F, 2);
  EXPECT_NEAR(scene.Clearance(), 0.008F, kPixel_m);
  scene.Add({-0.02F, 0.0242F}, {0.02F, 0.06F}, 0.89F, 0);
  EXPECT_NEAR(scene.Clearance(), 0.004F, kPixel_m);
}

TEST(ClearanceOf, CountsWhatIsBesideAndUnderTheFingers) {
  TakenFromAbove scene;  // from 0.04 to 0.05 m and 0.02 m wide, down to 0.95 m
  scene.Add({0.062F, -0.01F}, {0.1F, 0.01F}, 0.94F, 2);
  EXPECT_NEAR(scene.Clearance(), 0.012F, kPixel_m);
  scene.Add({-0.05F, 0.018F}, {-0.04F, 0.06F}, 0.94F, 0);  // not along the line between them
  EXPECT_NEAR(scene.Clearance(), 0.008F, kPixel_m);
  scene.Add({0.04F, -0.01F}, {0.05F, 0.01F}, 0.955F, 2);
  EXPECT_NEAR(scene.Clearance(), 0.005F, kPixel_m);
}

// Some of the pixels are looked at first: where they meet the farther of two things nearly at its
// edge and the nearer one not so, that is the nearer one still.
TEST(ClearanceOf, CountsTheNearerOfTwoThingsWhereverTheirEdgesAre) {
  for (int left = 0; left < 4; ++left) {
    for (int right = 0; right < 4; ++right) {
      TakenFromAbove scene;
      const float nearer_m = 0.006F + kPixel_m * static_cast<float>(right);
      const float farther_m = nearer_m + 0.003F + kPixel_m * static_cast<float>(left);
      scene.Add({0.0525F + nearer_m, -0.01F}, {0.1F, 0.01F}, 0.89F, 2);
      scene.Add({-0.1F, -0.01F}, {-0.0525F - farther_m, 0.01F}, 0.89F, 2);
      EXPECT_NEAR(scene.Clearance(), nearer_m, kPixel_m) << left << " " << right;
    }
  }
}

TEST(ClearanceOf, CountsWhatIsInTheWayIn) {
  TakenFromAbove scene;  // 0.1 m long, before palm and fingers
  scene.Add({0.0605F, -0.01F}, {0.1F, 0.01F}, 0.8F, 2);
  EXPECT_NEAR(scene.Clearance(), 0.008F, kPixel_m);
  scene.Add({0.03F, -0.01F}, {0.1F, 0.01F}, 0.8F, 2);
  EXPECT_EQ(scene.Clearance(), 0);
}

TEST(ClearanceOf, OnePointMayBeNoise) {
  TakenFromAbove scene;
  scene.Add({0.0445F, -0.0005F}, {0.0455F, 0.0005F}, 0.93F, 0);
  EXPECT_EQ(scene.Clearance(), kFarthestClearance_m);
}

TEST(ClearanceOf, CountsTheFloorAlsoWhereItIsNotSeen) {
  TakenFromAbove scene;
  scene.grasp().tool_center_point.z() = 0.988F;
  EXPECT_NEAR(scene.Clearance(), 0.012F, 1e-4F);
  scene.Forget({0, 0, 640, 480});
  EXPECT_NEAR(scene.Clearance(), 0.012F, 1e-4F);
  scene.Add({-4, -4}, {4, 4}, 1.1F, 0);  // there is none beside what it stands on
  EXPECT_EQ(scene.Clearance(), kFarthestClearance_m);
}

TEST(ClearanceOf, CountsWhatMayStandWhereNothingIsSeen) {
  TakenFromAbove scene;
  scene.AddBox(TakenFromAbove::UprightBox({0.1F, 0, 0.94F}, {0.08F, 0.1F, 0.12F}));
  EXPECT_EQ(scene.Clearance(), kFarthestClearance_m);  // the floor is seen there
  scene.Forget({344, 0, 640 - 344, 480});
  EXPECT_NEAR(scene.Clearance(), 0.0075F, 0.004F);  // beside the palm; by columns of 5 mm
}

}  // namespace
}  // namespace fovea
