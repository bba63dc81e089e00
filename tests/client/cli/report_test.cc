#include "client/cli/report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fovea::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

v1::Detections Found(int number, bool has_support) {
  v1::Detections detections;
  for (int i = 0; i < number; ++i) detections.add_objects();
  if (has_support) detections.mutable_support_surface();
  detections.mutable_diagnostics()->add_messages("why");
  return detections;
}

TEST(Report, CountsObjects) {
  EXPECT_EQ(NumObjects(0), "0 objects");
  EXPECT_EQ(NumObjects(1), "1 object");
  EXPECT_THAT(Report(Found(2, true), 5), HasSubstr("2 objects in 5 ms"));
}

TEST(Report, SaysWhyWhereLittleWasFoundOrNoSupport) {
  EXPECT_THAT(Report(Found(2, true), 5), HasSubstr("note: why"));
  EXPECT_THAT(Report(Found(3, true), 5), Not(HasSubstr("note: ")));
  EXPECT_THAT(Report(Found(3, false), 5), HasSubstr("note: why"));
}

TEST(Report, NamesTracks) {
  v1::Detections detections = Found(2, true);
  detections.mutable_objects(0)->set_track_id(17);
  detections.mutable_objects(0)->set_moving(true);
  EXPECT_THAT(Report(detections, 5), HasSubstr("  #17  moving\n"));
  EXPECT_THAT(Report(Found(2, true), 5), Not(HasSubstr("#1")));
}

}  // namespace
}  // namespace fovea::cli
