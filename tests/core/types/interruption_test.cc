#include "core/types/interruption.h"

#include <gtest/gtest.h>

#include "core/types/cancelled.h"

namespace fovea::testing {
namespace {

using std::chrono::microseconds;

TEST(Interruption, HappensWhereTheScopeWantsToStop) {
  int asked = 0;
  InterruptionScope scope([&] { return ++asked == 3; }, microseconds(0));
  scope.Enter("stage");
  InterruptionPoint();
  InterruptionPoint();
  try {
    InterruptionPoint();
    FAIL() << "goes on";
  } catch (const Cancelled& cancelled) {
    EXPECT_EQ(cancelled.stage, "stage");
  }
}

TEST(Interruption, AsksNoMoreThanOnceAPeriod) {
  int asked = 0;
  InterruptionScope scope([&] { return ++asked > 0; }, std::chrono::hours(1));
  for (int i = 0; i < 1000; ++i) InterruptionPoint();
  EXPECT_EQ(asked, 0);
  EXPECT_THROW(scope.AskNow(), Cancelled);
}

TEST(Interruption, IsOfTheInnerScopeAndOfNoneOutside) {
  InterruptionPoint();
  const InterruptionScope outer([] { return true; }, microseconds(0));
  {
    const InterruptionScope inner({}, microseconds(0));
    InterruptionPoint();
  }
  EXPECT_THROW(InterruptionPoint(), Cancelled);
}

TEST(Interruption, OfALongLoopComesAgainAndAgain) {
  int asked = 0;
  const InterruptionScope scope(
      [&] {
        ++asked;
        return false;
      },
      microseconds(0));
  LongLoop loop;
  for (int i = 0; i < 10 * 256; ++i) loop.Turn();
  EXPECT_EQ(asked, 10);
}

}  // namespace
}  // namespace fovea::testing
