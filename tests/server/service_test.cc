// The service over real loopback, with a detector of the test's own where that shows more.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <future>
#include <mutex>
#include <new>
#include <opencv2/imgproc.hpp>
#include <thread>
#include <utility>

#include "client/images.h"
#include "core/types/too_complex.h"
#include "tests/server/detectors.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"

namespace fovea::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

// A detector that hands its frame to the test.
class Recorder {
 public:
  Detections operator()(const RgbdFrame& given, const DetectorOptions& options, Trace* trace,
                        const std::function<bool()>& should_stop) {
    {
      const std::scoped_lock lock(mutex_);
      frame_ = given;
    }
    return FindOne(given, options, trace, should_stop);
  }

  RgbdFrame Take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(frame_, {});
  }

 private:
  std::mutex mutex_;
  RgbdFrame frame_;
};

TEST(Detect, EchoesTheFrameAndStartsStageTimesWithQueueAndDecoding) {
  Loopback loopback(FindOne);
  v1::DetectRequest request = TestRequest();
  request.mutable_frame()->mutable_captured_at()->set_seconds(1234);
  const v1::Detections answer = loopback.client.Detect(request).detections();
  EXPECT_EQ(answer.frame_id(), "frame-7");
  EXPECT_EQ(answer.captured_at().seconds(), 1234);
  EXPECT_EQ(answer.profile(), "default");
  EXPECT_EQ(answer.width(), std::uint32_t{kWidth});
  EXPECT_EQ(answer.height(), std::uint32_t{kHeight});
  ASSERT_EQ(answer.stage_times_size(), 4);
  EXPECT_EQ(answer.stage_times(0).stage(), "queue");
  EXPECT_EQ(answer.stage_times(1).stage(), "decode");
  EXPECT_EQ(answer.stage_times(2).duration().nanos(), 1'500'000);
  EXPECT_EQ(answer.stage_times(3).stage(), "processor_wait");
  ASSERT_EQ(answer.objects_size(), 1);
  EXPECT_EQ(answer.objects(0).id(), "frame-7/1");
}

TEST(Detect, ReturnsOnlyWhatWasAskedFor) {
  Loopback loopback(FindOne);
  const v1::Detections bare = loopback.client.Detect(TestRequest()).detections();
  EXPECT_FALSE(bare.objects(0).has_mask());
  EXPECT_FALSE(bare.objects(0).has_cloud());
  EXPECT_FALSE(bare.objects(0).has_pose_in_reference());
  EXPECT_EQ(bare.saliency_maps_size() + bare.seeds_size(), 0);
  EXPECT_FALSE(bare.has_trace());

  v1::DetectRequest request = TestRequest();
  request.mutable_options()->set_return_masks(true);
  request.mutable_options()->set_return_clouds(true);
  request.mutable_options()->set_return_saliency_maps(true);
  request.mutable_options()->set_return_seeds(true);
  const v1::Detections full = loopback.client.Detect(request).detections();
  EXPECT_THAT(full.objects(0).mask().runs(), ::testing::ElementsAre(1, 11));
  EXPECT_THAT(full.objects(0).cloud().positions(), ::testing::ElementsAre(1, 2, 3));
  EXPECT_EQ(full.objects(0).cloud().colors().size(), 3U);
  EXPECT_EQ(full.seeds_size(), 2);
  ASSERT_EQ(full.saliency_maps_size(), 1);
  EXPECT_EQ(full.saliency_maps(0).name(), "color");
  EXPECT_EQ(full.saliency_maps(0).data()[0], '\xFF');
  EXPECT_EQ(full.saliency_maps(0).data()[1], '\0');
}

TEST(Detect, GivesThePoseInTheReferenceFrame) {
  Loopback loopback(FindOne);
  v1::DetectRequest request = TestRequest();
  v1::Pose& camera = *request.mutable_frame()->mutable_camera_pose();
  camera.mutable_position()->set_z(5);
  camera.mutable_orientation()->set_z(std::sqrt(0.5));  // a quarter turn: x becomes y
  camera.mutable_orientation()->set_w(std::sqrt(0.5));
  const auto answer = loopback.client.Detect(request);
  const auto& at = answer.detections().objects(0).pose_in_reference().position();
  EXPECT_NEAR(at.x(), -0.2, 1e-6);
  EXPECT_NEAR(at.y(), 0.1, 1e-6);
  EXPECT_NEAR(at.z(), 6.0, 1e-6);
}

TEST(Detect, DecodesEveryEncodingToTheSameFrame) {
  Recorder recorder;
  Loopback loopback(std::ref(recorder));
  const std::vector<v1::ColorImage> colors = TestColors();
  const std::vector<v1::DepthImage> depths = TestDepths();
  // The contract's first is none.
  ASSERT_EQ(static_cast<int>(colors.size()), v1::ColorEncoding_descriptor()->value_count() - 1);
  ASSERT_EQ(static_cast<int>(depths.size()), v1::DepthEncoding_descriptor()->value_count() - 1);
  const cv::Mat meters = TestMeters();
  for (const v1::ColorImage& color : colors) {
    for (const v1::DepthImage& depth : depths) {
      SCOPED_TRACE(v1::ColorEncoding_Name(color.encoding()) + " " +
                   v1::DepthEncoding_Name(depth.encoding()));
      v1::DetectRequest request = TestRequest();
      *request.mutable_frame()->mutable_color() = color;
      *request.mutable_frame()->mutable_depth() = depth;
      loopback.client.Detect(request);
      const RgbdFrame frame = recorder.Take();
      ASSERT_EQ(frame.color_rgb.size(), cv::Size(kWidth, kHeight));
      ASSERT_EQ(frame.depth_m.size(), cv::Size(kWidth, kHeight));
      const double loss = color.encoding() == v1::COLOR_ENCODING_JPEG ? 12 : 0;
      EXPECT_LE(cv::norm(frame.color_rgb, TestColor(), cv::NORM_INF), loss);
      EXPECT_EQ(std::memcmp(frame.depth_m.data, meters.data, meters.total() * meters.elemSize()),
                0);
    }
  }
}

TEST(Detect, StopsWhenTheDeadlinePasses) {
  Endless detector;
  Loopback loopback(std::ref(detector));
  const grpc::Status status =
      StatusOf([&] { loopback.client.Detect(TestRequest(), std::chrono::milliseconds(200)); });
  EXPECT_EQ(status.error_code(), grpc::StatusCode::DEADLINE_EXCEEDED);
  loopback.server.Drain();  // returns only when the detector has stopped
}

TEST(Detect, StopsWhenTheCallerLeaves) {
  Endless detector;
  Loopback loopback(std::ref(detector));
  {
    const auto stream = loopback.client.OpenStream(kPatience);
    v1::DetectStreamRequest request;
    *request.mutable_frame() = TestFrame();
    ASSERT_TRUE(stream->Send(request));
    detector.started.get_future().wait();
  }
  loopback.server.Drain();
}

TEST(Detect, WaitsForItsTurnOnlyAsLongAsTheDeadline) {
  Endless detector;
  server::ServerOptions options = LoopbackOptions();
  options.compute_threads = 1;
  Loopback loopback(std::ref(detector), options);
  const auto stream = loopback.client.OpenStream(kPatience);
  v1::DetectStreamRequest request;
  *request.mutable_frame() = TestFrame();
  ASSERT_TRUE(stream->Send(request));
  detector.started.get_future().wait();
  const grpc::Status status =
      StatusOf([&] { loopback.client.Detect(TestRequest(), std::chrono::milliseconds(200)); });
  EXPECT_EQ(status.error_code(), grpc::StatusCode::DEADLINE_EXCEEDED);
}

TEST(Detect, TurnsExceptionsIntoStatuses) {
  const auto status_of = [](auto exception) {
    Loopback loopback([=](auto&&...) -> Detections { throw exception; });
    return StatusOf([&] { loopback.client.Detect(TestRequest()); });
  };
  const grpc::Status invalid = status_of(TooComplex("too many seeds"));
  EXPECT_EQ(invalid.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
  EXPECT_EQ(invalid.error_message(), "options.parameters[voxels.size_m]: too many seeds");
  EXPECT_EQ(status_of(std::bad_alloc()).error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_EQ(status_of(Cancelled()).error_code(), grpc::StatusCode::CANCELLED);
  const grpc::Status internal = status_of(std::runtime_error("secret"));
  EXPECT_EQ(internal.error_code(), grpc::StatusCode::INTERNAL);
  EXPECT_THAT(internal.error_message(), ::testing::Not(HasSubstr("secret")));
}

TEST(Detect, ServesManyCallersAtOnce) {
  server::ServerOptions options = LoopbackOptions();
  options.max_waiting = 8;
  options.max_per_robot = 8;
  Loopback loopback(FindOne, options);
  std::vector<std::future<int>> counts;
  counts.reserve(8);
  for (int caller = 0; caller < 8; ++caller) {
    counts.push_back(std::async(std::launch::async, [&] {
      int objects = 0;
      for (int call = 0; call < 20; ++call) {
        objects += loopback.client.Detect(TestRequest()).detections().objects_size();
      }
      return objects;
    }));
  }
  for (auto& count : counts) EXPECT_EQ(count.get(), 20);
}

TEST(Detect, TakesLargeFramesByDefault) {
  const Loopback loopback(FindOne);
  v1::DetectRequest request = TestRequest();
  const cv::Mat color(1536, 2048, CV_8UC3, cv::Scalar(1, 2, 3)), depth(1536, 2048, CV_32FC1, 1.0F);
  *request.mutable_frame()->mutable_color() =
      ColorMessage(v1::COLOR_ENCODING_RGB8, BytesOf(color), color.cols, color.rows);
  *request.mutable_frame()->mutable_depth() =
      DepthMessage(v1::DEPTH_ENCODING_32FC1, BytesOf(depth), depth.cols, depth.rows);
  *request.mutable_frame()->mutable_intrinsics() =
      client::MakeIntrinsics(1700, 1700, 1023.5, 767.5);
  EXPECT_EQ(loopback.client.Detect(request).detections().width(), 2048U);
}

}  // namespace
}  // namespace fovea::testing
