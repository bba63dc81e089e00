// Places and turns for which one block of memory is missing: each that they want in turn.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
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

namespace {

constexpr int kNever = -1;
thread_local int blocks_until_failure = kNever;

}  // namespace

// Of the whole program.
void* operator new(std::size_t size) {
  const bool is_missing = blocks_until_failure >= 0 && blocks_until_failure-- == 0;
  void* const block = is_missing ? nullptr : std::malloc(std::max<std::size_t>(size, 1));
  if (block == nullptr) throw std::bad_alloc();
  return block;
}
void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }

namespace fovea::testing {
namespace {

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

TEST(MissingBlock, LeavesTurnsAsTheyWereWhereOneMoreFindsNone) {
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

TEST(MissingBlock, LosesNothingWhoseTurnHasComeWhereThereIsNone) {
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

TEST(MissingBlock, ComputesNoFrameThatWasRefusedForWantOfIt) {
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

TEST(MissingBlock, LeavesAnUploadThatFindsNoneNoPlace) {
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

TEST(MissingBlock, LeavesACallThatFindsNoneNoneOfThoseThatAreWaitedFor) {
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

TEST(MissingBlock, LeavesAStreamThatFindsNoneNoPlace) {
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

TEST(MissingBlock, LeavesAFrameOfAStreamThatFindsNoneNoRoom) {
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

TEST(MissingBlock, LeavesAStreamThatTakesPicksAndFindsNoneForgotten) {
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
