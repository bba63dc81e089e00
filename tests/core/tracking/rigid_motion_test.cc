#include "core/tracking/rigid_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace fovea {
namespace {

constexpr CameraIntrinsics kCamera = {525, 525, 319.5, 239.5};
constexpr int kWidth_px = 640;

Eigen::Isometry3d TrueMotion() {
  return Eigen::Translation3d(0.05, -0.02, 0.03) *
         Eigen::AngleAxisd(0.06, Eigen::Vector3d(1, 2, 3).normalized());
}

// Half a pixel and 3 mm of noise; a share of the pairs is of wrong points.
std::vector<PointPair> Pairs(int count, double wrong, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() % 100001) / 100000;
  };
  std::vector<PointPair> pairs;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d from(uniform(-0.5, 0.5), uniform(-0.4, 0.4), uniform(0.8, 1.5));
    Eigen::Vector3d to = TrueMotion() * from;
    if (uniform(0, 1) < wrong) to = {uniform(-0.5, 0.5), uniform(-0.4, 0.4), uniform(0.8, 1.5)};
    const Eigen::Vector2d pixel(
        kCamera.fx_px * to.x() / to.z() + kCamera.cx_px + uniform(-0.5, 0.5),
        kCamera.fy_px * to.y() / to.z() + kCamera.cy_px + uniform(-0.5, 0.5));
    to.z() += uniform(-0.003, 0.003);
    to.x() = (pixel.x() - kCamera.cx_px) / kCamera.fx_px * to.z();
    to.y() = (pixel.y() - kCamera.cy_px) / kCamera.fy_px * to.z();
    pairs.push_back({from, to, pixel});
  }
  return pairs;
}

TEST(FindRigidMotion, FindsItAmongWrongPairs) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    SCOPED_TRACE(seed);
    const auto found = FindRigidMotion(Pairs(200, 0.4, seed), kCamera, kWidth_px);
    ASSERT_TRUE(found);
    const Eigen::Isometry3d error = found->to_from_from * TrueMotion().inverse();
    // Where the points are, not at the camera, where turn and shift make up for each other.
    const Eigen::Vector3d middle(0, 0, 1.15);
    EXPECT_LT((error * middle - middle).norm(), 0.001);
    EXPECT_LT(Eigen::AngleAxisd(error.linear()).angle(), 0.002);
    EXPECT_LT(found->error_m, 0.001);
    EXPECT_GT(found->num_inliers, 100);
  }
}

TEST(FindRigidMotion, SaysWhenItCannotTell) {
  EXPECT_FALSE(FindRigidMotion({}, kCamera, kWidth_px));
  EXPECT_FALSE(FindRigidMotion(Pairs(kFewestInliers - 1, 0, 1), kCamera, kWidth_px));
  EXPECT_FALSE(FindRigidMotion(Pairs(200, 1, 1), kCamera, kWidth_px)) << "nothing but mistakes";
  const std::vector<PointPair> same(50, Pairs(1, 0, 1).front());
  EXPECT_FALSE(FindRigidMotion(same, kCamera, kWidth_px)) << "one point leaves all turns open";
  EXPECT_FALSE(FindRigidMotion(Pairs(400, 0.85, 1), kCamera, kWidth_px)) << "60 of 400 agree";
}

// 4.5 pixels beside its place: the limit is 3 of an image 640 wide, 6 of one twice as wide.
TEST(FindRigidMotion, PixelsAreThoseOfAnImage640Wide) {
  std::vector<PointPair> pairs = Pairs(200, 0, 1);
  pairs[0].to_px.x() += 4.5;
  EXPECT_EQ(FindRigidMotion(pairs, kCamera, 640)->is_inlier[0], 0);
  EXPECT_EQ(FindRigidMotion(pairs, kCamera, 1280)->is_inlier[0], 1);
}

// Their pixels are right: what is seen beside an edge, before or behind it.
TEST(FindRigidMotion, WhatHasAnotherDepthDoesNotCount) {
  std::vector<PointPair> pairs = Pairs(200, 0, 1);
  for (int i = 0; i < 80; ++i) pairs[i].to *= 1.1;
  const auto found = FindRigidMotion(pairs, kCamera, kWidth_px);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->num_inliers, 120);
  EXPECT_LT((found->to_from_from.translation() - TrueMotion().translation()).norm(), 0.003);
}

// Over many scenes: of the shift in the middle of the points.
TEST(FindRigidMotion, SaysHowFarItIsOff) {
  double squares = 0, expected_squares = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const std::vector<PointPair> pairs = Pairs(60, 0, seed);
    const RigidMotion found = FindRigidMotion(pairs, kCamera, kWidth_px).value();
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const PointPair& pair : pairs) middle += pair.from / static_cast<double>(pairs.size());
    squares += (found.to_from_from * middle - TrueMotion() * middle).squaredNorm();
    expected_squares += found.error_m * found.error_m;
  }
  EXPECT_NEAR(std::sqrt(squares / expected_squares), 1, 0.3);
}

TEST(FindRigidMotion, IsTheSameEachTime) {
  const auto pairs = Pairs(200, 0.4, 7);
  EXPECT_EQ(FindRigidMotion(pairs, kCamera, kWidth_px)->to_from_from.matrix(),
            FindRigidMotion(pairs, kCamera, kWidth_px)->to_from_from.matrix());
}

}  // namespace
}  // namespace fovea
