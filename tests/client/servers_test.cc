#include "client/servers.h"

#include <gtest/gtest.h>

#include <string>

namespace fovea::client {
namespace {

// A thread whose lookup takes too long may come after one that has found some.
TEST(Servers, AreNotForgottenWhereALookupFindsNone) {
  Servers servers("127.0.0.1:1,127.0.0.1:2", {});
  std::string problem;
  const auto now = Servers::Clock::now();
  const Servers::Pointer home = servers.Home(now, &problem);
  ASSERT_TRUE(home) << problem;
  EXPECT_EQ(servers.Take({}).size(), 2U);
  EXPECT_EQ(servers.size(), 2U);
  EXPECT_EQ(servers.Home(now, &problem), home);
  EXPECT_EQ(servers.Take({{"ipv4:127.0.0.1:2", ""}}).size(), 1U);
  EXPECT_EQ(servers.size(), 1U);
}

TEST(Servers, HaveNoHomeWhereNoneIsKnown) {
  Servers servers("no-such-host.invalid:7", {});
  EXPECT_TRUE(servers.Take({}).empty());
  std::string problem;
  EXPECT_FALSE(servers.Home(Servers::Clock::now(), &problem));
  EXPECT_FALSE(problem.empty());
}

}  // namespace
}  // namespace fovea::client
