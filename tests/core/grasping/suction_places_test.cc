// Where a cup may lie on simple things on a floor, seen by an ideal camera.
#include "core/grasping/suction_places.h"

#include <gtest/gtest.h>

#include "tests/core/shape/things_on_floor.h"

namespace fovea {
namespace {

using scenes::ShapeKind;

// One thing and what its solid offers a cup of 30 mm that comes from above.
struct Offered {
  explicit Offered(const scenes::Body& thing, double pitch_deg = 45)
      : scene(CompleteThings({thing}, pitch_deg)),
        up(-scene.detections.gravity.direction),
        object(scene.detections.objects[0]),
        places(SolidPlaces(Scene(), object, -up, cup.diameter_m)) {}

  GraspScene Scene() const {
    return {scene.points, scene.detections.labels, scene.frame.intrinsics, up};
  }
  float ReachOf(const SuctionPlace& place) const {
    const LevelFrame frame = FrameUnder(object.box);
    return EvenReach(object, CompletedSolid(object, frame), frame, place, cup);
  }
  // The place that faces up most.
  const SuctionPlace& Top() const {
    return *std::max_element(places.begin(), places.end(), [&](const auto& a, const auto& b) {
      return a.normal.dot(up) < b.normal.dot(up);
    });
  }
  float HeightOf(const SuctionPlace& place) const {
    return up.dot(place.center - object.box.center) + object.box.size_m.z() / 2;
  }

  SuctionGripper cup;
  ThingsOnFloor scene;
  Eigen::Vector3f up;
  const DetectedObject& object;
  std::vector<SuctionPlace> places;
};

TEST(SuctionPlaces, TheMiddleOfTheTopOfABoxIsEvenAsFarAsItsEdge) {
  // 45 mm wide: 22.5 mm from the middle to the edge are 1.5 radii of the lip.
  const Offered offered(Thing(ShapeKind::kBox, {0.12, 0.045, 0.08}, {0, 0}, 0, 0.4));
  ASSERT_FALSE(offered.places.empty());
  const SuctionPlace& top = offered.Top();
  EXPECT_GT(top.normal.dot(offered.up), 0.999F);
  EXPECT_NEAR(offered.HeightOf(top), 0.08F, 0.003F);
  EXPECT_GT(top.seen.num_points, 20);
  EXPECT_GE(offered.ReachOf(top), 1.3F);
  EXPECT_LE(offered.ReachOf(top), 1.6F);
}

// Pixels of a patch are no farther apart than the image is large, whatever the intrinsics say.
TEST(SuctionPlaces, AnEndlessFocalLengthIsNoReasonToLookFarther) {
  const Offered offered(Thing(ShapeKind::kBox, {0.12, 0.045, 0.08}, {0, 0}, 0, 0.4));
  ASSERT_FALSE(offered.places.empty());
  for (const double fx_px : {1e6, 5e10, 1.2e11, 1e30}) {
    CameraIntrinsics intrinsics = offered.scene.frame.intrinsics;
    intrinsics.fx_px = fx_px;
    const GraspScene scene{offered.scene.points, offered.scene.detections.labels, intrinsics,
                           offered.up};
    const SuctionPlace& top = offered.Top();
    const auto patch = PatchAt(scene, offered.object.label, top.pixel, top.center, 0.03F);
    if (patch) {
      EXPECT_LE(patch->num_points, 29 * 29) << fx_px;
    }
  }
}

// A plate 0.5 m away, seen by a camera whose rows are a quarter as far apart as its columns.
TEST(SuctionPlaces, ALipIsRoundWhereFocalLengthsDiffer) {
  const CameraIntrinsics intrinsics{300, 1200, 40, 40};
  cv::Mat points(81, 81, CV_32FC3);
  for (int row = 0; row < points.rows; ++row) {
    for (int column = 0; column < points.cols; ++column) {
      points.at<cv::Vec3f>(row, column) = {static_cast<float>(0.5 * (column - 40) / 300),
                                           static_cast<float>(0.5 * (row - 40) / 1200), 0.5F};
    }
  }
  const cv::Mat labels(points.size(), CV_16UC1, cv::Scalar(1));
  const GraspScene scene{points, labels, intrinsics, -Eigen::Vector3f::UnitY()};
  const auto patch = PatchAt(scene, 1, {40, 40}, {0, 0, 0.5F}, 0.03F);
  ASSERT_TRUE(patch);
  EXPECT_EQ(patch->covered, 1);
}

TEST(SuctionPlaces, ABoxNarrowerThanTheLipIsNotEvenEnough) {
  const Offered offered(Thing(ShapeKind::kBox, {0.12, 0.025, 0.08}, {0, 0}, 0, 0.4));
  ASSERT_FALSE(offered.places.empty());
  EXPECT_LT(offered.ReachOf(offered.Top()), 1);
}

TEST(SuctionPlaces, TheTopOfABoxIsOfferedThoughItIsSeenFromTheSideOnly) {
  // From 2 degrees above the floor the top is a line.
  const Offered offered(Thing(ShapeKind::kBox, {0.08, 0.08, 0.1}, {0, 0}, 0, 0.2), 2);
  ASSERT_FALSE(offered.places.empty());
  const SuctionPlace& top = offered.Top();
  EXPECT_GT(top.normal.dot(offered.up), 0.99F);
  EXPECT_LT(top.seen.covered, 0.6F);
}

TEST(SuctionPlaces, ACupIsTakenByItsBottomWhereItsInsideIsSeen) {
  const Offered offered(Thing(ShapeKind::kCup, {0.09, 0.09, 0.08}, {0, 0}, 0, 0, 0.004), 55);
  ASSERT_TRUE(offered.object.shape.hollow);
  ASSERT_EQ(offered.places.size(), 1U);
  const SuctionPlace& bottom = offered.places[0];
  EXPECT_TRUE(bottom.is_inside);
  EXPECT_NEAR(offered.HeightOf(bottom), 0.004F, 0.004F);
  EXPECT_GT(offered.ReachOf(bottom), 1.5F);
}

TEST(SuctionPlaces, ALyingTubeIsTooCurvedBesideItsTopLine) {
  // Under a lip of 15 mm a tube of 25 mm radius falls by 5 mm.
  const Offered offered(Thing(ShapeKind::kBox, {0.2, 0.05, 0.05}, {0, 0}, 0));
  SuctionPlace place = offered.Top();
  DetectedObject tube = offered.object;
  tube.shape.kind = Shape::Kind::kCylinder;
  tube.shape.center = tube.box.center;
  tube.shape.axis = tube.box.rotation.col(0);
  tube.shape.radius_m = 0.025F;
  tube.shape.length_m = 0.2F;
  place.center = tube.box.center + 0.025F * offered.up;
  place.normal = offered.up;
  const LevelFrame frame = FrameUnder(tube.box);
  const auto reach = [&](float radius_m) {
    tube.shape.radius_m = radius_m;
    place.center = tube.shape.center + radius_m * offered.up;
    return EvenReach(tube, CompletedSolid(tube, frame), frame, place, offered.cup);
  };
  EXPECT_LT(reach(0.025F), 1);
  EXPECT_GE(reach(0.045F), 1);  // falls by 2.6 mm
}

}  // namespace
}  // namespace fovea
