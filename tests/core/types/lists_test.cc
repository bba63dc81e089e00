#include "core/types/lists.h"

#include <gmock/gmock.h>

namespace fovea {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Lists, AreFilledOneAtATimeInAnyOrder) {
  Lists<int> lists(3);
  lists.Begin(2);
  lists.Add(5);
  lists.Begin(0);
  lists.Add(7);
  lists.Add(8);
  ASSERT_EQ(lists.size(), 3U);
  EXPECT_THAT(lists[0], ElementsAre(7, 8));
  EXPECT_THAT(lists[1], IsEmpty());
  EXPECT_THAT(lists[2], ElementsAre(5));
  lists.Begin(2);
  lists.Add(9);
  EXPECT_THAT(lists[2], ElementsAre(9));
  EXPECT_THAT(lists[0], ElementsAre(7, 8));
}

TEST(Lists, OfKnownSizesAreFilledTogether) {
  auto lists = Lists<int>::OfSizes({2, 0, 1});
  lists.Put(2, 6);
  lists.Put(0, 4);
  EXPECT_THAT(lists[0], ElementsAre(4));
  lists.Put(0, 5);
  EXPECT_THAT(lists[0], ElementsAre(4, 5));
  EXPECT_THAT(lists[1], IsEmpty());
  EXPECT_THAT(lists[2], ElementsAre(6));
}

}  // namespace
}  // namespace fovea
