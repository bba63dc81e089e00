// Times that cannot be, and more things than are kept.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/tracking/tracker.h"
#include "tests/core/tracking/table_view.h"
#include "tests/core/tracking/track_ids.h"

namespace fovea {
namespace {

using ::testing::ElementsAre;
using testing::HiddenIds;
using testing::Ids;
using testing::kRed;
using testing::View;

TEST(TrackerLimits, BearsHostileTimes) {
  constexpr std::int64_t kYear1 = -62135596800, kYear9999 = 253402300799;
  Tracker tracker(1);
  std::uint64_t seed = 0;
  for (const CaptureTime time : {CaptureTime{kYear9999, 999'999'999}, CaptureTime{kYear1, 0},
                                 CaptureTime{kYear1, 0}, CaptureTime{kYear9999, 0}}) {
    FrameContext context;
    context.captured_at = time;
    EXPECT_THAT(Ids(View(0, ++seed).Add({0, 0, 0.8F}).TrackBy(tracker, context)), ElementsAre(1));
  }
  // As the time stands still, frames count: two seconds of them.
  FrameContext context;
  context.captured_at = CaptureTime{kYear1, 0};
  for (int i = 0; i < 20; ++i) {
    EXPECT_THAT(HiddenIds(View(0, ++seed).TrackBy(tracker, context)), ElementsAre(1)) << i;
  }
  EXPECT_THAT(HiddenIds(View(0, ++seed).TrackBy(tracker, context)), ElementsAre());
}

TEST(TrackerLimits, IsBounded) {
  Tracker tracker(1);
  for (int i = 0; i < 4; ++i) {
    View view(0, i + 1);
    const int layer = i / 2;
    for (int k = 0; k < 200; ++k) {
      const int row = k / 20, col = k % 20;
      view.Add({0.03F * static_cast<float>(col) - 0.3F, 0.05F * static_cast<float>(row) - 0.25F,
                0.8F + 0.02F * static_cast<float>(layer)},
               kRed, 0.02F);
    }
    const Detections result = view.TrackBy(tracker);
    for (int k = 0; k < 200; ++k) {
      EXPECT_EQ(result.objects[k].track.has_value(), k < static_cast<int>(Tracker::kMaxTracks));
    }
    EXPECT_LE(result.tracking->hidden.size(), Tracker::kMaxTracks);
  }
}

// 60 things, then 60 others, then 60 more, each for two frames.
TEST(TrackerLimits, KeepsThoseThatWereSeenLast) {
  Tracker tracker(1);
  std::vector<std::uint64_t> hidden;
  for (int i = 0; i < 6; ++i) {
    View view(0, i + 1);
    for (int k = 0; k < 60; ++k) {
      const int group = i / 2, row = k / 20, col = k % 20;
      const float y = 0.2F * static_cast<float>(group) + 0.05F * static_cast<float>(row);
      view.Add({0.03F * static_cast<float>(col) - 0.3F, y - 0.25F, 0.8F}, kRed, 0.02F);
    }
    hidden = HiddenIds(view.TrackBy(tracker));
  }
  ASSERT_EQ(hidden.size(), Tracker::kMaxTracks - 60);
  EXPECT_TRUE(std::is_sorted(hidden.begin(), hidden.end()));
  EXPECT_EQ(std::count_if(hidden.begin(), hidden.end(), [](auto id) { return id > 60; }), 60);
}

}  // namespace
}  // namespace fovea
