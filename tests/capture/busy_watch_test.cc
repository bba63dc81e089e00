#include "client/capture/busy_watch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fovea::capture {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

// An answer that took half a second, and waited this long of it.
v1::Detections Answer(double waited_s) {
  v1::Detections detections;
  const auto add = [&](const char* stage, double seconds) {
    v1::StageTime& time = *detections.add_stage_times();
    time.set_stage(stage);
    time.mutable_duration()->set_nanos(static_cast<int>(seconds * 1e9));
  };
  add("queue", 0.9);
  add("normals", 0.5);
  add("processor_wait", waited_s);
  return detections;
}

TEST(BusyWatch, SaysOnceThatTheMachineBecameBusy) {
  BusyWatch watch;
  for (int i = 0; i < 8; ++i) EXPECT_THAT(watch.Take(Answer(0.01)), IsEmpty());
  for (int i = 0; i < 3; ++i) EXPECT_THAT(watch.Take(Answer(0.3)), IsEmpty()) << "too few yet";
  EXPECT_THAT(watch.Take(Answer(0.3)),
              HasSubstr("of 2.0 s that frames took, the server waited 1.2 s for a processor"));
  for (int i = 0; i < 8; ++i) EXPECT_THAT(watch.Take(Answer(0.3)), IsEmpty()) << "said already";
}

TEST(BusyWatch, SaysItAgainWhenItWasOverMeanwhile) {
  BusyWatch watch;
  const auto notes_of = [&](double waited_s) {
    int notes = 0;
    for (int i = 0; i < 4; ++i) notes += watch.Take(Answer(waited_s)).empty() ? 0 : 1;
    return notes;
  };
  EXPECT_EQ(notes_of(0.3), 1);
  EXPECT_EQ(notes_of(0.0), 0);
  EXPECT_EQ(notes_of(0.3), 1);
}

}  // namespace
}  // namespace fovea::capture
