// Messages for which there is no memory when their turn has come.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <limits>
#include <new>
#include <semaphore>
#include <string>
#include <vector>

#include "server/access/stream_places.h"
#include "server/observing/pick_board.h"
#include "server/rpc/frame_room.h"
#include "server/rpc/live_calls.h"
#include "server/scheduling/scheduler.h"
#include "server/scheduling/turn_queue.h"
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
constexpr int kNever = -1;
thread_local int blocks_until_failure = kNever;

void* BlockOrNull(std::size_t size) {
  if (blocks_until_failure >= 0 && blocks_until_failure-- == 0) return nullptr;
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

// Whether `step` throws where the n-th block from now on that this thread wants is not there.
template <typename Step>
bool FailsWithoutBlock(int n, const Step& step) {
  blocks_until_failure = n;
  try {
    step();
  } catch (const std::bad_alloc&) {
    blocks_until_failure = kNever;
    return true;
  }
  blocks_until_failure = kNever;
  return false;
}

// Calls `trial` with 0, 1, … until it says that this block was not wanted. Returns how many were.
template <typename Trial>
int ForEachBlock(const Trial& trial) {
  int n = 0;
  for (; trial(n); ++n) {
  }
  return n;
}

// Too long for a string to hold them without a block.
server::RobotId RobotOf(int number) {
  const std::string digits = std::to_string(number);
  return {"the group of robot number " + digits, "the name of robot number " + digits};
}

std::vector<int> PopAll(server::TurnQueue<int>& queue) {
  std::vector<int> items;
  while (const auto item = queue.Pop([](const server::RobotId&) { return true; })) {
    items.push_back(*item);
  }
  return items;
}

server::TurnQueue<int> QueueOf(int num_robots) {
  server::TurnQueue<int> queue;
  for (int i = 0; i < 2 * num_robots; ++i) queue.Push(RobotOf(i % num_robots), i);
  return queue;
}

TEST(ShortMemory, LeavesTurnsAsTheyWereWhereOneMoreFindsNone) {
  constexpr int kFew = 5;
  const server::RobotId newcomer = RobotOf(kFew);
  const std::vector<int> before = [] {
    server::TurnQueue<int> queue = QueueOf(kFew);
    return PopAll(queue);
  }();
  EXPECT_GT(ForEachBlock([&](int n) {
              SCOPED_TRACE(n);
              server::TurnQueue<int> queue = QueueOf(kFew);
              if (!FailsWithoutBlock(n, [&] { queue.Push(newcomer, 100); })) return false;
              EXPECT_EQ(PopAll(queue), before);
              queue.Push(newcomer, 101);
              EXPECT_THAT(PopAll(queue), ::testing::ElementsAre(101));
              return true;
            }),
            3);
}

TEST(ShortMemory, LosesNothingWhoseTurnHasComeWhereThereIsNone) {
  constexpr int kMany = 40;  // more than a piece of a queue holds
  for (int num_robots = 1; num_robots <= kMany; ++num_robots) {
    SCOPED_TRACE(num_robots);
    ForEachBlock([&](int n) {
      SCOPED_TRACE(n);
      server::TurnQueue<int> queue = QueueOf(num_robots);
      const auto pop = [&] { queue.Pop([](const server::RobotId&) { return true; }); };
      if (!FailsWithoutBlock(n, pop)) return false;
      EXPECT_EQ(PopAll(queue).size(), 2U * static_cast<unsigned>(num_robots));
      return true;
    });
  }
}

// A scheduler of one thread, which a frame of robot 0 holds until the gate is open, with two more
// frames of that robot that wait.
class FullDesk {
 public:
  FullDesk() {
    displaced.reserve(1);  // what is told finds memory
    Submit(0, 0);
    begun_.acquire();
    Submit(0, 1);
    Submit(0, 2);
  }

  void Submit(int robot, int frame) {
    const server::RobotId id = RobotOf(robot);
    scheduler.Submit(id, {.compute =
                              [this, frame] {
                                if (frame == 0) {
                                  begun_.release();
                                  gate_.acquire();
                                }
                                computed_.push_back(frame);
                              },
                          .deliver = [this] { delivered_.release(); },
                          .displaced = [this, frame](const auto&) { displaced.push_back(frame); }});
  }

  // After `count` frames.
  std::vector<int> ComputedOf(int count) {
    gate_.release();
    for (int i = 0; i < count; ++i) delivered_.acquire();
    return computed_;
  }

  std::vector<int> displaced;

 private:
  std::vector<int> computed_;
  std::binary_semaphore gate_{0}, begun_{0};
  std::counting_semaphore<> delivered_{0};

 public:
  server::Scheduler scheduler{{.num_threads = 1, .max_waiting = 2, .max_per_robot = 3}};
};

TEST(ShortMemory, ComputesNoFrameThatWasRefusedForWantOfIt) {
  EXPECT_GT(ForEachBlock([](int n) {
              SCOPED_TRACE(n);
              FullDesk desk;
              const bool fails = FailsWithoutBlock(n, [&] { desk.Submit(1, 3); });
              EXPECT_EQ(desk.scheduler.NumWaiting(), 2U);
              // Each of the others is computed or told that it is not.
              if (fails) {
                EXPECT_THAT(desk.displaced, ::testing::IsEmpty());
                EXPECT_THAT(desk.ComputedOf(3), ::testing::ElementsAre(0, 1, 2));
              } else {
                EXPECT_THAT(desk.displaced, ::testing::ElementsAre(2));
                EXPECT_THAT(desk.ComputedOf(3), ::testing::UnorderedElementsAre(0, 1, 3));
              }
              EXPECT_EQ(desk.scheduler.NumWaiting(), 0U);
              return fails;
            }),
            3);
}

TEST(ShortMemory, LeavesAnUploadThatFindsNoneNoPlace) {
  EXPECT_GT(ForEachBlock([](int n) {
              SCOPED_TRACE(n);
              server::Scheduler scheduler({.num_threads = 1, .max_per_robot = 1});
              const server::RobotId robot = RobotOf(0);
              const bool fails = FailsWithoutBlock(n, [&] { scheduler.Enter(robot); });
              scheduler.Enter(robot);
              return fails;
            }),
            3);
}

TEST(ShortMemory, LeavesACallThatFindsNoneNoneOfThoseThatAreWaitedFor) {
  for (const bool begins : {false, true}) {
    EXPECT_GT(ForEachBlock([begins](int n) {
                SCOPED_TRACE(n);
                server::LiveCalls calls;
                const bool fails = FailsWithoutBlock(
                    n, [&] { const auto token = begins ? calls.Begin([] {}) : calls.Enter(); });
                calls.WaitUntilNone();
                EXPECT_EQ(calls.GiveUp(), 0U);
                return fails;
              }),
              0);
  }
}

TEST(ShortMemory, LeavesAStreamThatFindsNoneNoPlace) {
  EXPECT_GT(
      ForEachBlock([](int n) {
        SCOPED_TRACE(n);
        server::StreamPlaces places({.max_streams = 1, .max_per_host = 1, .max_per_robot = 1});
        const server::RobotId robot = RobotOf(0);
        const bool fails = FailsWithoutBlock(n, [&] { places.Take(robot); });
        places.Take(robot);
        return fails;
      }),
      3);
}

TEST(ShortMemory, LeavesAFrameOfAStreamThatFindsNoneNoRoom) {
  constexpr std::size_t kAll = 100;
  const std::string group = RobotOf(0).group, other = RobotOf(1).group;
  EXPECT_GT(ForEachBlock([&](int n) {
              SCOPED_TRACE(n);
              server::FrameRoom room(kAll);
              const bool fails = FailsWithoutBlock(n, [&] { room.Take(group, kAll); });
              EXPECT_NE(room.Take(other, kAll), nullptr) << "it is alone";
              return fails;
            }),
            2);
}

TEST(ShortMemory, LeavesAStreamThatTakesPicksAndFindsNoneForgotten) {
  const std::string robot = RobotOf(0).name;
  EXPECT_GT(ForEachBlock([&](int n) {
              SCOPED_TRACE(n);
              server::PickBoard board;
              const bool fails = FailsWithoutBlock(n, [&] { board.Listen(robot); });
              const auto deliver = [&] {
                board.Deliver(robot, true, {}, std::chrono::milliseconds(0), [] { return false; });
              };
              EXPECT_THROW(deliver(), server::NoPicksTaken);
              return fails;
            }),
            1);
}

}  // namespace
}  // namespace fovea::testing
