#include "core/search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <set>
#include <vector>

#include "core/depth/measured_depth.h"
#include "core/pixel_blocks.h"
#include "core/types/interruption.h"
#include "tests/support/labelled_frame.h"
#include "tests/support/random_scene.h"
#include "tests/support/sensor.h"

namespace fovea {
namespace {

using std::chrono::milliseconds;

RgbdFrame FrameOfBlocks() {
  const RgbdFrame frame = scenes::MakeFrame(scenes::RandomScene("tabletop", 1, {320, 240}),
                                            scenes::SensorKind::kKinect, 1)
                              .frame;
  return InBlocks(frame, MeasuredDepth(frame.depth_m), BlocksOf(frame, VoxelOptions()));
}

struct Searched {
  FoundObjects found;
  bool incomplete = false;
  int asked = 0;  // whether to stop: where a stage ends
};

// With a budget of 100 ms of a clock that stands, when so many are used, and that is at the end
// once it has been asked so often whether to stop (0: never).
Searched SearchWith(milliseconds used, int times_asked) {
  TimeBudget::Clock::time_point now;
  Searched searched;
  const auto should_stop = [&] {
    if (++searched.asked == times_asked) now += milliseconds(100);
    return false;
  };
  TimeBudget budget(milliseconds(100), should_stop, [&] { return now; });
  now += used;
  const InterruptionScope scope([&] { return budget.WantsStop(); }, std::chrono::hours(1));
  static const RgbdFrame frame = FrameOfBlocks();
  StageClock clock("depth");
  Detections result;
  searched.found =
      SearchInBlocks(frame, frame.intrinsics, DetectorOptions(), budget, clock, result).found;
  searched.incomplete = result.incomplete;
  return searched;
}

constexpr milliseconds kLittle(1), kHalf(50);
constexpr int kAskedInAPortion = 3;  // energy, graph cut and refinement

// 1, 2, … of as many objects as there are.
void ExpectANumberForEachObject(const FoundObjects& found) {
  std::set<int> labels(found.objects.begin(), found.objects.end());
  labels.erase(0);
  std::vector<int> numbers(found.confidences.size());
  std::iota(numbers.begin(), numbers.end(), 1);
  EXPECT_THAT(labels, testing::ElementsAreArray(numbers));
}

TEST(Search, LooksAtAllAtOnceWhereThereIsTime) {
  const Searched whole = SearchWith(kLittle, 0);
  EXPECT_FALSE(whole.incomplete);
  EXPECT_GT(SearchWith(kHalf, 0).asked, whole.asked);
}

TEST(Search, OfPortionsGivesEachObjectItsNumber) {
  const Searched all = SearchWith(kHalf, 0);
  EXPECT_FALSE(all.incomplete);
  EXPECT_GE(all.found.confidences.size(), 3U);
  ExpectANumberForEachObject(all.found);
}

// Traces tell of each voxel, also where the time ends before anything has been looked at.
TEST(Search, LabelsAllVoxelsAsBackgroundWhereTheTimeEndsBeforeTheFirstPortion) {
  const Searched all = SearchWith(kLittle, 0);
  const Searched none = SearchWith(kLittle, all.asked - kAskedInAPortion + 1);
  EXPECT_TRUE(none.incomplete);
  const std::vector<int> background(all.found.labels.size(), 0);
  EXPECT_EQ(none.found.labels, background);
  EXPECT_EQ(none.found.segments, background);
  EXPECT_EQ(none.found.objects, background);
}

TEST(Search, HasWhatItFoundInTimeInTheFirstPortions) {
  const Searched all = SearchWith(kHalf, 0);
  const std::vector<float>& of_all = all.found.confidences;
  std::size_t most = of_all.size();
  for (int portions_missed = 1; portions_missed <= 3; ++portions_missed) {
    SCOPED_TRACE(portions_missed);
    const int end = all.asked - kAskedInAPortion * portions_missed + 1;
    const Searched some = SearchWith(kHalf, end);
    EXPECT_TRUE(some.incomplete);
    EXPECT_EQ(some.asked, end) << "it looked at more than it had time for";
    const std::vector<float>& confidences = some.found.confidences;
    ASSERT_LE(confidences.size(), most);
    most = confidences.size();
    EXPECT_TRUE(std::equal(confidences.begin(), confidences.end(), of_all.begin()));
    ExpectANumberForEachObject(some.found);
  }
  EXPECT_GT(most, 0U);
  EXPECT_LT(most, of_all.size());
}

}  // namespace
}  // namespace fovea
