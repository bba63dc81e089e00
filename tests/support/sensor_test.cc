// The sensors against the noise that their sources state.
#include "tests/support/sensor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

#include "tests/support/environment.h"
#include "tests/support/labelled_frame.h"
#include "tests/support/random_scene.h"

namespace fovea::scenes {

// Where gtest looks for it.
inline void PrintTo(SensorKind kind, std::ostream* out) {
  *out << (kind == SensorKind::kKinect       ? "Kinect"
           : kind == SensorKind::kHaloStereo ? "halo stereo"
                                             : "RealSense");
}

namespace {

// A wall at right angles to the optical axis.
Scene WallAt(double depth_m) {
  const Material paint = {Pattern::kNoise, {0.7, 0.7, 0.7}, {0.2, 0.2, 0.2}, 0.01, 1};
  Scene scene;
  scene.bodies = {Block("wall", {0, depth_m + 0.05, 0}, {20, 0.1, 20}, paint)};
  scene.camera = CameraOfSize({320, 240});
  scene.camera.world_from_camera = LookAt({0, depth_m, 0}, depth_m, 0, 0, 0);
  scene.light.towards = -Eigen::Vector3d::UnitY();
  return scene;
}

double Focal(const Scene& scene) { return scene.camera.intrinsics.fx_px; }

class SensorNoise : public testing::TestWithParam<std::tuple<SensorKind, double>> {};

TEST_P(SensorNoise, HasTheStatedDeviationAndNoBias) {
  const auto [sensor, depth_m] = GetParam();
  const Scene scene = WallAt(depth_m);
  const cv::Mat measured =
      MeasureDepth(Render(scene, BaselineOf(sensor)), sensor, Focal(scene), 11);
  cv::Scalar mean, deviation;
  cv::meanStdDev(measured, mean, deviation, measured == measured);
  const double expected = DepthNoise_m(sensor, depth_m, Focal(scene));
  EXPECT_NEAR(deviation[0], expected, 0.15 * expected);
  EXPECT_NEAR(mean[0], depth_m, 0.25 * expected);
}

INSTANTIATE_TEST_SUITE_P(All, SensorNoise,
                         testing::Combine(testing::Values(SensorKind::kKinect,
                                                          SensorKind::kRealSense,
                                                          SensorKind::kHaloStereo),
                                          testing::Values(0.8, 1.5, 3.0)));

TEST(Sensor, KinectNoiseAgreesWithNguyen2012) {
  for (const double z : {1.0, 1.5, 2.0, 3.0}) {
    const double nguyen_m = 0.0012 + 0.0019 * (z - 0.4) * (z - 0.4);
    EXPECT_NEAR(DepthNoise_m(SensorKind::kKinect, z, 525), nguyen_m, 0.15 * nguyen_m) << z;
  }
}

TEST(Sensor, KinectDepthComesInStepsOfDisparity) {
  const Scene scene = WallAt(2);
  const cv::Mat measured = MeasureDepth(Render(scene, BaselineOf(SensorKind::kKinect)),
                                        SensorKind::kKinect, Focal(scene), 1);
  for (int x = 0; x < measured.cols; ++x) {
    const float depth = measured.at<float>(100, x);
    const double steps = std::round(348.0 / depth);
    EXPECT_NEAR(depth, 348.0 / steps, 0.0006) << "in whole millimetres";
  }
}

TEST(Sensor, IdealDepthIsTheRenderedDepth) {
  const Rendering rendering = Render(RandomScene("tabletop", 5, {160, 120}));
  const cv::Mat measured = MeasureDepth(rendering, SensorKind::kIdeal, 131, 1);
  const cv::Mat equal = measured == rendering.depth_m, known = measured == measured;
  EXPECT_GT(cv::countNonZero(known), 10000);
  EXPECT_EQ(cv::countNonZero(equal), cv::countNonZero(known));
}

class SensorHoles : public testing::TestWithParam<SensorKind> {};

TEST_P(SensorHoles, LieWhereTheSecondViewIsBlockedAndTakeAPlausibleShare) {
  const Scene scene = RandomScene("cluttered", 5, {320, 240});
  const Rendering rendering = Render(scene, BaselineOf(GetParam()));
  const cv::Mat missing = [&] {
    const cv::Mat depth_m = MeasureDepth(rendering, GetParam(), Focal(scene), 1);
    return cv::Mat(~(depth_m == depth_m));
  }();
  EXPECT_GT(cv::countNonZero(rendering.in_second_view == 0), 50);
  EXPECT_EQ(cv::countNonZero((rendering.in_second_view == 0) & ~missing), 0);
  const double share = cv::countNonZero(missing) / double(missing.total());
  EXPECT_GT(share, 0.005);
  EXPECT_LT(share, 0.3);
}

TEST_P(SensorHoles, ShadowFallsToTheLeftOfAnObject) {
  Scene scene = WallAt(1.5);
  scene.bodies.push_back(Block("post", {0, 1.0, 0}, {0.1, 0.1, 5}, {}));
  const cv::Mat seen = Render(scene, BaselineOf(GetParam())).in_second_view;
  const int middle = seen.cols / 2;
  EXPECT_GT(cv::countNonZero(seen.row(120).colRange(0, middle) == 0), 3);
  EXPECT_EQ(cv::countNonZero(seen.row(120).colRange(middle, seen.cols) == 0), 0);
}

INSTANTIATE_TEST_SUITE_P(All, SensorHoles,
                         testing::Values(SensorKind::kKinect, SensorKind::kRealSense,
                                         SensorKind::kHaloStereo));

// A box of 60 mm on a table, seen from above: between its edge and the table the depth slopes.
TEST(Sensor, HaloesSlopeFromAnObjectToTheTableAndLeaveBothAsTheyAre) {
  Scene scene = WallAt(0.7);
  scene.camera = CameraOfSize({640, 480});
  scene.camera.world_from_camera = LookAt({0, 0.7, 0}, 0.7, 0, 0, 0);
  scene.bodies.push_back(Block("box", {0, 0.67, 0}, {0.2, 0.06, 0.2}, scene.bodies[0].material));
  const Rendering rendering = Render(scene, BaselineOf(SensorKind::kHaloStereo));
  const cv::Mat depth_m = MeasureDepth(rendering, SensorKind::kHaloStereo, Focal(scene), 3);
  const cv::Mat row = depth_m.row(240);
  int edge = 320;  // the first pixel of the table to the right of the box
  while (rendering.depth_m.at<float>(240, edge) < 0.68) ++edge;
  EXPECT_NEAR(row.at<float>(edge - 20), 0.64, 0.006);
  EXPECT_NEAR(row.at<float>(edge + 20), 0.70, 0.006);
  EXPECT_LT(row.at<float>(edge + 2), 0.67) << "the box reaches beyond its edge";
  int sloping = 0;
  for (int x = edge; x < edge + 16; ++x) {
    sloping += row.at<float>(x) > 0.65 && row.at<float>(x) < 0.69;
  }
  EXPECT_GE(sloping, 3);
  EXPECT_LE(sloping, 12);
}

}  // namespace
}  // namespace fovea::scenes
