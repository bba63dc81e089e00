#include "client/cli/request.h"

#include <google/protobuf/util/time_util.h>
#include <gtest/gtest.h>

#include "client/cli/question_flags.h"

namespace fovea::cli {
namespace {

using google::protobuf::util::TimeUtil;

// What a robot asked that waits two seconds at most, with one hand, and looks for room.
v1::DetectOptions AskedThen() {
  v1::DetectOptions options;
  options.set_profile("paper");
  (*options.mutable_parameters())["max_depth_m"] = 4;
  (*options.mutable_parameters())["mrf.gamma_per_m2"] = 80;
  *options.mutable_time_budget() = TimeUtil::MillisecondsToDuration(2000);
  options.mutable_grasps()->add_grippers()->mutable_jaw()->set_max_opening_m(0.14);
  options.mutable_places()->mutable_size()->set_y(0.3);
  options.mutable_places()->set_max_places(7);
  options.mutable_tracking()->set_enabled(true);
  return options;
}

// Of a frame that was sent with that, and is sent again with these flags.
v1::DetectOptions AskedAgain(const QuestionFlags& flags) {
  SentBefore sent;
  *sent.request.mutable_options() = AskedThen();
  FrameFiles files;
  files.sent_before = std::make_shared<const SentBefore>(sent);
  FrameSettings settings;
  settings.options = DetectOptionsOf(flags);
  return MakeRequest(files, settings).options();
}

TEST(SentBefore, IsAskedTheSameAloneUnlessFlagsSaySo) {
  v1::DetectOptions then = AskedThen();
  then.clear_tracking();  // there is no stream
  EXPECT_EQ(AskedAgain({}).ShortDebugString(), then.ShortDebugString());
}

TEST(SentBefore, HasTheTimeThatIsGiven) {
  QuestionFlags flags;
  flags.time_budget_s = 0.05;
  EXPECT_EQ(TimeUtil::DurationToMilliseconds(AskedAgain(flags).time_budget()), 50);
  flags.time_budget_s = 0;
  EXPECT_EQ(TimeUtil::DurationToMilliseconds(AskedAgain(flags).time_budget()), 0);
}

TEST(SentBefore, HasTheHandsThatAreGiven) {
  QuestionFlags flags;
  flags.grippers = {"suction=0.03"};
  const v1::GraspOptions grasps = AskedAgain(flags).grasps();
  ASSERT_EQ(grasps.grippers_size(), 1);
  EXPECT_TRUE(grasps.grippers(0).has_suction());
  flags.grippers = {"none"};
  EXPECT_TRUE(AskedAgain(flags).grasps().none());
  EXPECT_TRUE(AskedAgain(flags).grasps().grippers().empty());
}

TEST(SentBefore, HasThePlacesThatAreGiven) {
  QuestionFlags flags;
  flags.place = "0.1,0,0.2";
  const v1::PlaceOptions places = AskedAgain(flags).places();
  EXPECT_EQ(places.size().x(), 0.1);
  EXPECT_EQ(places.size().y(), 0);
  EXPECT_EQ(places.max_places(), 0U);  // the flag says "5 unless given"
}

TEST(SentBefore, KeepsItsOtherParameters) {
  QuestionFlags flags;
  flags.settings = {"max_depth_m=2"};
  const v1::DetectOptions options = AskedAgain(flags);
  EXPECT_EQ(options.parameters().at("max_depth_m"), 2);
  EXPECT_EQ(options.parameters().at("mrf.gamma_per_m2"), 80);
  EXPECT_EQ(options.profile(), "paper");
}

}  // namespace
}  // namespace fovea::cli
