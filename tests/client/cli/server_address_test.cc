#include "client/cli/server_address.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace fovea::cli {
namespace {

TEST(CheckServerAddress, TakesHostsWithPortAndTargetsOfGrpc) {
  for (const char* address :
       {"127.0.0.1:50051", "localhost:1", "detector.lab:65535", "[::1]:50051",
        "ipv4:10.0.0.1:50051,10.0.0.2:50051", "dns:///detector:50051", "unix:/run/fovea"}) {
    EXPECT_NO_THROW(CheckServerAddress(address)) << address;
  }
}

TEST(SplitServerAddresses, GivesEachOnItsOwn) {
  const std::string both = "[::1]:1,unix:/run/fovea";
  EXPECT_EQ(SplitServerAddresses(both), (std::vector<std::string>{"[::1]:1", "unix:/run/fovea"}));
  EXPECT_THROW(SplitServerAddresses("[::1]:1,"), std::invalid_argument);
}

TEST(CheckServerAddress, RefusesTheRest) {
  for (const char* address :
       {"", "localhost", "localhost:", ":50051", "localhost:0", "localhost:99999", "localhost:-1",
        "localhost:5x", "::1:50051", "[]:50051", "http://127.0.0.1:50051", "127.0.0.1:50051/"}) {
    EXPECT_THROW(CheckServerAddress(address), std::invalid_argument) << address;
  }
}

}  // namespace
}  // namespace fovea::cli
