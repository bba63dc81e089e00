#include "client/capture/camera_error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/capture/camera_options.h"
#include "client/capture/devices.h"

namespace fovea::capture {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(CannotOpen, NamesTheUdevRuleOnlyWherePermissionIsMissing) {
  EXPECT_THAT(CannotOpen("a@b", "USB: Access denied").what(), HasSubstr("60-libopenni2-0.rules"));
  EXPECT_THAT(CannotOpen("a@b", "firmware timeout").what(), Not(HasSubstr("rules")));
  EXPECT_THAT(CannotOpen("a@b", "firmware timeout").what(), HasSubstr("firmware timeout"));
}

TEST(NameWithoutPlace, LeavesThePlaceOut) {
  EXPECT_EQ(NameWithoutPlace("1d27/0609@1/3"), "1d27/0609@");
  EXPECT_EQ(NameWithoutPlace("camera"), "camera");
}

TEST(ParseResolution, TakesWidthAndHeight) {
  EXPECT_EQ(ParseResolution("640x480", "--resolution"), cv::Size(640, 480));
  for (const char* text :
       {"", "640", "640x", "640x480x3", "-1x2", "123456x2", "0x0", "640x0", "0x480"}) {
    EXPECT_THROW(ParseResolution(text, "--resolution"), std::invalid_argument) << text;
  }
}

}  // namespace
}  // namespace fovea::capture
