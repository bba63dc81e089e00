#include "client/capture/tally.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

namespace fovea::capture {
namespace {

using ::testing::HasSubstr;

Picture Numbered(std::uint64_t number) {
  Picture picture;
  picture.number = number;
  return picture;
}

TEST(Tally, FindsThePictureOfAnAnswer) {
  Tally tally;
  for (const std::uint64_t number : {10, 11, 12, 13}) tally.Sent(Numbered(number));
  EXPECT_EQ(tally.Answered(0)->number, 10U);
  EXPECT_EQ(tally.Answered(2)->number, 12U);
  EXPECT_FALSE(tally.Answered(1)) << "dropped";
  EXPECT_EQ(tally.Answered(3)->number, 13U);
  EXPECT_FALSE(tally.Answered(4)) << "not sent";
}

TEST(Tally, KeepsNothingOfWhatWasNotSent) {
  Tally tally;
  tally.Sent(Numbered(10));
  tally.Sent(Numbered(11));
  tally.NotSent();
  tally.Sent(Numbered(12));
  EXPECT_FALSE(tally.Answered(1));
  EXPECT_EQ(tally.Answered(2)->number, 12U);
  EXPECT_EQ(tally.Snapshot().sent, 3U) << "into a connection that broke";
}

// A server that takes frames and answers none would fill the memory.
TEST(Tally, KeepsSoManyBytesOfImages) {
  constexpr std::size_t kBytes = std::size_t{4} * 3 * (3 + 2);
  Tally tally(/*max_image_bytes=*/2 * kBytes);
  for (std::uint64_t number = 0; number < 5; ++number) {
    Picture picture = Numbered(number);
    picture.color = cv::Mat(3, 4, CV_8UC3);
    picture.depth = cv::Mat(3, 4, CV_16UC1);
    tally.Sent(std::move(picture));
  }
  for (const std::uint64_t number : {0, 1, 2, 3, 4}) {
    const auto picture = tally.Answered(number);
    ASSERT_TRUE(picture) << number;
    EXPECT_EQ(picture->number, number);
    EXPECT_EQ(picture->color.empty(), number < 3) << number;
    EXPECT_EQ(picture->depth.empty(), number < 3) << number;
  }
}

TEST(Tally, CallsLostWhatHasNoOtherFate) {
  Tally tally;
  for (std::uint64_t i = 0; i < 10; ++i) tally.Sent(Numbered(i));
  for (int i = 0; i < 4; ++i) tally.Count(/*failed=*/i == 0, 2, 5);
  tally.Gone(3, 1);
  tally.Finish();
  const Tally::Counts counts = tally.Snapshot();
  EXPECT_EQ(counts.answered, 3U);
  EXPECT_EQ(counts.failed, 1U);
  EXPECT_EQ(counts.lost, 3U);
  EXPECT_EQ(counts.objects, 6U);
  EXPECT_EQ(tally.Latencies_ms().size(), 3U) << "of answers";
}

TEST(Tally, SummarisesForPeople) {
  Tally tally;
  tally.Replaced();
  for (std::uint64_t i = 0; i < 100; ++i) {
    tally.Sent(Numbered(i));
    tally.Count(false, 1, static_cast<double>(100 - i));
  }
  const std::string text = Summary(tally, 101, {.missed = 7, .unpaired = 2, .wrong_size = 0}, 1);
  EXPECT_THAT(text,
              HasSubstr("101 frames captured, 100 sent, 100 answered, 0 failed; 100 objects"));
  EXPECT_THAT(text, HasSubstr("7 by the camera, 1 by this client, 0 by the server; 0 lost"));
  EXPECT_THAT(text, HasSubstr("2 images without a partner, 0 of a wrong size, reopened 1 times"));
  EXPECT_THAT(text, HasSubstr("median 50 ms, 90 % 90 ms, 99 % 99 ms, longest 100 ms"));
}

TEST(Percentile, IsTheNearestRank) {
  EXPECT_EQ(Percentile({}, 0.5), 0);
  EXPECT_EQ(Percentile({3}, 0.99), 3);
  EXPECT_EQ(Percentile({1, 2, 3, 4}, 0.5), 2);
  EXPECT_EQ(Percentile({1, 2, 3, 4}, 0.51), 3);
}

}  // namespace
}  // namespace fovea::capture
