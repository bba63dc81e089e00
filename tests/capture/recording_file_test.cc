#include "client/capture/recording_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace fovea::capture {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(RequireRoom, ThrowsWhereLessIsFree) {
  RequireRoom("a.oni", 1);
  EXPECT_THAT([] { RequireRoom("a.oni", std::uintmax_t{1} << 62U); },
              ThrowsMessage<std::runtime_error>(
                  HasSubstr("cannot record any more to a.oni: no space left")));
}

}  // namespace
}  // namespace fovea::capture
