#include "client/capture/recording_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <stdexcept>
#include <string>

#include "tests/support/temporary_folder.h"

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

// As FAT has one at 4 GiB: OpenNI2 goes on, and the rest is missing.
TEST(RequireRoom, ThrowsWhereFilesMayNotBeLarger) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.Write("a.oni", std::string(1000, 'x'));
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit limit = before;
  limit.rlim_cur = 1500;
  setrlimit(RLIMIT_FSIZE, &limit);
  EXPECT_NO_THROW(RequireRoom(path, 500));
  EXPECT_THAT([&] { RequireRoom(path, 501); },
              ThrowsMessage<std::runtime_error>(HasSubstr("has no larger files")));
  setrlimit(RLIMIT_FSIZE, &before);
}

}  // namespace
}  // namespace fovea::capture
