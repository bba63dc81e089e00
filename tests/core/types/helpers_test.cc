#include "core/types/helpers.h"

#include <gtest/gtest.h>

#include <atomic>
#include <latch>
#include <stdexcept>
#include <string>

#include "core/types/cancelled.h"
#include "core/types/interruption.h"

namespace fovea::testing {
namespace {

std::vector<Task> Numbers(std::vector<int>& to) {
  std::vector<Task> tasks;
  for (std::size_t i = 0; i < to.size(); ++i) {
    tasks.emplace_back([&to, i] { to[i] = static_cast<int>(i) + 1; });
  }
  return tasks;
}

TEST(Helpers, AreNotNeeded) {
  std::vector<int> numbers(3);
  RunTogether(Numbers(numbers));
  EXPECT_EQ(numbers, (std::vector<int>{1, 2, 3}));
}

TEST(Helpers, TakeEachNumberOnce) {
  std::vector<int> alone(5), helped(5);
  ForEachTogether(alone.size(), [&](std::size_t i) { alone[i] += static_cast<int>(i); });
  Helpers helpers(3);
  const Helpers::Scope scope(helpers, 3);
  ForEachTogether(helped.size(), [&](std::size_t i) { helped[i] += static_cast<int>(i); });
  EXPECT_EQ(alone, (std::vector<int>{0, 1, 2, 3, 4}));
  EXPECT_EQ(helped, alone);
}

TEST(Helpers, RunTasksBesideEachOther) {
  Helpers helpers(3);
  const Helpers::Scope scope(helpers, 3);
  std::latch all_run(3);  // nobody passes before all three run at once
  const Task task = [&] { all_run.arrive_and_wait(); };
  RunTogether({task, task, task});
  EXPECT_TRUE(all_run.try_wait());
}

TEST(Helpers, AreNoMoreThanAskedFor) {
  Helpers helpers(4);
  const Helpers::Scope scope(helpers, 2);
  std::atomic<int> num_running = 0, most = 0;
  const Task task = [&] {
    const int now = ++num_running;
    for (int seen = most; now > seen && !most.compare_exchange_weak(seen, now);) {
    }
    --num_running;
  };
  for (int i = 0; i < 1000; ++i) RunTogether({task, task, task, task});
  EXPECT_LE(most, 2);
}

TEST(Helpers, LeaveBusyCoresAlone) {
  Helpers helpers(2);
  const Helpers::Scope scope(helpers, 2);
  std::latch other_is_busy(1), done(1);
  const std::jthread other([&] {
    const Helpers::Scope own(helpers, 2);
    other_is_busy.count_down();
    done.wait();
  });
  other_is_busy.wait();
  const std::thread::id self = std::this_thread::get_id();
  const Task task = [&] { EXPECT_EQ(std::this_thread::get_id(), self); };
  for (int i = 0; i < 1000; ++i) RunTogether({task, task});
  done.count_down();
}

TEST(Helpers, HelpTasksThatHaveTasks) {
  Helpers helpers(4);
  const Helpers::Scope scope(helpers, 4);
  for (int i = 0; i < 200; ++i) {
    std::vector<int> left(5), right(7);
    RunTogether({[&] { RunTogether(Numbers(left)); }, [&] { RunTogether(Numbers(right)); }});
    EXPECT_EQ(left.back(), 5);
    EXPECT_EQ(right.back(), 7);
  }
}

TEST(Helpers, ThrowWhatTheFirstOfTheTasksThrew) {
  Helpers helpers(3);
  const Helpers::Scope scope(helpers, 3);
  const auto fail = [](const char* text) { return [text] { throw std::runtime_error(text); }; };
  for (int i = 0; i < 200; ++i) {
    std::vector<int> numbers(1);
    try {
      RunTogether({fail("first"), fail("second"), Numbers(numbers).front()});
      FAIL() << "goes on";
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(error.what(), std::string("first"));
    }
    EXPECT_EQ(numbers.front(), 1);
  }
}

TEST(Helpers, AreStoppedWithWhomTheyHelp) {
  Helpers helpers(2);
  const Helpers::Scope scope(helpers, 2);
  std::latch both_run(2);
  std::atomic<bool> stop = false;
  const InterruptionScope interruption([&] { return stop.load(); }, std::chrono::microseconds(0));
  const Task until_stopped = [&] {
    both_run.arrive_and_wait();
    stop = true;
    for (;;) InterruptionPoint();
  };
  EXPECT_THROW(RunTogether({until_stopped, until_stopped}), Cancelled);
}

// A helper knows of no stage.
TEST(Helpers, AreStoppedByWhoKnowsTheStage) {
  Helpers helpers(2);
  const Helpers::Scope scope(helpers, 2);
  std::latch both_run(2);
  const auto stopped_in = [&](const char* stage) {
    return Task([&both_run, stage] {
      both_run.arrive_and_wait();
      throw Cancelled(stage);
    });
  };
  try {
    RunTogether({stopped_in(""), stopped_in("stage")});
    FAIL() << "goes on";
  } catch (const Cancelled& cancelled) {
    EXPECT_EQ(cancelled.stage, "stage");
  }
}

TEST(Helpers, AreStoppedWhileTheyAreWaitedFor) {
  Helpers helpers(2);
  const Helpers::Scope scope(helpers, 2);
  std::latch both_run(2);
  std::atomic<bool> stop = false;
  const InterruptionScope interruption([&] { return stop.load(); });
  EnterStage("stage");
  const std::thread::id self = std::this_thread::get_id();
  const Task task = [&] {
    both_run.arrive_and_wait();
    if (std::this_thread::get_id() == self) return;
    stop = true;
    for (;;) InterruptionPoint();
  };
  try {
    RunTogether({task, task});
    FAIL() << "goes on";
  } catch (const Cancelled& cancelled) {
    EXPECT_EQ(cancelled.stage, "stage");
  }
}

}  // namespace
}  // namespace fovea::testing
