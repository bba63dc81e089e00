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

// That the colour image is blank, say, of however many objects.
TEST(Report, SaysWhatTheServerDoes) {
  for (const int number : {0, 3}) {
    EXPECT_THAT(Report(Found(number, true), 5), HasSubstr("note: why\n")) << number;
  }
  v1::Detections silent = Found(3, true);
  silent.clear_diagnostics();
  EXPECT_THAT(Report(silent, 5), Not(HasSubstr("note: ")));
}

TEST(Report, SaysNothingOfASupportThatNobodyLookedFor) {
  constexpr const char* kNone = "no support surface was found\n";
  v1::Detections detections = Found(0, false);
  EXPECT_THAT(Report(detections, 5), HasSubstr(kNone));
  detections.set_incomplete(true);
  EXPECT_THAT(Report(detections, 5), Not(HasSubstr(kNone)));
  detections.mutable_diagnostics()->set_num_points(1000);
  EXPECT_THAT(Report(detections, 5), HasSubstr(kNone));
}

TEST(Report, TellsShapeSizeAndBestGraspOrWhyNone) {
  v1::Detections detections = Found(2, true);
  v1::Object& cup = *detections.mutable_objects(0);
  cup.mutable_shape()->set_kind(v1::SHAPE_KIND_REVOLUTION);
  cup.mutable_oriented_box()->mutable_size()->set_x(0.08);
  cup.add_grasps()->set_probability(0.82);
  cup.mutable_grasps(0)->set_kind(v1::GRASP_KIND_RIM);
  cup.mutable_grasps(0)->set_opening_m(0.004);
  v1::Object& box = *detections.mutable_objects(1);
  box.add_no_grasps()->set_reason(v1::NO_GRASP_REASON_TOO_WIDE);
  box.add_blocked_by(1);
  const std::string report = Report(detections, 5);
  EXPECT_THAT(report, HasSubstr("  round       8.0 x   0.0 x   0.0"));
  EXPECT_THAT(report, HasSubstr("  82% rim, 0.4 cm\n"));
  EXPECT_THAT(report, HasSubstr("  none: too wide  first 1\n"));
}

TEST(Report, TellsWhereObjectsAreByTheCamerasPose) {
  v1::Detections detections = Found(1, true);
  EXPECT_THAT(Report(detections, 5), Not(HasSubstr("by --camera-pose")));
  detections.mutable_objects(0)->mutable_pose_in_reference()->mutable_position()->set_x(0.25);
  EXPECT_THAT(Report(detections, 5), HasSubstr("  by --camera-pose, m "));
  EXPECT_THAT(Report(detections, 5), HasSubstr("   0.250  0.000  0.000     -\n"));
}

TEST(Report, TellsWhatThereIsForPlanners) {
  v1::Detections detections = Found(3, true);
  EXPECT_THAT(Report(detections, 5), Not(HasSubstr("height map")));
  detections.add_support_collisions();
  detections.mutable_height_map()->set_width(20);
  detections.mutable_height_map()->set_height(10);
  detections.mutable_height_map()->set_cell_m(0.02F);
  const std::string report = Report(detections, 5);
  EXPECT_THAT(report, HasSubstr("collision primitives of 3 objects and 1 support surface\n"));
  EXPECT_THAT(report, HasSubstr("height map of 20 x 10 cells of 0.02 m\n"));
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
