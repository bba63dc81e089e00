// Turns and places without a network; a gate holds the compute threads.
#include "server/scheduling/scheduler.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <future>
#include <mutex>
#include <semaphore>
#include <string>
#include <vector>

namespace fovea::server {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

// Submits named frames and notes what becomes of them.
class Desk {
 public:
  explicit Desk(const SchedulerLimits& limits) : scheduler_(limits) {}
  ~Desk() { gate_.release(100); }

  Scheduler::Ticket Submit(const RobotId& robot, const std::string& frame) {
    return scheduler_.Submit(robot, {.compute =
                                         [this, frame] {
                                           Note(begun_, frame);
                                           gate_.acquire();
                                         },
                                     .deliver = [this, frame] { Note(answered_, frame); },
                                     .displaced =
                                         [this, frame](const Overloaded& why) {
                                           EXPECT_STREQ(why.reason, "DISPLACED");
                                           EXPECT_GE(why.retry_after.count(), 10);
                                           Note(displaced_, frame);
                                         }});
  }

  // What a refusal says.
  std::string Refusal(const RobotId& robot,
                      Scheduler::IfFull if_full = Scheduler::IfFull::kKeepPlace) {
    try {
      scheduler_.Enter(robot, if_full);
    } catch (const Overloaded& full) {
      return std::string(full.reason) + ": " + full.what();
    }
    return "";
  }

  // When a robot that is refused is told to come back.
  std::chrono::milliseconds RetryAfter(const RobotId& robot) {
    try {
      scheduler_.Enter(robot);
    } catch (const Overloaded& full) {
      return full.retry_after;
    }
    ADD_FAILURE() << "was let in";
    return {};
  }

  void AwaitBegun(std::size_t count) { Await(begun_, count); }
  // Until so many are answered, from the start.
  std::vector<std::string> LetAll(std::size_t count) {
    gate_.release(static_cast<std::ptrdiff_t>(count - num_let_));
    num_let_ = count;
    Await(answered_, count);
    return begun();
  }

  std::vector<std::string> begun() { return Copy(begun_); }
  std::vector<std::string> displaced() { return Copy(displaced_); }
  Scheduler& scheduler() { return scheduler_; }

 private:
  void Note(std::vector<std::string>& list, const std::string& frame) {
    const std::lock_guard lock(mutex_);
    list.push_back(frame);
    changed_.notify_all();
  }
  void Await(const std::vector<std::string>& list, std::size_t count) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return list.size() >= count; });
  }
  std::vector<std::string> Copy(const std::vector<std::string>& list) {
    const std::lock_guard lock(mutex_);
    return list;
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::string> begun_, answered_, displaced_;
  std::counting_semaphore<> gate_{0};
  std::size_t num_let_ = 0;
  Scheduler scheduler_;  // last: its threads use all of the above
};

RobotId Named(const std::string& name) { return {"host", name}; }

SchedulerLimits OneThread() { return {.num_threads = 1, .max_waiting = 2, .max_per_robot = 10}; }

TEST(Scheduler, ANewcomerTakesThePlaceOfWhoHoldsMost) {
  Desk desk(OneThread());
  for (const char* frame : {"greedy 1", "greedy 2", "greedy 3"}) {
    desk.Submit(Named("greedy"), frame);
    desk.AwaitBegun(1);
  }
  desk.Submit(Named("second"), "second");
  EXPECT_THAT(desk.displaced(), ElementsAre("greedy 3"));
  desk.Submit(Named("third"), "third");
  EXPECT_THAT(desk.displaced(), ElementsAre("greedy 3", "greedy 2"));
  EXPECT_THAT(desk.Refusal(Named("fourth")), HasSubstr("QUEUE_FULL: the queue is full with 3"));
  EXPECT_THAT(desk.LetAll(3), ElementsAre("greedy 1", "second", "third"));
}

TEST(Scheduler, NobodyLosesAPlaceToOneWhoWouldHaveAsMany) {
  Desk desk(OneThread());
  desk.Submit(Named("a"), "a1");
  desk.AwaitBegun(1);
  desk.Submit(Named("b"), "b1");
  desk.Submit(Named("b"), "b2");
  EXPECT_THAT(desk.Refusal(Named("a")), Not(IsEmpty()));  // it would have two, and b one
  desk.Submit(Named("c"), "c1");
  EXPECT_THAT(desk.displaced(), ElementsAre("b2"));
}

TEST(Scheduler, ManyNamesHoldNoMoreThanOneHost) {
  Desk desk(OneThread());
  desk.Submit({"many", "1"}, "many 1");
  desk.AwaitBegun(1);
  desk.Submit({"many", "2"}, "many 2");
  desk.Submit({"many", "3"}, "many 3");
  EXPECT_THAT(desk.Refusal({"many", "4"}), HasSubstr("QUEUE_FULL"));
  desk.Submit({"few", "a"}, "few");
  EXPECT_EQ(desk.displaced().size(), 1U);
  EXPECT_THAT(desk.Refusal({"few", "b"}), HasSubstr("QUEUE_FULL"));  // 2 places and 1: as fair
}

TEST(Scheduler, HostsTakeTurnsBeforeNamesDo) {
  Desk desk({.num_threads = 1, .max_waiting = 10, .max_per_robot = 10});
  desk.Submit({"many", "1"}, "many 1");
  desk.AwaitBegun(1);
  for (const char* name : {"2", "3", "4"}) desk.Submit({"many", name}, std::string("many ") + name);
  desk.Submit({"few", "a"}, "few 1");
  desk.Submit({"few", "a"}, "few 2");
  EXPECT_THAT(desk.LetAll(6),
              ElementsAre("many 1", "many 2", "few 1", "many 3", "few 2", "many 4"));
}

// Places in line are kept longer than a test takes.
SchedulerLimits OneThreadAndALine(int max_waiting) {
  return {.num_threads = 1,
          .max_waiting = max_waiting,
          .max_per_robot = 10,
          .grace = std::chrono::hours(1)};
}

TEST(Scheduler, LetsInFirstWhomItTurnedAwayFirst) {
  Desk desk(OneThreadAndALine(/*max_waiting=*/1));
  desk.Submit(Named("first"), "first");
  desk.AwaitBegun(1);
  const Scheduler::Ticket second = desk.Submit(Named("second"), "second");
  EXPECT_THAT(desk.Refusal(Named("third")), HasSubstr("2 frames"));
  EXPECT_THAT(desk.Refusal(Named("fourth")), HasSubstr("2 frames and 1 robots in line"));
  EXPECT_TRUE(desk.scheduler().Withdraw(Named("second"), second));
  EXPECT_THAT(desk.Refusal(Named("fourth")), HasSubstr("1 frames and 1 robots in line"));
  EXPECT_THAT(desk.Refusal(Named("newcomer")), HasSubstr("1 frames and 2 robots in line"));
  desk.Submit(Named("third"), "third");
  EXPECT_THAT(desk.LetAll(2), ElementsAre("first", "third"));
}

TEST(Scheduler, KeepsNoPlaceForWhoComesOnlyIfThereIsRoom) {
  Desk desk(OneThreadAndALine(/*max_waiting=*/0));
  desk.Submit(Named("first"), "first");
  desk.AwaitBegun(1);
  EXPECT_THAT(desk.Refusal(Named("second"), Scheduler::IfFull::kForget), HasSubstr("QUEUE_FULL"));
  EXPECT_THAT(desk.Refusal(Named("third")), Not(HasSubstr("in line")));
  EXPECT_THAT(desk.Refusal(Named("fourth")), HasSubstr("1 robots in line"));
}

// A guess of 100 ms at first, of which each piece of work leaves nine tenths.
TEST(Scheduler, TellsWhenToComeBackByWhatWorkTook) {
  Desk desk(OneThreadAndALine(/*max_waiting=*/0));
  const auto begin = std::chrono::steady_clock::now();
  constexpr int kTimes = 20;
  for (int time = 1; time <= kTimes; ++time) {
    desk.Submit(Named("a"), "short");
    desk.LetAll(static_cast<std::size_t>(time));
  }
  const std::chrono::duration<double, std::milli> all = std::chrono::steady_clock::now() - begin;
  desk.Submit(Named("a"), "long");
  desk.AwaitBegun(kTimes + 1);
  EXPECT_LE(desk.RetryAfter(Named("b")).count(), 100 * std::pow(0.9, kTimes) + all.count() + 1);
}

TEST(Scheduler, WhoHoldsPlacesHasNoneInLine) {
  Desk desk(OneThreadAndALine(/*max_waiting=*/1));
  desk.Submit(Named("a"), "a");
  desk.AwaitBegun(1);
  desk.Submit(Named("b"), "b");
  EXPECT_THAT(desk.Refusal(Named("b")), Not(HasSubstr("in line")));
  EXPECT_THAT(desk.Refusal(Named("c")), Not(HasSubstr("in line")));
  EXPECT_THAT(desk.Refusal(Named("d")), HasSubstr("1 robots in line"));
}

TEST(Scheduler, OneRobotLeavesAThreadToOthers) {
  Desk desk({.num_threads = 2, .max_waiting = 10, .max_per_robot = 10});
  desk.Submit(Named("modest"), "modest 1");
  desk.LetAll(1);
  desk.Submit(Named("greedy"), "greedy 1");
  desk.Submit(Named("greedy"), "greedy 2");
  desk.AwaitBegun(2);
  desk.Submit(Named("modest"), "modest 2");
  desk.AwaitBegun(3);
  EXPECT_THAT(desk.begun(), ElementsAre("modest 1", "greedy 1", "modest 2"));
  EXPECT_THAT(desk.LetAll(4), ElementsAre("modest 1", "greedy 1", "modest 2", "greedy 2"));
}

TEST(Scheduler, ARobotAloneHasAllThreads) {
  Desk desk({.num_threads = 2, .max_waiting = 2, .max_per_robot = 10});
  desk.Submit(Named("only"), "1");
  desk.Submit(Named("only"), "2");
  desk.AwaitBegun(2);
  EXPECT_EQ(desk.scheduler().NumBusy(), 2U);
}

TEST(Scheduler, ALimitOfThreadsHoldsForWhoIsAloneToo) {
  Desk desk({.num_threads = 2, .max_waiting = 4, .max_per_robot = 10, .max_running_per_robot = 1});
  desk.Submit(Named("only"), "1");
  desk.Submit(Named("only"), "2");
  desk.Submit(Named("other"), "3");
  desk.AwaitBegun(2);
  EXPECT_EQ(desk.scheduler().NumWaiting(), 1U);
  EXPECT_THAT(desk.begun(), ::testing::UnorderedElementsAre("1", "3"));
}

TEST(Scheduler, CountsWhatIsOnItsWay) {
  Desk desk({.num_threads = 1, .max_waiting = 2, .max_per_robot = 2});
  const auto first = desk.scheduler().Enter(Named("a"));
  auto second = desk.scheduler().Enter(Named("a"));
  EXPECT_THAT(desk.Refusal(Named("a")), HasSubstr("ROBOT_LIMIT: this robot has 2 frames on the "));
  EXPECT_THAT(desk.Refusal(Named("b")), IsEmpty());
  second.reset();
  EXPECT_THAT(desk.Refusal(Named("a")), IsEmpty());
}

TEST(Scheduler, OutlivesWorkThatThrows) {
  Scheduler scheduler(OneThread());
  std::promise<void> done;
  scheduler.Submit(
      Named("a"),
      {.compute = [] { throw 1; }, .deliver = [] { throw std::bad_alloc(); }, .displaced = {}});
  scheduler.Submit(Named("a"),
                   {.compute = [] {}, .deliver = [&] { done.set_value(); }, .displaced = {}});
  done.get_future().get();
  EXPECT_EQ(scheduler.NumWaiting(), 0U);
}

}  // namespace
}  // namespace fovea::server
