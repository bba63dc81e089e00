// Every field of an answer has a value of its own, so that none is taken for another.
#include "server/conversion/detections.h"

#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>

#include <string>
#include <utility>
#include <variant>

#include "server/conversion/gripper.h"

namespace fovea::testing {
namespace {

v1::Detections AnswerWith(const Detections& detections, bool with_rejected = false) {
  v1::Frame frame;
  frame.set_id("frame");
  frame.mutable_captured_at()->set_seconds(5);
  v1::DetectOptions options;
  options.set_return_rejected(with_rejected);
  v1::Detections proto = server::ToProto(detections, {}, frame, options);
  EXPECT_NE(proto.server_version(), "");
  proto.clear_server_version();
  proto.clear_server_build();
  return proto;
}

Detections SomeDetections() {
  Detections some;
  some.labels = cv::Mat::zeros(3, 4, CV_16UC1);
  some.rejected = {{.bounds_px = {1, 2, 3, 4}, .probability = 0.25F, .reason = "small"}};
  some.gravity = {.direction = {0.25F, 0.5F, 0.75F}, .source = Gravity::Source::kGiven};
  some.support = {.normal = {1, 2, 3}, .offset_m = 0.5F, .num_points = 4};
  some.free_places.resize(1);
  some.free_places[0].box.center = {1, 2, 3};
  some.free_places[0].clearance_m = 4;
  some.support_collisions.resize(1);
  some.support_collisions[0].kind = CollisionPrimitive::Kind::kCylinder;
  some.incomplete = true;
  some.stage_times = {{"first", 2500.5}, {"second", 0.25}};
  return some;
}

TEST(Answers, SayEachThingInItsOwnField) {
  v1::Detections expected;
  ASSERT_TRUE(google::protobuf::TextFormat::ParseFromString(R"(
    frame_id: "frame" captured_at { seconds: 5 } profile: "default" width: 4 height: 3
    gravity { direction { x: 0.25 y: 0.5 z: 0.75 } source: GRAVITY_SOURCE_REQUEST }
    support_surface { plane { normal { x: 1 y: 2 z: 3 } offset: 0.5 } num_points: 4 }
    stage_times { stage: "first" duration { seconds: 2 nanos: 500500000 } }
    stage_times { stage: "second" duration { nanos: 250000 } }
    diagnostics {}
    incomplete: true
    rejected {
      bounding_box { x: 1 y: 2 width: 3 height: 4 } probability: 0.25 reason: "small"
    }
    free_places {
      box { pose { position { x: 1 y: 2 z: 3 } orientation { w: 1 } } size {} } clearance_m: 4
    }
    support_collisions {
      kind: COLLISION_KIND_CYLINDER pose { position {} orientation { w: 1 } } size {}
    })",
                                                            &expected));
  EXPECT_EQ(AnswerWith(SomeDetections(), /*with_rejected=*/true).DebugString(),
            expected.DebugString());
  expected.clear_rejected();
  EXPECT_EQ(AnswerWith(SomeDetections()).DebugString(), expected.DebugString());
}

TEST(Answers, CountWhatWasLeftAfterEachStep) {
  Detections detections;
  Diagnostics& counts = detections.diagnostics;
  std::size_t number = 0;
  for (std::size_t* count :
       {&counts.num_pixels, &counts.num_measured, &counts.num_points, &counts.seeds_from_color,
        &counts.seeds_from_depth, &counts.seeds_without_depth, &counts.seeds_on_support,
        &counts.num_seeds, &counts.num_voxels, &counts.num_segments, &counts.num_merged,
        &counts.segments_too_small, &counts.segments_implausible}) {
    *count = ++number;
  }
  counts.messages = {"a", "b"};
  v1::Diagnostics expected;
  ASSERT_TRUE(google::protobuf::TextFormat::ParseFromString(R"(
    num_pixels: 1 num_measured: 2 num_points: 3 seeds_from_color: 4 seeds_from_depth: 5
    seeds_without_depth: 6 seeds_on_support: 7 num_seeds: 8 num_voxels: 9 num_segments: 10
    num_merged: 11 segments_too_small: 12 segments_implausible: 13 messages: ["a", "b"])",
                                                            &expected));
  EXPECT_EQ(AnswerWith(detections).diagnostics().DebugString(), expected.DebugString());
}

TEST(Answers, SayWhereGravityIsFrom) {
  using Source = Gravity::Source;
  for (const auto& [source, said] : {std::pair(Source::kGiven, v1::GRAVITY_SOURCE_REQUEST),
                                     std::pair(Source::kEstimated, v1::GRAVITY_SOURCE_ESTIMATED),
                                     std::pair(Source::kAssumed, v1::GRAVITY_SOURCE_ASSUMED)}) {
    Detections detections;
    detections.gravity.source = source;
    EXPECT_EQ(AnswerWith(detections).gravity().source(), said);
  }
}

TEST(Answers, SayWhatIsKnownOfTracks) {
  Detections detections;
  DetectedObject moving;
  moving.track.emplace();
  moving.track->id = 1;
  moving.track->first_seen = CaptureTime{2, 3};
  moving.track->times_seen = 4;
  moving.track->steadied_over = 5;
  moving.track->steadied_box.center = {6, 7, 8};
  moving.track->is_moving = true;
  DetectedObject standing = moving;
  standing.track->first_seen.reset();
  standing.track->is_moving = false;
  detections.objects = {moving, standing, {}};
  HiddenTrack hidden;
  hidden.id = 9;
  hidden.last_seen = CaptureTime{10, 11};
  hidden.times_seen = 12;
  hidden.box.center = {13, 14, 15};
  detections.tracking.emplace();
  detections.tracking->epoch = 16;
  detections.tracking->hidden = {hidden};

  const v1::Detections proto = AnswerWith(detections);
  const v1::Object& first = proto.objects(0);
  EXPECT_EQ(first.track_id(), 1U);
  EXPECT_EQ(first.first_seen().seconds(), 2);
  EXPECT_EQ(first.first_seen().nanos(), 3);
  EXPECT_EQ(first.times_seen(), 4U);
  EXPECT_EQ(first.steadied_over(), 5U);
  EXPECT_EQ(first.steadied_box().pose().position().y(), 7);
  EXPECT_TRUE(first.moving());
  EXPECT_FALSE(proto.objects(1).has_first_seen());
  EXPECT_FALSE(proto.objects(1).moving());
  EXPECT_FALSE(proto.objects(2).has_steadied_box());
  EXPECT_EQ(proto.track_epoch(), 16U);
  EXPECT_FALSE(proto.has_camera_motion());
  const v1::HiddenTrack& then = proto.hidden_tracks(0);
  EXPECT_EQ(then.track_id(), 9U);
  EXPECT_EQ(then.last_seen().seconds(), 10);
  EXPECT_EQ(then.last_seen().nanos(), 11);
  EXPECT_EQ(then.times_seen(), 12U);
  EXPECT_EQ(then.last_box().pose().position().y(), 14);
}

TEST(Answers, SayWhyATrackIsHidden) {
  Detections detections;
  detections.tracking.emplace();
  detections.tracking->hidden.resize(1);
  for (int reason = 0; reason <= static_cast<int>(HiddenReason::kGone); ++reason) {
    detections.tracking->hidden[0].reason = static_cast<HiddenReason>(reason);
    EXPECT_EQ(AnswerWith(detections).hidden_tracks(0).reason(), reason + 1);
  }
}

v1::Gripper JawOf(double opening_m) {
  v1::Gripper gripper;
  gripper.mutable_jaw()->set_max_opening_m(opening_m);
  return gripper;
}

v1::Gripper CupOf(double diameter_m) {
  v1::Gripper gripper;
  gripper.mutable_suction()->set_diameter_m(diameter_m);
  return gripper;
}

// Of one object with a grasp of each gripper that is as wide as that is, as the detector has it.
v1::Detections AnswerToWidestGrasps(const v1::GraspOptions& asked) {
  Detections detections;
  detections.grippers = server::FromProto(asked);
  detections.objects.resize(1);
  for (std::size_t i = 0; i < detections.grippers.size(); ++i) {
    Grasp grasp{.gripper = i};
    const auto& hand = detections.grippers[i].hand;
    if (const auto* jaw = std::get_if<JawGripper>(&hand)) {
      grasp.opening_m = grasp.pre_grasp_opening_m = jaw->max_opening_m;
    } else {
      grasp.usable_diameter_m = std::get<SuctionGripper>(hand).diameter_m;
    }
    detections.objects[0].grasps.push_back(grasp);
  }
  v1::DetectOptions options;
  *options.mutable_grasps() = asked;
  return server::ToProto(detections, {}, v1::Frame(), options);
}

// Robots compare them with what they have sent, and refuse what lies beyond it by a rounding.
TEST(Answers, KeepGraspsWithinTheGrippersAsTheyWereSent) {
  v1::GraspOptions asked;
  for (const double number : {0.085, 0.085 * 0.99, 0.1 + 0.2, 0.03, 0.07, 1e-4}) {
    *asked.add_grippers() = JawOf(number);
    if (asked.grippers_size() < 5) *asked.add_grippers() = CupOf(number);
  }
  asked.mutable_grippers(0)->set_max_tilt_rad(0.8);
  const v1::Detections answer = AnswerToWidestGrasps(asked);
  ASSERT_EQ(answer.objects(0).grasps_size(), asked.grippers_size());
  for (int i = 0; i < asked.grippers_size(); ++i) {
    const v1::Grasp& grasp = answer.objects(0).grasps(i);
    const v1::Gripper &sent = asked.grippers(i), &said = answer.grippers(i);
    if (sent.has_jaw()) {
      const double most_m = sent.jaw().max_opening_m();
      EXPECT_LE(grasp.opening_m(), most_m);
      EXPECT_LE(grasp.pre_grasp_opening_m(), most_m);
      EXPECT_NEAR(grasp.pre_grasp_opening_m(), most_m, 1e-7);
      EXPECT_EQ(said.jaw().max_opening_m(), most_m);
    } else {
      EXPECT_GE(grasp.usable_diameter_m(), sent.suction().diameter_m());
      EXPECT_NEAR(grasp.usable_diameter_m(), sent.suction().diameter_m(), 1e-7);
      EXPECT_EQ(said.suction().diameter_m(), sent.suction().diameter_m());
    }
  }
  EXPECT_EQ(answer.grippers(0).max_tilt_rad(), 0.8);
}

TEST(Answers, KeepGraspsWithinTheGripperThatStandsIn) {
  const v1::Detections answer = AnswerToWidestGrasps({});
  EXPECT_EQ(answer.grippers(0).jaw().max_opening_m(), 0.085);
  EXPECT_EQ(answer.objects(0).grasps(0).pre_grasp_opening_m(), 0.085);
}

TEST(Answers, SayHowTheCameraMoved) {
  Detections detections;
  detections.tracking.emplace();
  CameraMotion& motion = detections.tracking->motion;
  motion.last_from_this.translation() = Eigen::Vector3d(1, 2, 3);
  for (int source = 1; source <= static_cast<int>(CameraMotionSource::kUnknown); ++source) {
    motion.source = static_cast<CameraMotionSource>(source);
    const v1::Detections proto = AnswerWith(detections);
    EXPECT_EQ(proto.camera_motion().source(), source);
    EXPECT_EQ(proto.camera_motion().motion().position().y(), 2);
  }
}

}  // namespace
}  // namespace fovea::testing
