// Grasps with a cup of simple things on a floor, seen by an ideal camera.
#include <gtest/gtest.h>

#include "core/grasping/plan_grasps.h"
#include "tests/core/shape/things_on_floor.h"

namespace fovea {
namespace {

using scenes::ShapeKind;

Gripper CupOf(float diameter_m) {
  Gripper gripper;
  SuctionGripper cup;
  cup.diameter_m = diameter_m;
  gripper.hand = cup;
  gripper.max_tilt_rad = 0.8F;
  gripper.max_grasps = 20;
  return gripper;
}

DetectedObject TakenByCup(const scenes::Body& thing, const Gripper& gripper,
                          double pitch_deg = 45) {
  ThingsOnFloor scene = CompleteThings({thing}, pitch_deg);
  Detections& found = scene.detections;
  PlanGrasps({scene.points, found.labels, scene.frame.intrinsics, -found.gravity.direction},
             {gripper}, found.objects);
  return found.objects[0];
}

// How far a place on the top of a box is from its nearest edge.
float ToEdge(const OrientedBox& box, const Eigen::Vector3f& place) {
  const Eigen::Vector3f from = box.rotation.transpose() * (place - box.center);
  return (box.size_m / 2 - from.cwiseAbs()).head<2>().minCoeff();
}

TEST(SuctionGrasps, NoCupThatIsSaidToFitHangsOverAnEdge) {
  const DetectedObject box =
      TakenByCup(Thing(ShapeKind::kBox, {0.12, 0.1, 0.08}, {0, 0}, 0, 0.4), CupOf(0.02F), 70);
  float widest_m = 0;
  for (const Grasp& grasp : box.grasps) {
    if (grasp.approach.dot(-box.box.rotation.col(2)) < 0.9F) continue;
    EXPECT_LE(grasp.usable_diameter_m / 2, ToEdge(box.box, grasp.tool_center_point) + 0.003F);
    widest_m = std::max(widest_m, grasp.usable_diameter_m);
  }
  EXPECT_FLOAT_EQ(widest_m, 0.06F);  // in the middle, three times as wide
}

TEST(SuctionGrasps, AnAxisThatCannotTiltTakesWhatIsLevelButForItsNoise) {
  Gripper gripper = CupOf(0.03F);
  const Eigen::Vector3f up =
      TakenByCup(Thing(ShapeKind::kBox, {0.12, 0.1, 0.08}, {0, 0}, 0), gripper).box.rotation.col(2);
  const Eigen::Vector3f aside = up.unitOrthogonal();
  for (const float tilt_rad : {0.0F, 0.01F}) {
    for (const float off_rad : {0.0F, 0.03F, 0.1F}) {
      gripper.max_tilt_rad = tilt_rad;
      gripper.approach = -std::cos(off_rad) * up + std::sin(off_rad) * aside;
      const DetectedObject box =
          TakenByCup(Thing(ShapeKind::kBox, {0.12, 0.1, 0.08}, {0, 0}, 0), gripper);
      EXPECT_EQ(box.grasps.empty(), off_rad > 0.05F) << tilt_rad << " " << off_rad;
      for (const Grasp& grasp : box.grasps) {
        EXPECT_LE((grasp.approach - *gripper.approach).norm(), tilt_rad + 1e-5F) << off_rad;
      }
    }
  }
}

}  // namespace
}  // namespace fovea
