#include "tests/e2e/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace fovea::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(Process, ReadsOnUntilTheErrorComes) {
  const Process process({"/bin/sh", "-c", "printf '%70000s' >&2; echo here >&2; read never"});
  EXPECT_NO_THROW(process.AwaitError("here"));
}

TEST(Process, AwaitsNoErrorOfWhatHasEnded) {
  Process process({"/bin/sh", "-c", "echo another >&2"});
  EXPECT_THAT([&] { process.AwaitError("one"); },
              ThrowsMessage<std::runtime_error>(HasSubstr("but: another")));
  EXPECT_EQ(process.Wait().exit_code, 0);
}

}  // namespace
}  // namespace fovea::testing
