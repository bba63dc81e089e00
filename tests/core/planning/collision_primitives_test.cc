#include "core/planning/collision_primitives.h"

#include <gtest/gtest.h>

namespace fovea {
namespace {

using Kind = CollisionPrimitive::Kind;
using Eigen::Vector3f;

DetectedObject Object(Shape::Kind kind) {
  DetectedObject object;
  object.box.center = {0.1F, 0.2F, 1};
  object.box.size_m = {0.1F, 0.06F, 0.2F};
  object.shape.kind = kind;
  object.shape.center = object.box.center;
  object.shape.axis = Vector3f::UnitX();
  object.shape.radius_m = 0.04F;
  object.shape.length_m = 0.2F;
  object.cloud = {{0.1F, 0.2F, 0.97F, 0, 0, 0}};
  return object;
}

TEST(CollisionPrimitives, AreWhatTheShapeIs) {
  const CollisionPrimitive box = PrimitiveOf(Object(Shape::Kind::kBox));
  EXPECT_EQ(box.kind, Kind::kBox);
  EXPECT_EQ(box.size_m, Vector3f(0.1F, 0.06F, 0.2F));
  const CollisionPrimitive cylinder = PrimitiveOf(Object(Shape::Kind::kCylinder));
  EXPECT_EQ(cylinder.kind, Kind::kCylinder);
  EXPECT_EQ(cylinder.size_m, Vector3f(0.08F, 0.08F, 0.2F));
  EXPECT_EQ(cylinder.pose.linear().col(2), Vector3f::UnitX());
  EXPECT_NEAR(cylinder.pose.linear().determinant(), 1, 1e-6);
  const CollisionPrimitive ball = PrimitiveOf(Object(Shape::Kind::kSphere));
  EXPECT_EQ(ball.kind, Kind::kSphere);
  EXPECT_EQ(ball.size_m, Vector3f::Constant(0.08F));
  EXPECT_EQ(ball.pose.translation(), Vector3f(0.1F, 0.2F, 1));
}

TEST(CollisionPrimitives, HoldAHandleBesideTheCylinder) {
  DetectedObject mug = Object(Shape::Kind::kRevolution);
  mug.shape.axis = Vector3f::UnitZ();
  for (int i = 0; i < 90; ++i) mug.cloud.push_back(mug.cloud.front());
  EXPECT_EQ(PrimitiveOf(mug).kind, Kind::kCylinder);
  for (int i = 0; i < 10; ++i) mug.cloud.push_back({0.19F, 0.2F, 1, 0, 0, 0});
  const CollisionPrimitive box = PrimitiveOf(mug);
  EXPECT_EQ(box.kind, Kind::kBox);
  EXPECT_NEAR(box.size_m.x(), 0.05 + 0.09, 1e-6);
  EXPECT_NEAR(box.pose.translation().x(), 0.1 + (0.09 - 0.05) / 2, 1e-6);
  EXPECT_NEAR(box.size_m.y(), 0.06, 1e-6);
}

// Its points in one place, 2 of 1000 far off to each side, as where a mask reaches over.
DetectedObject WithPoints(DetectedObject object, int num_out, float out_m) {
  const float x = object.box.center.x(), y = object.box.center.y(), z = object.box.center.z();
  object.cloud.assign(1000, {x, y, z, 0, 0, 0});
  for (int i = 0; i < num_out; ++i) object.cloud[i].z = z + object.box.size_m.z() / 2 + out_m;
  object.cloud[998].x = x + 0.5F;
  object.cloud[999].y = y - 0.5F;
  return object;
}

TEST(CollisionPrimitives, HoldAllButAHundredthOfWhatWasSeenTo5mm) {
  const auto height_of = [](int num_out, float out_m) {
    return PrimitiveOf(WithPoints(Object(Shape::Kind::kBox), num_out, out_m)).size_m.z();
  };
  EXPECT_FLOAT_EQ(height_of(20, 0.004F), 0.2F);
  EXPECT_FLOAT_EQ(height_of(8, 0.009F), 0.2F);
  EXPECT_NEAR(height_of(9, 0.009F), 0.209F, 1e-6F);
  EXPECT_NEAR(height_of(15, 0.04F), 0.24F, 1e-6F);
}

// Five of a thousand points beyond the top, the bottom and the wall of a can each: as many as are
// left out of it over all.
TEST(CollisionPrimitives, ACylinderLeavesOutAHundredthOverAllItsSides) {
  DetectedObject can = Object(Shape::Kind::kCylinder);
  can.shape.axis = Vector3f::UnitZ();
  can.box.size_m = {0.12F, 0.12F, 0.2F};
  can.cloud.assign(1000, {0.1F, 0.2F, 1, 0, 0, 0});
  for (int i = 0; i < 5; ++i) {
    can.cloud[3 * i].z = 1.11F;
    can.cloud[3 * i + 1].z = 0.88F;
    can.cloud[3 * i + 2].x = 0.15F;
  }
  const CollisionPrimitive grown = PrimitiveOf(can);
  EXPECT_EQ(grown.kind, Kind::kCylinder);
  EXPECT_TRUE(grown.size_m.isApprox(Vector3f(0.1F, 0.1F, 0.23F), 1e-5F));
  EXPECT_NEAR(grown.pose.translation().z(), 1 + (0.01 - 0.02) / 2, 1e-6);
}

TEST(CollisionPrimitives, ABoxGrowsOnEachSide) {
  for (int axis = 0; axis < 3; ++axis) {
    DetectedObject object = Object(Shape::Kind::kBox);
    Vector3f beyond = object.box.center;
    beyond[axis] -= object.box.size_m[axis] / 2 + 0.04F;
    object.cloud.assign(20, {beyond.x(), beyond.y(), beyond.z(), 0, 0, 0});
    const CollisionPrimitive box = PrimitiveOf(object);
    const Vector3f more = 0.04F * Vector3f::Unit(axis);
    EXPECT_TRUE(box.size_m.isApprox(object.box.size_m + more)) << axis;
    EXPECT_TRUE(box.pose.translation().isApprox(object.box.center - more / 2)) << axis;
  }
}

TEST(CollisionPrimitives, DoNotGrowToStrays) {
  const CollisionPrimitive box = PrimitiveOf(WithPoints(Object(Shape::Kind::kBox), 15, 0.04F));
  EXPECT_NEAR(box.size_m.x(), 0.1F, 1e-6F);
  EXPECT_NEAR(box.size_m.y(), 0.06F, 1e-6F);
}

TEST(CollisionPrimitives, StayRoundWhereThatIsSmaller) {
  DetectedObject can = Object(Shape::Kind::kCylinder);
  can.shape.axis = Vector3f::UnitZ();
  can.box.size_m = {0.08F, 0.08F, 0.2F};
  const CollisionPrimitive higher = PrimitiveOf(WithPoints(can, 30, 0.02F));
  EXPECT_EQ(higher.kind, Kind::kCylinder);
  EXPECT_NEAR(higher.size_m.x(), 0.08F, 1e-6F);
  EXPECT_NEAR(higher.size_m.z(), 0.22F, 1e-6F);
  EXPECT_NEAR(higher.pose.translation().z(), 1.01F, 1e-6F);
  DetectedObject ball = Object(Shape::Kind::kSphere);
  ball.box.size_m = Vector3f::Constant(0.08F);
  const CollisionPrimitive larger = PrimitiveOf(WithPoints(ball, 30, 0.006F));
  EXPECT_EQ(larger.kind, Kind::kSphere);
  EXPECT_NEAR(larger.size_m.x(), 0.092F, 1e-6F);
}

TEST(CollisionPrimitives, OfASupportLieBelowItsSurface) {
  // A table top 0.5 m below the camera, from 0.6 to 1 m away, and a thing on it; more points than
  // are kept at once.
  cv::Mat points(161, 241, CV_32FC3);
  for (int row = 0; row < points.rows; ++row) {
    for (int column = 0; column < points.cols; ++column) {
      points.at<cv::Vec3f>(row, column) = {0.0025F * static_cast<float>(column - 120), 0.5F,
                                           0.6F + 0.0025F * static_cast<float>(row)};
    }
  }
  points.at<cv::Vec3f>(80, 120)[1] = 0.3F;
  points.at<cv::Vec3f>(0, 0) = cv::Vec3f::all(std::numeric_limits<float>::quiet_NaN());
  Support support;
  support.surface.normal = -Vector3f::UnitY();
  support.surface.offset_m = 0.5F;
  const CollisionPrimitive table = PrimitiveOf(support, points).value();
  EXPECT_EQ(table.kind, Kind::kBox);
  EXPECT_NEAR(table.size_m.head<2>().maxCoeff(), 0.6, 1e-5);
  EXPECT_NEAR(table.size_m.head<2>().minCoeff(), 0.4, 1e-5);
  EXPECT_NEAR(table.pose.translation().x(), 0, 1e-5);
  EXPECT_NEAR(table.pose.translation().y(), 0.5 + table.size_m.z() / 2, 1e-5);
  EXPECT_NEAR(table.pose.translation().z(), 0.8, 1e-5);
  EXPECT_TRUE(table.pose.linear().col(2).isApprox(support.surface.normal));
  EXPECT_NEAR(table.pose.linear().determinant(), 1, 1e-5);
}

// What is as high a metre beside it is another table.
TEST(CollisionPrimitives, OfASupportEndWhereItEnds) {
  std::vector<Vector3f> table;
  std::vector<cv::Vec3f> seen;
  for (float x = -0.3F; x < 0.301F; x += 0.01F) {
    for (float z = 0.7F; z < 1.101F; z += 0.01F) {
      table.emplace_back(x, 0.5F, z);
      seen.emplace_back(x, 0.5F, z);
      seen.emplace_back(x + 1, 0.5F, z);
    }
  }
  Support support;
  support.surface.normal = -Vector3f::UnitY();
  support.surface.offset_m = 0.5F;
  support.footprint = Footprint(table, {}, support.surface, 0.01, 0.02);
  const CollisionPrimitive primitive = PrimitiveOf(support, cv::Mat(seen, true)).value();
  EXPECT_NEAR(primitive.size_m.head<2>().maxCoeff(), 0.6, 1e-4);
  EXPECT_NEAR(primitive.pose.translation().x(), 0, 1e-4);
}

TEST(CollisionPrimitives, OfARowOfASupportHaveAWidth) {
  Support support;
  support.surface.normal = -Vector3f::UnitY();
  support.surface.offset_m = 0.5F;
  cv::Mat points(1, 11, CV_32FC3);
  for (int column = 0; column < points.cols; ++column) {
    points.at<cv::Vec3f>(0, column) = {0.03F * static_cast<float>(column), 0.5F, 1};
  }
  const CollisionPrimitive row = PrimitiveOf(support, points).value();
  EXPECT_NEAR(row.size_m.head<2>().maxCoeff(), 0.3, 1e-5);
  EXPECT_NEAR(row.size_m.head<2>().minCoeff(), 0.01, 1e-5);
  EXPECT_TRUE(row.pose.translation().isApprox(Vector3f(0.15F, 0.51F, 1), 1e-4F));
  const CollisionPrimitive pixel = PrimitiveOf(support, points.col(3)).value();
  EXPECT_TRUE(pixel.size_m.isApprox(Vector3f(0.01F, 0.01F, 0.02F)));
  EXPECT_TRUE(pixel.pose.linear().isUnitary(1e-5F));
  points.setTo(cv::Scalar::all(1));
  EXPECT_FALSE(PrimitiveOf(support, points)) << "nothing of it is seen";
}

}  // namespace
}  // namespace fovea
