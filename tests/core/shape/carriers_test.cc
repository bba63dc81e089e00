#include "core/shape/carriers.h"

#include <gtest/gtest.h>

namespace fovea {
namespace {

using Eigen::Vector3f;

// Upright on y = 0.5 m, where up is -y; its points lie in its top.
DetectedObject Slab(int label, float bottom_m, float height_m) {
  DetectedObject object;
  object.label = label;
  object.box.rotation.col(0) = Vector3f::UnitX();
  object.box.rotation.col(1) = Vector3f::UnitZ();
  object.box.rotation.col(2) = -Vector3f::UnitY();
  object.box.center = {0, 0.5F - bottom_m - height_m / 2, 1};
  object.box.size_m = {0.2F, 0.2F, height_m};
  object.visible_box = object.box;
  object.cloud.assign(20, {0, 0.5F - bottom_m - height_m, 1, 0, 0, 0});
  return object;
}

// A sheet whose lower end lies a little below the top of another sheet, and the other way round.
class TwoSheets : public testing::Test {
 protected:
  TwoSheets() {
    floor_.normal = -Vector3f::UnitY();
    floor_.offset_m = 0.5F;
    edge_.is_own_end = true;
    edge_.beyond = {0, 0.47F, 1};
    edge_.label_beyond = 2;
  }

  std::vector<DetectedObject> sheets_ = {Slab(1, 0.03F, 0.01F), Slab(2, 0.025F, 0.01F)};
  SupportSurface floor_;
  OutlinePoint edge_;
};

TEST_F(TwoSheets, MayCarryEachOther) {
  EXPECT_EQ(Touching(sheets_[0], sheets_, {edge_}, floor_).carrier, 2);
  EXPECT_EQ(CarriersOf(sheets_[0], sheets_, {1}, floor_).front().label, 2);
  EXPECT_EQ(HeldBy(sheets_[0], sheets_, {1}, floor_), 2);
}

TEST_F(TwoSheets, DoNotCarryWhatTheyStandOn) {
  sheets_[1].stands_on = {1};
  EXPECT_EQ(Touching(sheets_[0], sheets_, {edge_}, floor_).carrier, std::nullopt);
  EXPECT_EQ(CarriersOf(sheets_[0], sheets_, {1}, floor_).front().label, 0);
  EXPECT_EQ(HeldBy(sheets_[0], sheets_, {1}, floor_), std::nullopt);
}

TEST_F(TwoSheets, DoNotCarryWhatTheyStandOnByAnother) {
  sheets_.push_back(Slab(3, 0.4F, 0.01F));
  sheets_[1].stands_on = {3};
  sheets_[2].leans_on = {1};
  EXPECT_EQ(Touching(sheets_[0], sheets_, {edge_}, floor_).carrier, std::nullopt);
  EXPECT_EQ(CarriersOf(sheets_[0], sheets_, {1}, floor_).front().label, 0);
  EXPECT_EQ(HeldBy(sheets_[0], sheets_, {1}, floor_), std::nullopt);
}

// Its points are above the other sheet, or not.
DetectedObject At(float x_m, float z_m, DetectedObject sheet) {
  sheet.visible_box.center.x() += x_m;
  sheet.visible_box.center.z() += z_m;
  for (ColoredPoint& p : sheet.cloud) p.x += x_m, p.z += z_m;
  return sheet;
}

TEST_F(TwoSheets, DoNotCarryWhatWouldToppleOffThem) {
  const DetectedObject sheet = sheets_[0];
  for (const auto& [x_m, carrier] : {std::pair(0.11F, 2), {0.12F, 0}}) {
    sheets_[0] = At(x_m, 0, sheet);
    EXPECT_EQ(CarriersOf(sheets_[0], sheets_, {1}, floor_).front().label, carrier) << x_m;
    EXPECT_EQ(Touching(sheets_[0], sheets_, {edge_}, floor_).carrier == 2, carrier == 2) << x_m;
  }
}

TEST_F(TwoSheets, OfRoundThingsNotTheCornersOfTheirBoxes) {
  sheets_[0] = At(0.09F, 0.09F, sheets_[0]);
  EXPECT_EQ(CarriersOf(sheets_[0], sheets_, {1}, floor_).front().label, 2);
  sheets_[1].yaw_is_arbitrary = true;
  EXPECT_EQ(CarriersOf(sheets_[0], sheets_, {1}, floor_).front().label, 0);
}

// Of which a third is above one of them.
TEST_F(TwoSheets, CarryTogetherWhatLiesAcross) {
  sheets_[0] = At(0.15F, 0, sheets_[0]);
  EXPECT_EQ(CarriersOf(sheets_[0], sheets_, {1}, floor_).front().label, 0);
  for (std::size_t i = 0; i < 7; ++i) sheets_[0].cloud[i].x = 0.05F;
  EXPECT_EQ(CarriersOf(sheets_[0], sheets_, {1}, floor_).front().label, 2);
  sheets_[0].visible_box.center.y() += 0.02F;  // it ends lower than the other's top
  EXPECT_EQ(CarriersOf(sheets_[0], sheets_, {1}, floor_).front().label, 0);
}

TEST_F(TwoSheets, HoldWhatOverhangsThemAndNothingElse) {
  sheets_[0].box.center.x() = 0.18F;  // a tenth of it is above the other
  EXPECT_EQ(HeldBy(sheets_[0], sheets_, {1}, floor_), 2);
  sheets_[0].box.center.x() = 0.195F;
  EXPECT_EQ(HeldBy(sheets_[0], sheets_, {1}, floor_), std::nullopt);
}

TEST_F(TwoSheets, AreNotOnTheSupportBecauseSomethingHigherIsBesideThem) {
  sheets_[1] = Slab(2, 0, 0.1F);
  for (const int label : {0, 1, 2}) {
    edge_.label_beyond = label;
    EXPECT_TRUE(Touching(sheets_[0], sheets_, {edge_}, floor_).is_seen) << label;
    EXPECT_EQ(Touching(sheets_[0], sheets_, {edge_}, floor_).carrier, std::nullopt) << label;
  }
}

TEST_F(TwoSheets, StandOnTheSupportThatIsSeenBesideThem) {
  edge_.beyond.y() = 0.485F;
  for (const int label : {0, 2}) {
    edge_.label_beyond = label;
    sheets_[1] = Slab(2, 0, 0.1F);
    EXPECT_EQ(Touching(sheets_[0], sheets_, {edge_}, floor_).carrier, 0) << label;
  }
  edge_.beyond.y() = 0.4F;
  EXPECT_FALSE(Touching(sheets_[0], sheets_, {edge_}, floor_).is_seen);
}

}  // namespace
}  // namespace fovea
