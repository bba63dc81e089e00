// Whom a handshake is ascribed to that has failed.
#include "server/logging/failed_handshakes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spdlog/spdlog.h>
#include <sys/eventfd.h>

#include <chrono>
#include <string>

#include "server/connections/connection_table.h"
#include "tests/server/captured_log.h"

namespace fovea::testing {
namespace {

using server::HandshakeClock;
using server::NoteFailedHandshake;
using server::TakeFailedHandshake;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kAccusation = "and a handshake has failed";

class FailedHandshakes : public ::testing::Test {
 protected:
  FailedHandshakes() {
    while (TakeFailedHandshake()) {  // of other tests
    }
  }
  int Add(const std::string& peer) {
    return table_.Add(peer, server::FileDescriptor(eventfd(0, EFD_CLOEXEC))).watched;
  }

  // Not forgotten while a test runs.
  const HandshakeClock::time_point soon_ = HandshakeClock::now() + std::chrono::hours(1);
  server::ConnectionTable table_{{.max_connections = 1000, .account = {}}};
};

TEST_F(FailedHandshakes, AreTakenOnceEach) {
  NoteFailedHandshake();
  NoteFailedHandshake();
  EXPECT_TRUE(TakeFailedHandshake());
  EXPECT_TRUE(TakeFailedHandshake());
  EXPECT_FALSE(TakeFailedHandshake());
}

TEST_F(FailedHandshakes, AreForgottenAfterASecond) {
  const auto now = HandshakeClock::now();
  NoteFailedHandshake(now);
  NoteFailedHandshake(now + std::chrono::milliseconds(500));
  EXPECT_TRUE(TakeFailedHandshake(now + std::chrono::milliseconds(1400)));
  EXPECT_FALSE(TakeFailedHandshake(now + std::chrono::milliseconds(1400)));
}

TEST_F(FailedHandshakes, OfUnixSocketsAndOfThoseThatWereEndedAreNobodyElses) {
  const CapturedLog log;
  const int unix_socket = Add("unix:/run/fovea"), ended = Add("ipv4:10.0.0.1:1"),
            probe = Add("ipv4:10.0.0.2:1");
  table_.OnBegunCalls({{"ipv4:10.0.0.1:1", 10'000}}, 1000);
  ASSERT_EQ(table_.counts().ended, 1U);
  NoteFailedHandshake(soon_);
  table_.Remove(unix_socket);
  NoteFailedHandshake(soon_);
  table_.Remove(ended);
  table_.Remove(probe);
  EXPECT_THAT(log.text(), Not(HasSubstr(kAccusation)));
}

TEST_F(FailedHandshakes, OfFewHostsHideNoOther) {
  const CapturedLog log;
  const auto fails = [&](const std::string& peer) {
    const int watched = Add(peer);
    NoteFailedHandshake(soon_);
    table_.Remove(watched);
  };
  for (int port = 1; port <= 200; ++port) fails("ipv4:10.0.0.1:" + std::to_string(port));
  EXPECT_THAT(log.text(), Not(HasSubstr("10.0.0.1:200 ")));
  fails("ipv4:10.0.0.2:1");
  EXPECT_THAT(log.text(), HasSubstr("10.0.0.2:1 ended before a call was let in"));
  EXPECT_THAT(log.text(), HasSubstr(kAccusation));
}

}  // namespace
}  // namespace fovea::testing
