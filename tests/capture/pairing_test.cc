#include "client/capture/pairing.h"

#include <gtest/gtest.h>

namespace fovea::capture {
namespace {

constexpr std::uint64_t kTolerance_us = 16'000;

TEST(Pairing, MatchesInEitherOrderWithinTheTolerance) {
  Pairing<int> pairing(kTolerance_us);
  EXPECT_FALSE(pairing.AddDepth(100'000, 1));
  const auto first = pairing.AddColor(116'000, 2);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->depth, 1);
  EXPECT_EQ(first->color, 2);
  EXPECT_EQ(first->depth_time_us, 100'000U);
  EXPECT_FALSE(pairing.AddColor(200'000, 3));
  const auto second = pairing.AddDepth(184'000, 4);
  ASSERT_TRUE(second);
  EXPECT_EQ(second->color, 3);
  EXPECT_EQ(second->depth_time_us, 184'000U);
  EXPECT_EQ(pairing.NumUnpaired(), 0U);
}

TEST(Pairing, LeavesApartWhatIsOfDifferentMoments) {
  Pairing<int> pairing(kTolerance_us);
  EXPECT_FALSE(pairing.AddDepth(100'000, 1));
  EXPECT_FALSE(pairing.AddColor(116'001, 2));
}

TEST(Pairing, GivesUpWhatIsOlderThanAPair) {
  Pairing<int> pairing(kTolerance_us);
  EXPECT_FALSE(pairing.AddDepth(0, 1));
  EXPECT_FALSE(pairing.AddDepth(33'000, 2));
  const auto pair = pairing.AddColor(33'000, 3);
  ASSERT_TRUE(pair);
  EXPECT_EQ(pair->depth, 2);
  EXPECT_EQ(pairing.NumUnpaired(), 1U);
  EXPECT_FALSE(pairing.AddColor(0, 4)) << "its partner was given up";
}

TEST(Pairing, WaitsForALateImage) {
  Pairing<int> pairing(kTolerance_us);
  EXPECT_FALSE(pairing.AddDepth(0, 1));
  EXPECT_FALSE(pairing.AddDepth(33'000, 2));
  EXPECT_EQ(pairing.AddColor(0, 3)->depth, 1);
  EXPECT_EQ(pairing.AddColor(33'000, 4)->depth, 2);
  EXPECT_EQ(pairing.NumUnpaired(), 0U);
}

TEST(Pairing, DoesNotWaitForever) {
  Pairing<int> pairing(kTolerance_us);
  for (int i = 0; i < 10; ++i) pairing.AddDepth(static_cast<std::uint64_t>(i) * 33'000, i);
  EXPECT_EQ(pairing.NumUnpaired(), 6U);
  EXPECT_FALSE(pairing.AddColor(5 * 33'000, 5)) << "given up";
  EXPECT_EQ(pairing.AddColor(6 * 33'000, 6)->depth, 6);
}

}  // namespace
}  // namespace fovea::capture
