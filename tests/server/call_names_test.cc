#include "server/rpc/call_names.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace fovea::server {
namespace {

std::string NameOf(const std::string& given) {
  return RobotName({{"fovea-robot", given}}, "ipv4:10.0.0.7:41234");
}

TEST(RobotName, IsWhatTheCallerSays) {
  EXPECT_EQ(NameOf("kitchen 3"), "kitchen 3");
  EXPECT_EQ(NameOf(std::string(64, 'x')), std::string(64, 'x'));
}

TEST(RobotName, IsElseTheHost) {
  EXPECT_EQ(RobotName({}, "ipv4:10.0.0.7:41234"), "ipv4:10.0.0.7");
  EXPECT_EQ(RobotName({}, "ipv6:[::1]:41234"), "ipv6:[::1]");
}

TEST(RobotName, MustBePrintable) {
  for (const std::string& name : {std::string(), std::string(65, 'x'), std::string("a\nb"),
                                  std::string("a\0b", 3), std::string("caf\xC3\xA9")}) {
    EXPECT_THROW(NameOf(name), std::invalid_argument) << name;
  }
}

TEST(RequestId, IsWhatTheCallerSaysElseUnique) {
  EXPECT_EQ(RequestId({{"fovea-request-id", "a-1"}}), "a-1");
  EXPECT_NE(RequestId({}), RequestId({}));
  EXPECT_THROW(RequestId({{"fovea-request-id", ""}}), std::invalid_argument);
}

}  // namespace
}  // namespace fovea::server
