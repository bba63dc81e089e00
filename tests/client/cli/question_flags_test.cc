#include "client/cli/question_flags.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace fovea::cli {
namespace {

using ::testing::StartsWith;

v1::DetectOptions OptionsWith(const std::vector<std::string>& grippers) {
  QuestionFlags flags;
  flags.grippers = grippers;
  return DetectOptionsOf(flags);
}

TEST(GripperFlags, HaveALengthAndPerhapsALeastProbability) {
  const v1::DetectOptions options = OptionsWith({"jaw=0.14,0.2", "suction=0.03"});
  ASSERT_EQ(options.grasps().grippers_size(), 2);
  const v1::Gripper& jaw = options.grasps().grippers(0);
  const v1::Gripper& cup = options.grasps().grippers(1);
  EXPECT_EQ(jaw.jaw().max_opening_m(), 0.14);
  EXPECT_EQ(jaw.min_probability(), 0.2);
  EXPECT_EQ(cup.suction().diameter_m(), 0.03);
  EXPECT_FALSE(cup.has_min_probability());
}

TEST(GripperFlags, SayInJsonWhateverTheContractKnowsOfAGripper) {
  const v1::DetectOptions options = OptionsWith(
      {R"({"name": "long", "jaw": {"finger_length_m": 0.09}, "max_grasps": 2})", "suction=0.03"});
  ASSERT_EQ(options.grasps().grippers_size(), 2);
  EXPECT_EQ(options.grasps().grippers(0).name(), "long");
  EXPECT_EQ(options.grasps().grippers(0).jaw().finger_length_m(), 0.09);
  EXPECT_EQ(options.grasps().grippers(0).max_grasps(), 2U);
}

TEST(GripperFlags, AreNamedInOneLineWhereTheyAreWrong) {
  for (const char* text : {"jaw=", "jaw=0.1,", "jaw=0.1,0.2,0.3", "jaw=0", "suction=-1", "hook=0.1",
                           "0.1", "{", R"({"jaw": {"opening": 1}})"}) {
    try {
      OptionsWith({text});
      ADD_FAILURE() << text << " is taken";
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), StartsWith("--gripper: "));
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
  }
}

TEST(PlanningFlags, AskForNothingUnlessGiven) {
  const v1::DetectOptions options = DetectOptionsOf({});
  EXPECT_FALSE(options.has_planning());
  EXPECT_FALSE(options.has_places());
  EXPECT_FALSE(options.has_grasps());
}

TEST(PlanningFlags, AskForAMapByItsCellsAlone) {
  QuestionFlags flags;
  flags.height_map_max_cells = 100;
  const v1::DetectOptions options = DetectOptionsOf(flags);
  EXPECT_EQ(options.planning().height_map().max_cells(), 100U);
  EXPECT_EQ(options.planning().height_map().cell_m(), 0);
  EXPECT_FALSE(options.planning().collision_primitives());
}

}  // namespace
}  // namespace fovea::cli
