// Depth registered from a second camera against the depth that the colour camera itself would see.
#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <string>
#include <tuple>

#include "core/depth/registration.h"
#include "tests/support/depth_camera.h"
#include "tests/support/random_scene.h"
#include "tests/support/render.h"

namespace fovea {
namespace {

using scenes::DepthCamera;
using scenes::Scene;
using scenes::SensorKind;

struct Comparison {
  double covered = 0;  // share of the colour pixels with true depth that have registered depth
  double right = 0;    // share of the covered ones that are within 5 mm + 0.5 % of the truth
  double bridged = 0;  // share of the covered ones at a depth that no pixel around has
  double holes = 0;    // share of the colour pixels without depth though the depth camera sees them
};

bool IsClose(float a, float b) { return std::abs(a - b) < 0.005F + 0.005F * a; }

bool IsNear(const cv::Mat& truth, int x, int y, float z, int reach) {
  const cv::Rect around =
      cv::Rect(x - reach, y - reach, 2 * reach + 1, 2 * reach + 1) & cv::Rect({}, truth.size());
  return cv::countNonZero(cv::abs(truth(around) - z) < 0.005 + 0.005 * z) > 0;
}

// Whether the point at depth `z` of a colour pixel lies on the surface that the depth camera sees.
bool IsSeen(int x, int y, float z, const CameraIntrinsics& color, const DepthCamera& camera,
            const cv::Mat& depth) {
  const Eigen::Vector3d point((x - color.cx_px) / color.fx_px * z,
                              (y - color.cy_px) / color.fy_px * z, z);
  const Eigen::Vector3d p = camera.color_from_depth.inverse() * point;
  const cv::Point pixel(cvRound(p.x() / p.z() * camera.intrinsics.fx_px + camera.intrinsics.cx_px),
                        cvRound(p.y() / p.z() * camera.intrinsics.fy_px + camera.intrinsics.cy_px));
  return cv::Rect({}, depth.size()).contains(pixel) &&
         IsClose(static_cast<float>(p.z()), depth.at<float>(pixel));
}

Comparison Compare(const Scene& scene, const DepthCamera& camera) {
  constexpr int kReach_px = 6;  // three pixels of the coarsest depth
  const CameraIntrinsics& color = scene.camera.intrinsics;
  const cv::Mat truth = scenes::RenderDepth(scene);
  const cv::Mat depth = scenes::RenderDepth(scenes::SeenBy(camera, scene));
  const cv::Mat registered =
      RegisterDepth(depth, camera.intrinsics, camera.color_from_depth, color, truth.size());
  int covered = 0, right = 0, bridged = 0, holes = 0;
  for (int y = 0; y < truth.rows; ++y) {
    for (int x = 0; x < truth.cols; ++x) {
      const float z = registered.at<float>(y, x), true_z = truth.at<float>(y, x);
      if (std::isnan(z)) {
        holes += !std::isnan(true_z) && IsSeen(x, y, true_z, color, camera, depth);
        continue;
      }
      ++covered;
      right += IsClose(z, true_z);
      bridged += !IsNear(truth, x, y, z, kReach_px);
    }
  }
  const double all = cv::countNonZero(truth == truth), some = covered;
  return {some / all, right / some, bridged / some, holes / all};
}

class RegisteredScene : public testing::TestWithParam<std::tuple<std::string, cv::Size>> {};

TEST_P(RegisteredScene, IsWhatTheColorCameraSees) {
  const auto& [kind, depth_size] = GetParam();
  const Scene scene = scenes::RandomScene(kind, 3, {640, 480});
  const DepthCamera camera = scenes::DepthCameraBeside(0.025, depth_size);
  const Comparison found = Compare(scene, camera);
  EXPECT_GT(found.covered, 0.985);  // the rest is hidden from the depth camera
  EXPECT_GT(found.right, 0.99);     // edges are where the depth pixels end
  EXPECT_LT(found.bridged, 1e-4);
  EXPECT_LT(found.holes, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Scenes, RegisteredScene,
                         testing::Combine(testing::Values("tabletop", "cluttered", "room"),
                                          testing::Values(cv::Size(320, 240), cv::Size(512, 424),
                                                          cv::Size(1280, 960))),
                         [](const auto& test) {
                           return std::get<0>(test.param) + "_" +
                                  std::to_string(std::get<1>(test.param).width);
                         });

}  // namespace
}  // namespace fovea
