// What --gripper asks for.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "client/cli/request.h"

namespace fovea::cli {
namespace {

using ::testing::StartsWith;

TEST(GripperFlags, HaveALengthAndPerhapsALeastProbability) {
  v1::DetectOptions options;
  ParseGrippers({"jaw=0.14,0.2", "suction=0.03"}, &options);
  ASSERT_EQ(options.grasps().grippers_size(), 2);
  const v1::Gripper& jaw = options.grasps().grippers(0);
  const v1::Gripper& cup = options.grasps().grippers(1);
  EXPECT_EQ(jaw.jaw().max_opening_m(), 0.14);
  EXPECT_EQ(jaw.min_probability(), 0.2);
  EXPECT_EQ(cup.suction().diameter_m(), 0.03);
  EXPECT_FALSE(cup.has_min_probability());
}

TEST(GripperFlags, AreNamedWhereTheyAreWrong) {
  for (const char* text :
       {"jaw=", "jaw=0.1,", "jaw=0.1,0.2,0.3", "jaw=0", "suction=-1", "hook=0.1", "0.1"}) {
    v1::DetectOptions options;
    try {
      ParseGrippers({text}, &options);
      ADD_FAILURE() << text << " is taken";
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), StartsWith("--gripper: "));
    }
  }
}

}  // namespace
}  // namespace fovea::cli
