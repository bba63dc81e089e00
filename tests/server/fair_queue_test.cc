#include "server/scheduling/fair_queue.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace fovea::server {
namespace {

using ::testing::ElementsAre;

std::vector<int> PopAll(FairQueue<int>& queue) {
  std::vector<int> items;
  while (!queue.empty()) items.push_back(queue.Pop());
  return items;
}

TEST(FairQueue, TakesTurnsHoweverMuchOneHas) {
  FairQueue<int> queue;
  for (const int item : {1, 2, 3, 4}) queue.Push("greedy", item);
  queue.Push("second", 11);
  queue.Push("third", 21);
  queue.Push("third", 22);
  EXPECT_THAT(PopAll(queue), ElementsAre(1, 11, 21, 2, 22, 3, 4));
}

TEST(FairQueue, WhoComesBackWaitsForOneTurnOfEach) {
  FairQueue<int> queue;
  for (const int item : {1, 2, 3}) queue.Push("greedy", item);
  queue.Push("other", 11);
  EXPECT_EQ(queue.Pop(), 1);
  EXPECT_EQ(queue.Pop(), 11);
  queue.Push("other", 12);
  EXPECT_THAT(PopAll(queue), ElementsAre(2, 12, 3));
}

TEST(FairQueue, RemovesWhatIsWanted) {
  FairQueue<int> queue;
  for (const int item : {1, 2, 3}) queue.Push("a", item);
  queue.Push("b", 11);
  const auto is = [](int wanted) { return [wanted](int item) { return item == wanted; }; };
  EXPECT_TRUE(queue.Remove("a", is(2)));
  EXPECT_FALSE(queue.Remove("a", is(2)));
  EXPECT_FALSE(queue.Remove("b", is(1)));
  EXPECT_FALSE(queue.Remove("nobody", is(1)));
  EXPECT_TRUE(queue.Remove("b", is(11)));  // its last: no turn is left behind
  EXPECT_THAT(PopAll(queue), ElementsAre(1, 3));
}

}  // namespace
}  // namespace fovea::server
