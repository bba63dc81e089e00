// Who gets a place where all are taken.
#include "server/connections/connection_table.h"

#include <gtest/gtest.h>
#include <sys/eventfd.h>

#include <string>

namespace fovea::testing {
namespace {

class ConnectionTableTest : public ::testing::Test {
 protected:
  server::ConnectionTable::Added Add(const std::string& host) {
    const std::string peer = "ipv4:" + host + ":" + std::to_string(++port_);
    return table_.Add(peer, server::FileDescriptor(eventfd(0, EFD_CLOEXEC)));
  }
  // Whether there was a place for a connection of the host.
  bool Comes(const std::string& host) { return Add(host).watched >= 0; }

  server::ConnectionTable table_{{.max_connections = 4, .max_per_host = 3, .account = {}}};

 private:
  int port_ = 0;
};

TEST_F(ConnectionTableTest, OfManyThatHaveJustComeOneMakesRoomForAHostThatHasFewer) {
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(Comes("10.0.0.1"));
  EXPECT_TRUE(Comes("10.0.0.2"));
  EXPECT_TRUE(Comes("10.0.0.3"));
  EXPECT_EQ(table_.counts().ended, 1U);
}

TEST_F(ConnectionTableTest, WhoHasJustComeStaysWhereNobodyHasMore) {
  for (const char* host : {"10.0.0.1", "10.0.0.2", "10.0.0.3", "10.0.0.4"})
    EXPECT_TRUE(Comes(host));
  EXPECT_EQ(Add("10.0.0.5").why_not, "there are 4 already (--max-connections)");
  EXPECT_EQ(table_.counts().refused, 1U);
}

TEST_F(ConnectionTableTest, AHostMakesNoRoomForItselfAtOnce) {
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(Comes("10.0.0.1"));
  EXPECT_EQ(Add("10.0.0.1").why_not, "its host has 3 already (--max-connections-per-host)");
}

TEST_F(ConnectionTableTest, RobotsKeepTheirPlaces) {
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(Comes("10.0.0.1"));
  for (int port = 1; port <= 3; ++port) table_.Admit("ipv4:10.0.0.1:" + std::to_string(port));
  EXPECT_TRUE(Comes("10.0.0.2"));
  EXPECT_FALSE(Comes("10.0.0.3"));
}

TEST_F(ConnectionTableTest, AStrangerWithManyCallsIsEnded) {
  EXPECT_TRUE(Comes("10.0.0.1"));
  table_.OnBegunCalls({{"ipv4:10.0.0.1:1", 64}}, 1000);
  EXPECT_TRUE(table_.IsOpen("ipv4:10.0.0.1:1"));
  table_.OnBegunCalls({{"ipv4:10.0.0.1:1", 65}}, 1000);
  EXPECT_FALSE(table_.IsOpen("ipv4:10.0.0.1:1"));
  EXPECT_EQ(table_.counts().ended, 1U);
  EXPECT_EQ(Add("10.0.0.1").why_not, "its host sent a flood of calls");  // for some seconds
  EXPECT_TRUE(Comes("10.0.0.2"));
}

TEST_F(ConnectionTableTest, ARobotMayBeginMore) {
  EXPECT_TRUE(Comes("10.0.0.1"));
  table_.Admit("ipv4:10.0.0.1:1");
  table_.OnBegunCalls({{"ipv4:10.0.0.1:1", 1000}}, 1000);
  EXPECT_TRUE(table_.IsOpen("ipv4:10.0.0.1:1"));
  table_.OnBegunCalls({{"ipv4:10.0.0.1:1", 1001}}, 1000);
  EXPECT_FALSE(table_.IsOpen("ipv4:10.0.0.1:1"));
}

}  // namespace
}  // namespace fovea::testing
