// Messages for which there is no memory when their turn has come.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <limits>
#include <new>
#include <string>

#include "tests/server/captured_log.h"
#include "tests/server/detectors.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"
#include "tests/server/metric_value.h"

namespace {

constexpr std::size_t kAny = std::numeric_limits<std::size_t>::max();
std::atomic<std::size_t> largest_block = kAny;
std::atomic<int> num_failing_after = 0;  // of the blocks that the same thread wants next
thread_local int num_failing = 0;

void* BlockOrNull(std::size_t size) {
  if (size > largest_block) {
    num_failing = num_failing_after;
    return nullptr;
  }
  if (num_failing > 0) {
    --num_failing;
    return nullptr;
  }
  return std::malloc(std::max<std::size_t>(size, 1));
}

}  // namespace

// Of the whole program: there is no other way to have the parser of messages find no memory.
void* operator new(std::size_t size) {
  void* const block = BlockOrNull(size);
  if (block == nullptr) throw std::bad_alloc();
  return block;
}
void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }

namespace fovea::testing {
namespace {

using ::testing::HasSubstr;

// As long as it lives there is none for an image of this size, which gRPC's own buffers hold.
class ShortMemory {
 public:
  explicit ShortMemory(int more_failures = 0) {
    num_failing_after = more_failures;
    largest_block = kImage / 2;
  }
  ~ShortMemory() { largest_block = kAny; }
  ShortMemory(const ShortMemory&) = delete;
  ShortMemory& operator=(const ShortMemory&) = delete;

  static v1::Frame LargeFrame() {
    v1::Frame frame = TestFrame();
    frame.mutable_color()->set_data(std::string(kImage, 'x'));
    return frame;
  }

 private:
  static constexpr std::size_t kImage = std::size_t{8} << 20;
};

constexpr const char* kSays = "not enough memory for this frame";

void ExpectAnswered(const server::Metrics& metrics, double number) {
  EXPECT_EQ(MetricValue(metrics, "fovea_frames_received_total"), number);
  EXPECT_EQ(MetricValue(metrics, "fovea_frames_answered_total"), number);
}

TEST(ShortMemory, IsTheAnswerToACallWhoseMessageFindsNone) {
  const CapturedLog log;
  {
    Loopback loopback(FindOne);
    v1::DetectRequest request;
    *request.mutable_frame() = ShortMemory::LargeFrame();
    {
      const ShortMemory until_answered;
      const grpc::Status status = StatusOf([&] { loopback.client.Detect(request); });
      EXPECT_EQ(status.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
      EXPECT_EQ(status.error_message(), kSays);
    }
    ExpectAnswered(*loopback.server.metrics(), 1);
    EXPECT_EQ(loopback.client.Detect(TestRequest()).detections().objects_size(), 1);
  }
  EXPECT_THAT(log.text(), HasSubstr(kSays));
}

TEST(ShortMemory, IsTheAnswerToAFrameOfAStreamThatFindsNone) {
  const CapturedLog log;
  {
    Loopback loopback(FindOne);
    const auto stream = loopback.client.OpenStream(kPatience);
    v1::DetectStreamRequest request;
    *request.mutable_frame() = ShortMemory::LargeFrame();
    request.mutable_options()->set_return_masks(true);
    {
      const ShortMemory until_answered;
      ASSERT_TRUE(stream->Send(request));
      EXPECT_EQ(stream->Receive()->error().message(), kSays);
    }
    ExpectAnswered(*loopback.server.metrics(), 1);
    *request.mutable_frame() = TestFrame();
    request.clear_options();
    ASSERT_TRUE(stream->Send(request));
    const auto answer = stream->Receive();
    ASSERT_EQ(answer->detections().objects_size(), 1);
    EXPECT_TRUE(answer->detections().objects(0).has_mask()) << "its options hold";
  }
  EXPECT_THAT(log.text(), HasSubstr(kSays));
}

TEST(ShortMemory, HasAnAnswerEvenWhereThereIsNoneToSayWhy) {
  const CapturedLog log;
  Loopback loopback(FindOne);
  const auto stream = loopback.client.OpenStream(kPatience);
  v1::DetectStreamRequest request;
  *request.mutable_frame() = ShortMemory::LargeFrame();
  const ShortMemory until_answered(/*more_failures=*/1);
  ASSERT_TRUE(stream->Send(request));
  EXPECT_EQ(stream->Receive()->error().code(), grpc::StatusCode::INTERNAL);
}

}  // namespace
}  // namespace fovea::testing
