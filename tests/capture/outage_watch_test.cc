#include "client/capture/outage_watch.h"

#include <gtest/gtest.h>

namespace fovea::capture {
namespace {

using std::chrono::seconds;

class OutageWatchTest : public ::testing::Test {
 protected:
  void Send(seconds at, bool was_taken = true) {
    watch_.Sending(OutageWatch::Time(at));
    watch_.Sent(was_taken);
  }
  void Answer(std::uint64_t sequence, seconds at) {
    watch_.Answered(sequence, OutageWatch::Time(at));
  }
  std::string Take(seconds at) { return watch_.Take(OutageWatch::Time(at)); }

  OutageWatch watch_{"robot:1"};
};

TEST_F(OutageWatchTest, SaysOnceThatTheServerIsAwayAndOnceThatItIsBack) {
  Send(seconds(100));
  Answer(0, seconds(100));
  Send(seconds(101), /*was_taken=*/false);
  EXPECT_EQ(Take(seconds(101)), "") << "it may go on at another server at once";
  Send(seconds(102), /*was_taken=*/false);
  EXPECT_EQ(Take(seconds(102)), "the server at robot:1 is away; waiting for it to come back\n");
  Send(seconds(500), /*was_taken=*/false);
  EXPECT_EQ(Take(seconds(500)), "");
  Send(seconds(501));
  EXPECT_EQ(Take(seconds(501)), "") << "no answer yet";
  Answer(4, seconds(502));
  EXPECT_EQ(Take(seconds(502)), "the server at robot:1 is back\n");
  EXPECT_EQ(Take(seconds(503)), "");
}

// As one that is stopped: where nothing is taken in, Sent() is not reached.
TEST_F(OutageWatchTest, SaysThatAServerIsSilent) {
  watch_.Sending(OutageWatch::Time(seconds(100)));
  EXPECT_EQ(Take(seconds(102)), "");
  EXPECT_EQ(Take(seconds(103)), "the server at robot:1 has not answered for 3 s; waiting\n");
  EXPECT_EQ(Take(seconds(104)), "");
  watch_.Sent(true);
  Answer(0, seconds(110));
  EXPECT_EQ(Take(seconds(110)), "the server at robot:1 is back\n");
  Send(seconds(111));
  EXPECT_EQ(Take(seconds(115)), "") << "it is slow";
  EXPECT_EQ(Take(seconds(117)), "the server at robot:1 has not answered for 6 s; waiting\n");
}

TEST_F(OutageWatchTest, IsQuietWhereNoFrameWaits) {
  EXPECT_EQ(Take(seconds(100)), "");
  Send(seconds(100));
  Answer(0, seconds(101));
  EXPECT_EQ(Take(seconds(200)), "");
  Send(seconds(200));
  Send(seconds(201));
  Answer(1, seconds(202));
  EXPECT_EQ(Take(seconds(204)), "") << "the answer before is a sign of life";
}

}  // namespace
}  // namespace fovea::capture
