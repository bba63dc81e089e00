#include "flags/listen_address.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace fovea::flags {
namespace {

using ::testing::StrEq;
using ::testing::ThrowsMessage;

TEST(RequireListenAddress, TakesHostsWithPorts) {
  for (const char* listen :
       {"127.0.0.1:0", "localhost:8080", "[::1]:65535", "0.0.0.0:1", "robots.example:443"}) {
    EXPECT_NO_THROW(RequireListenAddress("--listen", listen)) << listen;
  }
}

TEST(RequireListenAddress, NamesTheFlagAndTheValue) {
  EXPECT_THAT([] { RequireListenAddress("--metrics-listen", "127.0.0.1:99999"); },
              ThrowsMessage<std::invalid_argument>(
                  StrEq("--metrics-listen: \"127.0.0.1:99999\" is not HOST:PORT with a port of 0 "
                        "to 65535")));
}

TEST(RequireListenAddress, RefusesWhatIsNone) {
  for (const char* listen : {"", ":", "localhost", ":80", "localhost:", "localhost:-1",
                             "localhost:+1", "localhost: 1", "localhost:1 ", "localhost:0x50",
                             "localhost:http", "localhost:65536", "localhost:99999999999"}) {
    EXPECT_THROW(RequireListenAddress("--listen", listen), std::invalid_argument) << listen;
  }
}

}  // namespace
}  // namespace fovea::flags
