// Identities in a stream, over real loopback.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <memory>

#include "tests/server/detectors.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"

namespace fovea::testing {
namespace {

using ::testing::HasSubstr;

v1::DetectStreamRequest TrackedFrame(std::uint32_t reset = 0) {
  v1::DetectStreamRequest request;
  *request.mutable_frame() = TestFrame();
  request.mutable_options()->mutable_tracking()->set_enabled(true);
  request.mutable_options()->mutable_tracking()->set_reset(reset);
  return request;
}

v1::Detections AnswerOver(client::DetectStream& stream, const v1::DetectStreamRequest& request) {
  EXPECT_TRUE(stream.Send(request));
  const auto response = stream.Receive();
  EXPECT_TRUE(response && response->has_detections());
  return response ? response->detections() : v1::Detections();
}

TEST(Tracking, AnObjectKeepsItsIdInAStream) {
  const Loopback loopback(FindOne);
  const auto stream = loopback.client.OpenStream(kPatience);
  v1::DetectStreamRequest request = TrackedFrame();
  request.mutable_frame()->mutable_captured_at()->set_seconds(1000);
  request.mutable_frame()->mutable_captured_at()->set_nanos(123456789);
  request.mutable_frame()->mutable_camera_pose()->mutable_orientation()->set_w(1);
  const v1::Detections first = AnswerOver(*stream, request);
  ASSERT_EQ(first.objects_size(), 1);
  EXPECT_EQ(first.objects(0).track_id(), 1U);
  EXPECT_EQ(first.objects(0).times_seen(), 1U);
  EXPECT_NE(first.track_epoch(), 0U);
  EXPECT_FALSE(first.has_camera_motion());
  EXPECT_EQ(first.stage_times().rbegin()->stage(), "tracking");

  request.clear_options();  // the last ones hold
  request.mutable_frame()->mutable_captured_at()->set_seconds(1001);
  request.mutable_frame()->mutable_camera_pose()->mutable_position()->set_x(0.01);
  const v1::Detections next = AnswerOver(*stream, request);
  const v1::Object& object = next.objects(0);
  EXPECT_EQ(object.track_id(), 1U);
  EXPECT_EQ(object.times_seen(), 2U);
  EXPECT_EQ(object.first_seen().seconds(), 1000);
  EXPECT_EQ(object.first_seen().nanos(), 123456789);
  EXPECT_EQ(object.steadied_over(), 2U);
  // It was 10 mm to the left when the camera was.
  EXPECT_NEAR(object.steadied_box().pose().position().x(),
              object.oriented_box().pose().position().x() - 0.005, 1e-6);
  EXPECT_EQ(next.track_epoch(), first.track_epoch());
  EXPECT_EQ(next.camera_motion().source(), v1::CAMERA_MOTION_SOURCE_REQUEST);
  EXPECT_NEAR(next.camera_motion().motion().position().x(), 0.01, 1e-9);
}

TEST(Tracking, IsOffUnlessAskedFor) {
  const Loopback loopback(FindOne);
  const auto stream = loopback.client.OpenStream(kPatience);
  v1::DetectStreamRequest request = TrackedFrame();
  request.clear_options();
  for (int i = 0; i < 2; ++i) {
    const v1::Detections plain = AnswerOver(*stream, request);
    EXPECT_EQ(plain.track_epoch(), 0U);
    EXPECT_EQ(plain.objects(0).track_id(), 0U);
    EXPECT_FALSE(plain.objects(0).has_steadied_box());
    EXPECT_NE(plain.stage_times().rbegin()->stage(), "tracking");
  }
}

TEST(Tracking, AnotherNumberStartsAnew) {
  const Loopback loopback(FindOne);
  const auto stream = loopback.client.OpenStream(kPatience);
  const v1::Detections before = AnswerOver(*stream, TrackedFrame(0));
  AnswerOver(*stream, TrackedFrame(0));
  const v1::Detections after = AnswerOver(*stream, TrackedFrame(1));
  EXPECT_NE(after.track_epoch(), before.track_epoch());
  EXPECT_EQ(after.objects(0).times_seen(), 1U);
  const v1::Detections later = AnswerOver(*stream, TrackedFrame(1));
  EXPECT_EQ(later.track_epoch(), after.track_epoch());
  EXPECT_EQ(later.objects(0).times_seen(), 2U);

  v1::DetectStreamRequest off = TrackedFrame(1);
  off.mutable_options()->clear_tracking();
  AnswerOver(*stream, off);
  EXPECT_NE(AnswerOver(*stream, TrackedFrame(1)).track_epoch(), later.track_epoch());
}

TEST(Tracking, RobotsHaveTheirOwnTracks) {
  const Loopback loopback(FindOne);
  const auto one = loopback.client.OpenStream(kPatience);
  const auto other = loopback.client.OpenStream(kPatience);
  for (std::uint32_t seen = 1; seen <= 3; ++seen) {
    const v1::Detections a = AnswerOver(*one, TrackedFrame());
    EXPECT_EQ(a.objects(0).times_seen(), seen);
    const v1::Detections b = AnswerOver(*other, TrackedFrame());
    EXPECT_EQ(b.objects(0).times_seen(), seen);
    EXPECT_NE(a.track_epoch(), b.track_epoch());
  }
}

TEST(Tracking, TellsOfWhatIsHidden) {
  int frames = 0;
  const Loopback loopback([&frames](const RgbdFrame& frame, const DetectorOptions& options,
                                    Trace* trace, const std::function<bool()>& should_stop) {
    Detections detections = FindOne(frame, options, trace, should_stop);
    if (++frames == 3) {
      detections.objects.clear();
      detections.labels.setTo(0);
    }
    return detections;
  });
  v1::DetectStreamRequest standing = TrackedFrame();
  standing.mutable_frame()->mutable_camera_pose()->mutable_orientation()->set_w(1);
  const auto stream = loopback.client.OpenStream(kPatience);
  AnswerOver(*stream, standing);
  EXPECT_EQ(AnswerOver(*stream, standing).hidden_tracks_size(), 0);
  const v1::Detections hidden = AnswerOver(*stream, standing);
  ASSERT_EQ(hidden.hidden_tracks_size(), 1);
  EXPECT_EQ(hidden.hidden_tracks(0).track_id(), 1U);
  EXPECT_EQ(hidden.hidden_tracks(0).times_seen(), 2U);
  EXPECT_FALSE(hidden.hidden_tracks(0).has_last_seen()) << "the frames have no times";
  EXPECT_EQ(hidden.hidden_tracks(0).reason(), v1::HIDDEN_REASON_OUT_OF_VIEW)
      << "its one point, 2 m down and 3 m ahead, is below the image";
  EXPECT_NEAR(hidden.hidden_tracks(0).last_box().size().x(), 0.3, 1e-6);
  const v1::Detections again = AnswerOver(*stream, standing);
  EXPECT_EQ(again.hidden_tracks_size(), 0);
  EXPECT_EQ(again.objects(0).track_id(), 1U);
  EXPECT_EQ(again.objects(0).times_seen(), 3U);

  // Where nothing tells where the camera is, nothing tells where the thing is.
  frames = 0;
  const auto lost = loopback.client.OpenStream(kPatience);
  for (int i = 0; i < 2; ++i) AnswerOver(*lost, TrackedFrame());
  EXPECT_EQ(AnswerOver(*lost, TrackedFrame()).hidden_tracks(0).reason(),
            v1::HIDDEN_REASON_NOT_DETECTED);
}

// The limit passes just before the tracks; answers are put back into a lens after them.
TEST(Tracking, CountsAnswersAlone) {
  int frames = 0;
  server::ServerOptions options = LoopbackOptions();
  options.max_compute_ms = 20;
  const Loopback loopback(
      [&frames](const RgbdFrame& frame, const DetectorOptions& detector_options, Trace* trace,
                const std::function<bool()>& should_stop) {
        while (frames == 0 && !should_stop()) {
        }
        ++frames;
        return FindOne(frame, detector_options, trace, should_stop);
      },
      options);
  v1::DetectStreamRequest request = TrackedFrame();
  v1::LensDistortion& lens = *request.mutable_frame()->mutable_intrinsics()->mutable_distortion();
  lens.set_model(v1::DISTORTION_MODEL_BROWN_CONRADY);
  for (const double coefficient : {-0.01, 0.0, 0.0, 0.0}) lens.add_coefficients(coefficient);
  const auto stream = loopback.client.OpenStream(kPatience);
  ASSERT_TRUE(stream->Send(request));
  const std::uint32_t answers = stream->Receive()->has_detections() ? 1 : 0;
  EXPECT_EQ(AnswerOver(*stream, request).objects(0).times_seen(), answers + 1);
}

TEST(Tracking, NeedsAStream) {
  const Loopback loopback(FindOne);
  v1::DetectRequest request = TestRequest();
  request.mutable_options()->mutable_tracking()->set_enabled(true);
  const grpc::Status status = StatusOf([&] { loopback.client.Detect(request); });
  EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
  EXPECT_THAT(status.error_message(), HasSubstr("options.tracking.enabled"));
  request.mutable_options()->mutable_tracking()->set_enabled(false);
  EXPECT_NO_THROW(loopback.client.Detect(request));
}

}  // namespace
}  // namespace fovea::testing
