#include "client/cli/lens.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

#include "client/cli/depth_points.h"
#include "client/images.h"
#include "core/lens/lens.h"

namespace fovea::cli {
namespace {

const cv::Size kSize{160, 120};

v1::CameraIntrinsics Camera(const std::string& model, const std::vector<double>& coefficients) {
  v1::CameraIntrinsics k = client::MakeIntrinsics(130, 131, 81.5, 58.25);
  *k.mutable_distortion() = client::MakeLensDistortion(model, coefficients);
  return k;
}

const std::vector<v1::CameraIntrinsics> kCameras{
    Camera("plumb_bob", {-0.28, 0.08, 0.001, -0.002, 0}), Camera("equidistant", {0.02, 0, 0, 0})};

// The same as the server's, which is code of its own.
TEST(Lens, ProjectsAsTheServerDoes) {
  for (const v1::CameraIntrinsics& k : kCameras) {
    LensDistortion distortion;
    if (k.distortion().model() == v1::DISTORTION_MODEL_KANNALA_BRANDT) {
      distortion.model = LensDistortion::Model::kKannalaBrandt;
    }
    std::copy(k.distortion().coefficients().begin(), k.distortion().coefficients().end(),
              distortion.coefficients.begin());
    const fovea::Lens server({k.fx(), k.fy(), k.cx(), k.cy()}, distortion, kSize);
    for (const cv::Vec3d& point : {cv::Vec3d(0, 0, 1), {0.3, -0.2, 0.8}, {-1, 0.5, 2}}) {
      const cv::Point2d ideal(k.fx() * point[0] / point[2] + k.cx(),
                              k.fy() * point[1] / point[2] + k.cy());
      const cv::Point2d expected = server.Distort(ideal);
      const cv::Point2d pixel = PixelsOf({point}, k, kSize).front();
      EXPECT_LT(cv::norm(pixel - expected), 1e-6) << pixel << expected;
    }
  }
}

TEST(Lens, RaysMeetTheirPixels) {
  for (const v1::CameraIntrinsics& k : kCameras) {
    const cv::Mat rays = RaysOf(k, kSize);
    for (int y = 0; y < kSize.height; y += 7) {
      for (int x = 0; x < kSize.width; x += 7) {
        const auto& ray = rays.at<cv::Vec2d>(y, x);
        const cv::Point2d pixel = PixelsOf({{2 * ray[0], 2 * ray[1], 2}}, k, kSize).front();
        EXPECT_LT(cv::norm(pixel - cv::Point2d(x, y)), 0.01) << x << ' ' << y;
      }
    }
  }
}

TEST(Lens, IsAPinholeWithoutCoefficients) {
  const std::vector<cv::Vec3d> point{{0.1, 0.2, 1}};
  for (const char* model : {"plumb_bob", "equidistant"}) {
    const v1::CameraIntrinsics k = Camera(model, {});
    const cv::Point2d pixel = PixelsOf(point, k, kSize).front();
    EXPECT_NEAR(pixel.x, 130 * 0.1 + 81.5, 1e-9) << model;
    EXPECT_NEAR(pixel.y, 131 * 0.2 + 58.25, 1e-9) << model;
    EXPECT_NEAR(RaysOf(k, kSize).at<cv::Vec2d>(0, 0)[0], -81.5 / 130, 1e-9) << model;
  }
}

TEST(Lens, IsAPinholeFarBesideTheImage) {
  const v1::CameraIntrinsics& k = kCameras.front();
  const cv::Point2d pixel = PixelsOf({{5, 0, 1}}, k, kSize).front();
  EXPECT_NEAR(pixel.x, 130 * 5 + 81.5, 1e-9) << "the polynomial would bring it back";
}

// A slanting plane that both cameras see.
TEST(Lens, PointsOfADepthCameraLieWhereTheColorCameraSeesThem) {
  FrameSettings settings;
  settings.intrinsics = kCameras[0];
  settings.depth_camera = {kCameras[1], client::MakePose(0.02, 0, 0, 0, 0, 0, 1)};
  cv::Mat depth(kSize, CV_16UC1);
  const cv::Mat rays = RaysOf(kCameras[1], kSize);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      depth.at<std::uint16_t>(y, x) =
          static_cast<std::uint16_t>(std::lround(1000 / (1 + 0.3 * rays.at<cv::Vec2d>(y, x)[1])));
    }
  }
  const auto points = PointsInColor(depth, settings, kSize);
  EXPECT_GT(points.size(), 10000U);
  for (const DepthPoint& point : points) {
    EXPECT_NEAR(point.position[2] + 0.3 * point.position[1], 1, 0.001);
    const cv::Point2d pixel = PixelsOf({point.position}, kCameras[0], kSize).front();
    EXPECT_LE(std::abs(pixel.x - point.pixel.x), 0.51);
    EXPECT_LE(std::abs(pixel.y - point.pixel.y), 0.51);
  }
}

}  // namespace
}  // namespace fovea::cli
