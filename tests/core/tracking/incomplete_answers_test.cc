// Answers for which the time was up before all of the frame was looked at.
#include <gmock/gmock.h>

#include "core/tracking/tracker.h"
#include "tests/core/tracking/table_view.h"
#include "tests/core/tracking/track_ids.h"

namespace fovea {
namespace {

using testing::At;
using ::testing::ElementsAre;
using testing::HiddenIds;
using testing::Ids;
using testing::kBlue;
using testing::View;

TEST(IncompleteAnswers, WhatWasNotLookedAtIsNotForgotten) {
  Tracker tracker(1);
  const Eigen::Vector3f left(-0.1F, 0, 0.8F), right(0.1F, 0, 0.8F);
  View(0, 1).Add(left).Add(right, kBlue).TrackBy(tracker, At(0));
  for (int i = 1; i < 4; ++i) {
    const Detections half = View(0, i + 1).Add(left).Incomplete().TrackBy(tracker, At(0.1 * i));
    EXPECT_THAT(Ids(half), ElementsAre(1));
    EXPECT_THAT(HiddenIds(half), ElementsAre()) << "what was seen once may be a mistake";
  }
  const Detections whole = View(0, 5).Add(left).Add(right, kBlue).TrackBy(tracker, At(2));
  EXPECT_THAT(Ids(whole), ElementsAre(1, 2));
  EXPECT_EQ(whole.objects[1].track->times_seen, 2U);
}

TEST(IncompleteAnswers, WhatIsNeverLookedAtIsKeptForTwoSecondsToo) {
  Tracker tracker(1);
  View(0, 1).Add({0, 0, 0.8F}).TrackBy(tracker, At(0));
  for (int i = 1; i <= 5; ++i) View(0, i + 1).Incomplete().TrackBy(tracker, At(0.5 * i));
  EXPECT_THAT(Ids(View(0, 7).Add({0, 0, 0.8F}).TrackBy(tracker, At(3))), ElementsAre(2));
}

// Somebody pushed it meanwhile.
TEST(IncompleteAnswers, WhatWasNotLookedAtIsNotGone) {
  for (const bool incomplete : {true, false}) {
    Tracker tracker(1);
    for (int i = 0; i < 2; ++i) View(0, i + 1).Add({0, 0, 0.8F}).TrackBy(tracker, At(0.1 * i));
    View empty(0, 3);
    if (incomplete) empty.Incomplete();
    const Detections after = empty.TrackBy(tracker, At(0.2));
    ASSERT_THAT(HiddenIds(after), ElementsAre(1));
    EXPECT_EQ(after.tracking->hidden[0].reason,
              incomplete ? HiddenReason::kNotDetected : HiddenReason::kGone);
    EXPECT_THAT(Ids(View(0, 4).Add({0.05F, 0, 0.8F}).TrackBy(tracker, At(0.3))), ElementsAre(1));
  }
}

}  // namespace
}  // namespace fovea
