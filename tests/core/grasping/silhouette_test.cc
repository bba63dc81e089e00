// A box of 0.2 m before a wall 2 m away; its front, 1 m away, is 40 pixels wide and high.
#include "core/grasping/silhouette.h"

#include <gtest/gtest.h>

#include <limits>
#include <opencv2/core.hpp>

namespace fovea {
namespace {

struct SeenBox {
  cv::Mat points = cv::Mat(80, 80, CV_32FC3, cv::Scalar(0, 0, 2));
  cv::Mat labels = cv::Mat::zeros(80, 80, CV_16UC1);
  CameraIntrinsics intrinsics = {200, 200, 39.5, 39.5};
  DetectedObject object;

  SeenBox() {
    object.label = 1;
    object.shape.kind = Shape::Kind::kBox;
    object.box.rotation.setIdentity();
    object.box.center = {0, 0, 1.1F};
    object.box.size_m.setConstant(0.2F);
    See({20, 20, 40, 40});
  }
  void See(const cv::Rect& at) {
    points(at).setTo(cv::Scalar(0, 0, 1));
    labels(at).setTo(1);
    object.bounds_px = at;
  }
  Silhouette Get() const {
    return SilhouetteOf({points, labels, intrinsics, -Eigen::Vector3f::UnitY()}, object);
  }
};

TEST(Silhouette, OfWhatFillsItsSolidIsWhole) {
  const Silhouette whole = SeenBox().Get();
  EXPECT_EQ(whole.seen_through, 0);
  EXPECT_EQ(whole.beside, 0);
}

TEST(Silhouette, IsSeenThroughWhereTheWallBehindIsSeen) {
  SeenBox box;
  box.points(cv::Rect(50, 20, 10, 40)).setTo(cv::Scalar(0, 0, 2));
  box.labels(cv::Rect(50, 20, 10, 40)).setTo(0);
  EXPECT_FLOAT_EQ(box.Get().seen_through, 0.25F);
  EXPECT_EQ(box.Get().beside, 0);
}

TEST(Silhouette, IsNotSeenThroughWhereSomethingNearerHidesIt) {
  SeenBox box;
  box.labels(cv::Rect(40, 20, 10, 40)).setTo(2);
  box.points(cv::Rect(40, 20, 10, 40)).setTo(cv::Scalar(0, 0, 0.8));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  box.labels(cv::Rect(50, 20, 10, 40)).setTo(0);
  box.points(cv::Rect(50, 20, 10, 40)).setTo(cv::Scalar(nan, nan, nan));
  EXPECT_EQ(box.Get().seen_through, 0);
}

TEST(Silhouette, HasPixelsBesideASolidThatIsTooSmall) {
  SeenBox box;
  box.See({20, 20, 40, 50});
  EXPECT_FLOAT_EQ(box.Get().beside, 0.2F);
}

}  // namespace
}  // namespace fovea
