#include "core/scene/gravity.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <limits>
#include <numbers>
#include <random>

namespace fovea {
namespace {

// A room: share of floor normals (up), of two walls, and of anything else.
cv::Mat RoomNormals(const Eigen::Vector3f& down, int floor, int wall, int clutter, unsigned seed) {
  const Eigen::Vector3f side = down.unitOrthogonal();
  const Eigen::Vector3f other = down.cross(side);
  std::mt19937 random(seed);
  const auto noise = [&] { return (static_cast<float>(random() % 2001) / 1000.0F - 1.0F); };
  std::vector<cv::Vec3f> normals;
  const auto add = [&](Eigen::Vector3f n, float spread) {
    n = (n + spread * Eigen::Vector3f(noise(), noise(), noise())).normalized();
    normals.emplace_back(n.x(), n.y(), n.z());
  };
  for (int i = 0; i < floor; ++i) add(-down, 0.03F);
  for (int i = 0; i < wall; ++i) add(i % 2 == 0 ? side : other, 0.03F);
  for (int i = 0; i < clutter; ++i) add({0.1F, 0.1F, -0.5F}, 1.0F);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  normals.emplace_back(nan, nan, nan);
  return cv::Mat(normals, true).reshape(3, 1);
}

float AngleDeg(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  return std::acos(std::min(1.0F, a.dot(b))) * 180 / std::numbers::pi_v<float>;
}

TEST(EstimateGravity, FindsTheFloorOfAPitchedAndRolledCamera) {
  for (const float pitch_deg : {0.0F, 20.0F, 40.0F}) {
    for (const float roll_deg : {-10.0F, 0.0F, 10.0F}) {
      const float rad = std::numbers::pi_v<float> / 180;
      const Eigen::Vector3f down = Eigen::AngleAxisf(roll_deg * rad, Eigen::Vector3f::UnitZ()) *
                                   Eigen::AngleAxisf(-pitch_deg * rad, Eigen::Vector3f::UnitX()) *
                                   Eigen::Vector3f::UnitY();
      const cv::Mat normals = RoomNormals(down, 400, 200, 100, 3);
      EXPECT_LT(AngleDeg(EstimateGravity(normals), down), 2.0F) << pitch_deg << " " << roll_deg;
    }
  }
}

// Most normals are those of a wall straight ahead, which would do for the floor below a camera that
// looks down; the table tells.
TEST(EstimateGravity, TellsAWallAheadFromAFloorBelow) {
  const Eigen::Vector3f down = Eigen::Vector3f(0.02F, 0.95F, 0.3F).normalized();
  const Eigen::Vector3f ahead = down.unitOrthogonal().cross(down).normalized();
  const Eigen::Vector3f wall = ahead.z() > 0 ? ahead : Eigen::Vector3f(-ahead);
  cv::Mat room = RoomNormals(down, 300, 0, 30, 5);
  cv::Mat normals = room.reshape(3, static_cast<int>(room.total()));
  for (int i = 0; i < 450; ++i) normals.push_back(cv::Vec3f(-wall.x(), -wall.y(), -wall.z()));
  const Eigen::Vector3f found = EstimateGravity(normals, {.num_starts = 4});
  EXPECT_LT(AngleDeg(found, down), 3.0F) << found.transpose();
}

TEST(EstimateGravity, WallsAloneAreEnough) {
  const Eigen::Vector3f down = Eigen::Vector3f(0.1F, 1.0F, 0.2F).normalized();
  EXPECT_LT(AngleDeg(EstimateGravity(RoomNormals(down, 0, 400, 0, 5)), down), 2.0F);
}

TEST(EstimateGravity, PointsDownWithTheCamerasYAxis) {
  const Eigen::Vector3f up = -Eigen::Vector3f(0.0F, 1.0F, 0.3F).normalized();
  EXPECT_GT(EstimateGravity(RoomNormals(-up, 300, 0, 0, 1)).y(), 0.9F);
}

// The camera looks down by the pitch: gravity has z > 0.
Eigen::Vector3f DownOfPitchedCamera(float pitch_deg, float roll_deg) {
  const float rad = std::numbers::pi_v<float> / 180;
  return Eigen::AngleAxisf(roll_deg * rad, Eigen::Vector3f::UnitZ()) *
         Eigen::AngleAxisf(pitch_deg * rad, Eigen::Vector3f::UnitX()) * Eigen::Vector3f::UnitY();
}

TEST(EstimateGravity, SeveralStartsReachACameraThatLooksDown) {
  for (const float pitch_deg : {60.0F, 70.0F, 80.0F, 85.0F}) {
    for (const float roll_deg : {-10.0F, 0.0F, 10.0F}) {
      const Eigen::Vector3f down = DownOfPitchedCamera(pitch_deg, roll_deg);
      const cv::Mat normals = RoomNormals(down, 400, 200, 100, 3);
      EXPECT_LT(AngleDeg(EstimateGravity(normals, {.num_starts = 4}), down), 2.0F)
          << pitch_deg << " " << roll_deg;
      EXPECT_GT(AngleDeg(EstimateGravity(normals), down), 20.0F) << pitch_deg << " " << roll_deg;
    }
  }
}

TEST(EstimateGravity, SeveralStartsKeepTheFloorOfALevelCamera) {
  for (const float pitch_deg : {0.0F, 20.0F, 40.0F}) {
    const Eigen::Vector3f down = DownOfPitchedCamera(pitch_deg, 5);
    const cv::Mat normals = RoomNormals(down, 400, 200, 100, 3);
    EXPECT_LT(AngleDeg(EstimateGravity(normals, {.num_starts = 4}), down), 2.0F) << pitch_deg;
  }
}

TEST(EstimateGravity, KeepsTheStartWithoutNormals) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const cv::Mat none(4, 4, CV_32FC3, cv::Scalar::all(nan));
  EXPECT_EQ(EstimateGravity(none), Eigen::Vector3f::UnitY());
}

}  // namespace
}  // namespace fovea
