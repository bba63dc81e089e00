#include "core/depth/normals.h"

#include <gtest/gtest.h>
#include <pcl/features/normal_3d.h>

#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <random>
#include <vector>

#include "core/depth/back_projection.h"

namespace fovea {
namespace {

const CameraIntrinsics kCamera{.fx_px = 100, .fy_px = 110, .cx_px = 30, .cy_px = 20};

// Depth of the plane n·x = d.
cv::Mat PlaneDepth(const cv::Vec3d& n, double d) {
  cv::Mat depth(41, 61, CV_32FC1);
  for (int row = 0; row < depth.rows; ++row) {
    for (int col = 0; col < depth.cols; ++col) {
      const cv::Vec3d ray((col - kCamera.cx_px) / kCamera.fx_px,
                          (row - kCamera.cy_px) / kCamera.fy_px, 1);
      depth.at<float>(row, col) = static_cast<float>(d / n.dot(ray));
    }
  }
  return depth;
}

TEST(EstimateNormals, IsExactOnAPlane) {
  const cv::Vec3d n = cv::normalize(cv::Vec3d(0.2, -0.6, -0.7));
  const cv::Mat points = BackProject(PlaneDepth(n, -0.9), kCamera, 10);
  for (const int sample_px : {1, 2}) {
    // Steep to the camera, the plane's depth changes much within the distance of two samples.
    const NormalOptions options{.sample_px = sample_px, .max_depth_change = 0.02 * sample_px};
    const cv::Mat normals = EstimateNormals(points, kCamera, options).vectors;
    for (int row = 0; row < points.rows; ++row) {
      for (int col = 0; col < points.cols; ++col) {
        EXPECT_GT(normals.at<cv::Vec3f>(row, col).dot(cv::Vec3f(n)), 0.9999F)
            << sample_px << " " << row << " " << col;
      }
    }
  }
}

TEST(EstimateNormals, PointTowardsTheCamera) {
  for (const double sign : {-1.0, 1.0}) {
    const cv::Vec3d n = sign * cv::normalize(cv::Vec3d(0.1, 0.2, 1));
    const cv::Mat points = BackProject(PlaneDepth(n, sign), kCamera, 10);
    EXPECT_LT(EstimateNormals(points, kCamera).vectors.at<cv::Vec3f>(20, 30)[2], -0.9F);
  }
}

TEST(EstimateNormals, DoesNotMixSurfacesAcrossADepthStep) {
  cv::Mat depth = PlaneDepth({0, 0, -1}, -1.0);
  depth.colRange(30, 61).setTo(1.5F);
  const cv::Mat normals = EstimateNormals(BackProject(depth, kCamera, 10), kCamera).vectors;
  for (int col = 26; col < 34; ++col) EXPECT_LT(normals.at<cv::Vec3f>(20, col)[2], -0.9999F);
}

TEST(EstimateNormals, HasNoneWhereThereIsNoDepthOrOnlyALine) {
  cv::Mat depth(9, 9, CV_32FC1, cv::Scalar(std::numeric_limits<float>::quiet_NaN()));
  depth.row(4).setTo(1.0F);
  const cv::Mat normals = EstimateNormals(BackProject(depth, kCamera, 10), kCamera).vectors;
  for (int row = 0; row < 9; ++row) EXPECT_TRUE(std::isnan(normals.at<cv::Vec3f>(row, 4)[0]));
}

TEST(EstimateNormals, WithAStepEqualsTheDenseResultOnItsGrid) {
  cv::Mat depth = PlaneDepth({0.1, -0.5, -0.8}, -0.9);
  cv::Mat near = depth(cv::Rect(10, 10, 15, 12));
  near *= 0.9;
  const cv::Mat points = BackProject(depth, kCamera, 10);
  for (const int sample_px : {1, 2}) {
    const cv::Mat dense = EstimateNormals(points, kCamera, {.sample_px = sample_px}).vectors;
    for (const int step : {2, 3, 4}) {
      const NormalMap sparse =
          EstimateNormals(points, kCamera, {.sample_px = sample_px, .step_px = step});
      EXPECT_EQ(sparse.step_px, step);
      ASSERT_EQ(sparse.vectors.size(), cv::Size((60 + step) / step, (40 + step) / step));
      for (int row = 0; row < sparse.vectors.rows; ++row) {
        for (int col = 0; col < sparse.vectors.cols; ++col) {
          EXPECT_EQ(sparse.vectors.at<cv::Vec3f>(row, col),
                    dense.at<cv::Vec3f>(row * step, col * step))
              << sample_px << " " << step << ": " << row << " " << col;
        }
      }
    }
  }
}

// The reference fits orthogonal distances to the points; on a noisy but gently curved surface both
// fits agree within degrees.
TEST(EstimateNormals, AgreesWithPclOnANoisySphere) {
  const unsigned seed = 7;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  cv::Mat depth(41, 61, CV_32FC1);
  for (int row = 0; row < depth.rows; ++row) {
    for (int col = 0; col < depth.cols; ++col) {
      const double x = (col - kCamera.cx_px) / 100;
      const double y = (row - kCamera.cy_px) / 100;
      const double noise = (static_cast<double>(random() % 1001) / 1000 - 0.5) * 2e-4;
      depth.at<float>(row, col) = static_cast<float>(1.5 - std::sqrt(1 - x * x - y * y) + noise);
    }
  }
  const cv::Mat points = BackProject(depth, kCamera, 10);
  const cv::Mat normals = EstimateNormals(points, kCamera).vectors;

  pcl::PointCloud<pcl::PointXYZ> cloud;
  for (int i = 0; i < static_cast<int>(points.total()); ++i) {
    const cv::Vec3f& p = points.at<cv::Vec3f>(i / points.cols, i % points.cols);
    cloud.push_back({p[0], p[1], p[2]});
  }
  for (int row = 3; row < 38; row += 5) {
    for (int col = 3; col < 58; col += 5) {
      pcl::Indices window;
      for (int dv = -3; dv <= 3; ++dv) {
        for (int du = -3; du <= 3; ++du) window.push_back((row + dv) * points.cols + col + du);
      }
      Eigen::Vector4f plane;
      float curvature = 0;
      ASSERT_TRUE(pcl::computePointNormal(cloud, window, plane, curvature));
      const cv::Vec3f& n = normals.at<cv::Vec3f>(row, col);
      const float agreement = std::abs(plane.head<3>().dot(Eigen::Vector3f(n[0], n[1], n[2])));
      EXPECT_GT(agreement, std::cos(3 * CV_PI / 180)) << row << " " << col;
    }
  }
}

}  // namespace
}  // namespace fovea
