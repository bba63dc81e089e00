// What is thrown in the midst of a frame: the caller learns whose mistake it is, and all goes on.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <new>
#include <opencv2/core.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/server/detectors.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"

namespace fovea::testing {
namespace {

using ::testing::HasSubstr;

struct Mishap {
  std::string name;
  std::function<void()> happen;
  grpc::StatusCode code;
  std::string says;
};

std::vector<Mishap> Mishaps() {
  constexpr auto kInternal = grpc::StatusCode::INTERNAL;
  return {
      {"invalid_argument", [] { throw std::invalid_argument("stoi"); }, kInternal,
       "internal error"},
      {"length_error", [] { throw std::length_error("vector"); }, kInternal, "internal error"},
      {"opencv", [] { throw cv::Exception(-1, "assert", "f", "file", 1); }, kInternal, "internal"},
      {"int", [] { throw 1; }, kInternal, "internal error"},
      {"bad_alloc", [] { throw std::bad_alloc(); }, grpc::StatusCode::RESOURCE_EXHAUSTED,
       "not enough memory"},
  };
}

// Throws at every second frame, what comes next.
class Unlucky {
 public:
  Detections operator()(const RgbdFrame& frame, const DetectorOptions& options, Trace* trace,
                        const std::function<bool()>& should_stop) {
    const std::size_t frame_number = num_frames_++;
    if (frame_number % 2 == 0) mishaps_.at(frame_number / 2).happen();
    return FindOne(frame, options, trace, should_stop);
  }

 private:
  const std::vector<Mishap> mishaps_ = Mishaps();
  std::size_t num_frames_ = 0;
};

TEST(Exceptions, EndTheCallTheyHappenIn) {
  Loopback loopback{Unlucky()};
  for (const Mishap& mishap : Mishaps()) {
    SCOPED_TRACE(mishap.name);
    const grpc::Status status = StatusOf([&] { loopback.client.Detect(TestRequest()); });
    EXPECT_EQ(status.error_code(), mishap.code);
    EXPECT_THAT(status.error_message(), HasSubstr(mishap.says));
    EXPECT_EQ(loopback.client.Detect(TestRequest()).detections().objects_size(), 1);
  }
}

TEST(Exceptions, AreTheAnswerToAFrameOfAStream) {
  Loopback loopback{Unlucky()};
  const auto stream = loopback.client.OpenStream(kPatience);
  v1::DetectStreamRequest request;
  *request.mutable_frame() = TestFrame();
  for (const Mishap& mishap : Mishaps()) {
    SCOPED_TRACE(mishap.name);
    ASSERT_TRUE(stream->Send(request));
    const auto bad = stream->Receive();
    ASSERT_TRUE(bad);
    EXPECT_EQ(bad->error().code(), mishap.code);
    EXPECT_THAT(bad->error().message(), HasSubstr(mishap.says));
    ASSERT_TRUE(stream->Send(request));
    EXPECT_TRUE(stream->Receive()->has_detections());
  }
}

}  // namespace
}  // namespace fovea::testing
