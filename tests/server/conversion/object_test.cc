// Every field of an object has a value of its own, so that none is taken for another.
#include "server/conversion/object.h"

#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "server/conversion/grasp.h"
#include "server/conversion/shape.h"

namespace fovea::testing {
namespace {

using ::testing::SizeIs;
using ::testing::UnorderedElementsAre;

// As it is printed again, so that it can be compared.
template <typename Message>
std::string Printed(const std::string& text) {
  Message message;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &message)) << text;
  return message.DebugString();
}

std::vector<Gripper> TwoGrippers() {
  std::vector<Gripper> grippers(2);
  grippers[0].name = "a";
  grippers[1].name = "b";
  return grippers;
}

DetectedObject SomeObject() {
  DetectedObject object;
  object.label = 7;
  object.confidence = 0.75F;
  object.saliency = 0.5F;
  object.bounds_px = {1, 2, 3, 4};
  object.num_pixels = 12;
  object.box.center = {1, 2, 3};
  object.box.size_m = {4, 5, 6};
  object.visible_box.center = {7, 8, 9};
  object.visible_box.size_m = {10, 11, 12};
  object.unseen_share = 0.25F;
  object.centroid = {13, 14, 15};
  object.mean_color = {16, 17, 18};
  object.height_above_support_m = 0.125F;
  object.no_grasps = {{.gripper = 1, .reason = NoGrasp::Reason::kNoSeal}};
  object.stands_on = {0, 1};
  object.leans_on = {2, 3};
  object.blocked_by = {4, 5, 6};
  return object;
}

TEST(Objects, SayEachThingInItsOwnField) {
  const Eigen::Isometry3d reference_from_camera(Eigen::Translation3d(100, 200, 300));
  const v1::Object proto =
      server::ToProto(SomeObject(), "frame", reference_from_camera, TwoGrippers());
  EXPECT_EQ(proto.DebugString(), Printed<v1::Object>(R"(
    id: "frame/7" label: 7 confidence: 0.75 saliency: 0.5 num_pixels: 12
    bounding_box { x: 1 y: 2 width: 3 height: 4 }
    oriented_box {
      pose { position { x: 1 y: 2 z: 3 } orientation { w: 1 } } size { x: 4 y: 5 z: 6 }
    }
    visible_box {
      pose { position { x: 7 y: 8 z: 9 } orientation { w: 1 } } size { x: 10 y: 11 z: 12 }
    }
    pose_in_reference { position { x: 101 y: 202 z: 303 } orientation { w: 1 } }
    shape { kind: SHAPE_KIND_OTHER }
    unseen_share: 0.25
    centroid { x: 13 y: 14 z: 15 }
    mean_color { red: 16 green: 17 blue: 18 }
    height_above_support_m: 0.125
    no_grasps { gripper: "b" gripper_index: 1 reason: NO_GRASP_REASON_NO_SEAL }
    stands_on: [0, 1] leans_on: [2, 3] blocked_by: [4, 5, 6])"));
}

// Those of the contract that are set elsewhere: what is asked for, and tracks.
TEST(Objects, LeaveNoOtherFieldEmpty) {
  DetectedObject object = SomeObject();
  object.truncated = object.depth_missing = object.yaw_is_arbitrary = true;
  object.colors.resize(1);
  object.grasps.resize(1);
  object.uncertainty.emplace();
  object.collision.emplace();
  const v1::Object proto =
      server::ToProto(object, "frame", Eigen::Isometry3d::Identity(), TwoGrippers());
  std::vector<const google::protobuf::FieldDescriptor*> set;
  v1::Object::GetReflection()->ListFields(proto, &set);
  std::vector<std::string> empty;
  for (int i = 0; i < v1::Object::descriptor()->field_count(); ++i) {
    const auto* const field = v1::Object::descriptor()->field(i);
    if (std::ranges::count(set, field) == 0) empty.push_back(field->name());
  }
  EXPECT_THAT(empty, UnorderedElementsAre("mask", "cloud", "track_id", "first_seen", "times_seen",
                                          "steadied_box", "steadied_over", "moving"));
}

TEST(Objects, SayOneThingThatIsSoAlone) {
  DetectedObject truncated, missing, round;
  truncated.truncated = missing.depth_missing = round.yaw_is_arbitrary = true;
  const auto said = [](const DetectedObject& object) {
    const v1::Object proto = server::ToProto(object, "frame", std::nullopt, {});
    return std::vector{proto.truncated(), proto.depth_missing(), proto.yaw_is_arbitrary()};
  };
  EXPECT_EQ(said(truncated), (std::vector{true, false, false}));
  EXPECT_EQ(said(missing), (std::vector{false, true, false}));
  EXPECT_EQ(said(round), (std::vector{false, false, true}));
}

TEST(Shapes, SayEachThingInItsOwnField) {
  Shape shape;
  shape.kind = Shape::Kind::kRevolution;
  shape.confidence = 0.75F;
  shape.residual_m = 0.5F;
  shape.center = {1, 2, 3};
  shape.axis = {4, 5, 6};
  shape.radius_m = 7;
  shape.length_m = 8;
  shape.radii_m = {9, 10};
  shape.hollow = true;
  EXPECT_EQ(server::ToProto(shape).DebugString(), Printed<v1::Shape>(R"(
    kind: SHAPE_KIND_REVOLUTION confidence: 0.75 residual_m: 0.5
    center { x: 1 y: 2 z: 3 } axis { x: 4 y: 5 z: 6 } radius_m: 7 length_m: 8
    radii_m: [9, 10] hollow: true)"));
}

// Round ones have a middle and a radius, and all but spheres an axis.
TEST(Shapes, EachHasItsKind) {
  for (int kind = 0; kind <= static_cast<int>(Shape::Kind::kFlat); ++kind) {
    Shape shape;
    shape.kind = static_cast<Shape::Kind>(kind);
    const v1::Shape proto = server::ToProto(shape);
    EXPECT_EQ(proto.kind(), kind + 1);
    EXPECT_EQ(proto.has_center(), kind >= 2 && kind <= 4) << kind;
    EXPECT_EQ(proto.has_axis(), kind == 2 || kind == 4) << kind;
  }
}

TEST(Grasps, SayEachThingInItsOwnField) {
  Grasp grasp;
  grasp.kind = Grasp::Kind::kRim;
  grasp.gripper = 3;
  grasp.tool_center_point = {1, 2, 3};
  grasp.approach = {0.5F, 0.25F, 1};
  grasp.closing = {4, 5, 6};
  grasp.opening_m = 7;
  grasp.pre_grasp_opening_m = 8;
  grasp.pre_grasp_distance_m = 0.5F;
  grasp.clearance_m = 9;
  grasp.unseen_contacts = 10;
  grasp.unseen_way = 15;
  grasp.probability = 11;
  grasp.unevenness_m = 12;
  grasp.usable_diameter_m = 13;
  grasp.off_center_m = 14;
  EXPECT_EQ(server::ToProto(grasp, "hand").DebugString(), Printed<v1::Grasp>(R"(
    tool_center_point { x: 1 y: 2 z: 3 } approach { x: 0.5 y: 0.25 z: 1 }
    closing { x: 4 y: 5 z: 6 } opening_m: 7 kind: GRASP_KIND_RIM
    gripper: "hand" gripper_index: 3 probability: 11
    pre_grasp_position { x: 0.75 y: 1.875 z: 2.5 }
    clearance_m: 9 unseen_contacts: 10 unevenness_m: 12 usable_diameter_m: 13 off_center_m: 14
    pre_grasp_opening_m: 8 unseen_way: 15)"));
}

TEST(Grasps, EachHasItsKind) {
  for (int kind = 0; kind <= static_cast<int>(Grasp::Kind::kSuction); ++kind) {
    EXPECT_EQ(server::ToProto(Grasp{.kind = static_cast<Grasp::Kind>(kind)}, "").kind(), kind + 1);
  }
}

TEST(Grasps, EachThatIsMissingHasItsReason) {
  for (int reason = 0; reason <= static_cast<int>(NoGrasp::Reason::kUnlikely); ++reason) {
    const NoGrasp none{.reason = static_cast<NoGrasp::Reason>(reason)};
    EXPECT_EQ(server::ToProto(none, "").reason(), reason + 1);
  }
}

// Those of each gripper are called by its name.
TEST(Grasps, OfAnObjectAreInTheirOrder) {
  DetectedObject object;
  object.grasps = {{.gripper = 1}, {.gripper = 0}, {.gripper = 2}};
  const v1::Object proto = server::ToProto(object, "frame", std::nullopt, TwoGrippers());
  ASSERT_THAT(proto.grasps(), SizeIs(3));
  EXPECT_EQ(proto.grasps(0).gripper(), "b");
  EXPECT_EQ(proto.grasps(1).gripper(), "a");
  EXPECT_EQ(proto.grasps(2).gripper(), "");
}

}  // namespace
}  // namespace fovea::testing
