#include "client/server_address.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "client/client.h"

namespace fovea::client {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::ThrowsMessage;

std::vector<std::string> TargetsOf(const std::string& text) {
  std::vector<std::string> targets;
  for (const ServerTarget& each : FindTargets(ParseServerAddresses(text)).targets) {
    targets.push_back(each.target);
  }
  return targets;
}

TEST(ServerAddress, TakesOneOrSeveral) {
  EXPECT_THAT(TargetsOf("10.0.0.1:50051"), ElementsAre("ipv4:10.0.0.1:50051"));
  EXPECT_THAT(TargetsOf("[::1]:1"), ElementsAre("ipv6:[::1]:1"));
  EXPECT_THAT(TargetsOf("unix:/run/a,unix:///run/b"), ElementsAre("unix:/run/a", "unix:/run/b"));
  EXPECT_THAT(TargetsOf("ipv4:10.0.0.1:5,10.0.0.2:6"),
              ElementsAre("ipv4:10.0.0.1:5", "ipv4:10.0.0.2:6"));
  EXPECT_THAT(TargetsOf("10.0.0.1:5,10.0.0.1:5"), ElementsAre("ipv4:10.0.0.1:5"));
}

TEST(ServerAddress, LooksNamesUp) {
  const FoundTargets found = FindTargets(ParseServerAddresses("dns:///localhost:7"));
  EXPECT_THAT(found.targets, Contains(ServerTarget{"ipv4:127.0.0.1:7", "localhost:7"}));
  const FoundTargets none = FindTargets(ParseServerAddresses("no-such-host.invalid:7"));
  EXPECT_THAT(none.targets, IsEmpty());
  EXPECT_THAT(none.problem, HasSubstr("cannot look up no-such-host.invalid: "));
}

TEST(ServerAddress, RefusesTheRest) {
  for (const char* text : {"", "localhost", "a:1,", ",a:1", "a:0", "a:65536", "::1:5", "[x]:5",
                           "http://a:1", "unix:", "dns://8.8.8.8/a:1"}) {
    EXPECT_THROW(Client{text}, std::invalid_argument) << text;
  }
  EXPECT_THAT([] { Client("a:1,b"); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("\"b\" is not HOST:PORT")));
}

TEST(ServerAddress, RefusesASocketPathThatIsTooLong) {
  const std::string longest = "unix:/" + std::string(106, 'a');
  EXPECT_THAT(TargetsOf(longest), ElementsAre(longest));
  EXPECT_THAT([&] { Client("localhost:1," + longest + "b"); },
              ThrowsMessage<std::invalid_argument>(
                  "\"" + longest +
                  "b\": the path of a UNIX socket has at most 107 bytes, this one has 108"));
}

}  // namespace
}  // namespace fovea::client
