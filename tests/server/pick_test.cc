// Picks: from a person to the stream of a robot that takes them, and to no other.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <future>
#include <thread>

#include "client/detect_stream.h"
#include "server/observing/pick_board.h"
#include "tests/server/detectors.h"
#include "tests/server/observers.h"

namespace fovea::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

v1::SelectObjectRequest Selection(const std::string& robot, std::uint32_t label = 1) {
  v1::SelectObjectRequest request;
  request.set_robot(robot);
  request.mutable_pick()->set_frame_id("f");
  request.mutable_pick()->set_label(label);
  return request;
}

struct Picked {
  grpc::Status status = {};
  v1::SelectObjectResponse response = {};
};

Picked PickAs(const std::string& address, const std::string& token,
              const v1::SelectObjectRequest& request) {
  Picked picked;
  picked.status = AskAs(address, token, [&](auto& stub, grpc::ClientContext* context) {
    return stub.SelectObject(context, request, &picked.response);
  });
  return picked;
}

class ObserversPick : public Observers {
 protected:
  static client::Client Robot(const Loopback& loopback, const std::string& name) {
    client::ClientOptions options = PatientOptions();
    options.robot = name;
    return client::Client(loopback.server.Address(), options);
  }

  static v1::DetectStreamRequest Frame(bool accepts) {
    v1::DetectStreamRequest request;
    *request.mutable_frame() = TestFrame();
    request.set_accept_picks(accepts);
    return request;
  }
};

TEST_F(ObserversPick, ReachTheRobotWithItsNextAnswer) {
  const Loopback loopback(FindOne, options_);
  const client::Client robot = Robot(loopback, "hall");
  const auto stream = robot.OpenStream(kPatience);
  stream->Send(Frame(true));
  EXPECT_FALSE(stream->Receive()->has_pick());
  v1::SelectObjectRequest request = Selection("hall", 7);
  request.mutable_pick()->set_track_id(3);
  request.mutable_pick()->mutable_oriented_box()->mutable_size()->set_x(0.25);
  auto picked = std::async(std::launch::async,
                           [&] { return PickAs(loopback.server.Address(), "all-of-it", request); });
  v1::DetectStreamResponse answer;
  while (!answer.has_pick()) {  // it is on its way
    stream->Send(Frame(false));
    answer = *stream->Receive();
  }
  EXPECT_EQ(answer.pick().observer(), "ann");
  EXPECT_EQ(answer.pick().frame_id(), "f");
  EXPECT_EQ(answer.pick().label(), 7U);
  EXPECT_EQ(answer.pick().track_id(), 3U);
  EXPECT_EQ(answer.pick().oriented_box().size().x(), 0.25);
  EXPECT_TRUE(answer.has_detections());
  const Picked outcome = picked.get();
  ASSERT_TRUE(outcome.status.ok()) << outcome.status.error_message();
  EXPECT_TRUE(outcome.response.delivered());
  stream->Send(Frame(false));
  EXPECT_FALSE(stream->Receive()->has_pick()) << "once";
}

TEST_F(ObserversPick, AreForRobotsThatAskForThem) {
  const Loopback loopback(FindOne, options_);
  const client::Client robot = Robot(loopback, "hall"), other = Robot(loopback, "kitchen-1");
  const auto stream = robot.OpenStream(kPatience), listening = other.OpenStream(kPatience);
  stream->Send(Frame(false));
  listening->Send(Frame(true));
  stream->Receive();
  listening->Receive();
  for (const char* name : {"hall", "nobody"}) {
    const grpc::Status status =
        PickAs(loopback.server.Address(), "all-of-it", Selection(name)).status;
    EXPECT_EQ(status.error_code(), grpc::StatusCode::FAILED_PRECONDITION);
    EXPECT_THAT(status.error_message(), StartsWith(std::string(name) + " takes no picks"));
  }
  // Only the first message can say so.
  stream->Send(Frame(true));
  stream->Receive();
  EXPECT_EQ(PickAs(loopback.server.Address(), "all-of-it", Selection("hall")).status.error_code(),
            grpc::StatusCode::FAILED_PRECONDITION);
}

TEST_F(ObserversPick, NeedTheRightAndTheRobot) {
  folder_.Write("observers", Line("ben", "picker", "view,pick", "kitchen-*") +
                                 Line("cat", "viewer", "view", "*"));
  const Loopback loopback(FindOne, options_);
  const client::Client robot = Robot(loopback, "hall");
  const auto stream = robot.OpenStream(kPatience);
  stream->Send(Frame(true));
  stream->Receive();
  const std::string address = loopback.server.Address();
  EXPECT_EQ(PickAs(address, "nonsense", Selection("hall")).status.error_code(),
            grpc::StatusCode::UNAUTHENTICATED);
  EXPECT_EQ(PickAs(address, "viewer", Selection("hall")).status.error_code(),
            grpc::StatusCode::PERMISSION_DENIED);
  // As one that is not there.
  const grpc::Status foreign = PickAs(address, "picker", Selection("hall")).status;
  EXPECT_EQ(foreign.error_code(), grpc::StatusCode::FAILED_PRECONDITION);
  EXPECT_THAT(foreign.error_message(), StartsWith("hall takes no picks"));
}

TEST_F(ObserversPick, NewestWins) {
  const Loopback loopback(FindOne, options_);
  const client::Client robot = Robot(loopback, "hall");
  const auto stream = robot.OpenStream(kPatience);
  stream->Send(Frame(true));
  stream->Receive();
  const auto pick = [&](std::uint32_t label) {
    return PickAs(loopback.server.Address(), "all-of-it", Selection("hall", label));
  };
  auto one = std::async(std::launch::async, pick, 1), two = std::async(std::launch::async, pick, 2);
  const auto is_done = [](auto& each) {
    return each.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  };
  while (!is_done(one) && !is_done(two)) std::this_thread::yield();  // one replaces the other
  auto& replaced = is_done(one) ? one : two;
  auto& newest = &replaced == &one ? two : one;
  const Picked lost = replaced.get();
  EXPECT_FALSE(lost.response.delivered());
  EXPECT_THAT(lost.response.reason(), HasSubstr("a newer pick"));
  stream->Send(Frame(false));
  EXPECT_EQ(stream->Receive()->pick().label(), &newest == &two ? 2U : 1U);
  EXPECT_TRUE(newest.get().response.delivered());
}

TEST_F(ObserversPick, EndWithTheStream) {
  const Loopback loopback(FindOne, options_);
  const client::Client robot = Robot(loopback, "hall");
  auto stream = robot.OpenStream(kPatience);
  stream->Send(Frame(true));
  stream->Receive();
  auto picked = std::async(std::launch::async, [&] {
    return PickAs(loopback.server.Address(), "all-of-it", Selection("hall"));
  });
  stream.reset();
  const Picked outcome = picked.get();
  // It came before the end of the stream was noticed, or after.
  EXPECT_FALSE(outcome.response.delivered());
  EXPECT_TRUE(!outcome.status.ok() || outcome.response.reason() == "the robot's stream has ended")
      << outcome.response.reason();
}

TEST_F(ObserversPick, MistakesAreNamed) {
  const Loopback loopback(FindOne, options_);
  const auto error_of = [&](auto change) {
    v1::SelectObjectRequest request = Selection("hall");
    change(request);
    const grpc::Status status = PickAs(loopback.server.Address(), "all-of-it", request).status;
    EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
    return status.error_message();
  };
  EXPECT_THAT(error_of([](auto& r) { r.clear_robot(); }), StartsWith("robot: "));
  EXPECT_THAT(error_of([](auto& r) { r.mutable_pick()->clear_label(); }),
              StartsWith("pick.label: "));
  EXPECT_THAT(error_of([](auto& r) { r.mutable_pick()->set_frame_id(std::string(2000, 'x')); }),
              StartsWith("pick.frame_id: "));
  EXPECT_THAT(error_of([](auto& r) {
                r.mutable_pick()->mutable_oriented_box()->mutable_size()->set_x(NAN);
              }),
              StartsWith("pick.oriented_box: "));
}

TEST(PickBoard, TakesBackWhatIsLate) {
  server::PickBoard board;
  const auto listening = board.Listen("hall");
  const auto outcome = board.Deliver("hall", /*may_see=*/true, {}, std::chrono::milliseconds(0),
                                     [] { return false; });
  EXPECT_FALSE(outcome.delivered);
  EXPECT_THAT(outcome.reason, HasSubstr("answered nothing in time"));
  EXPECT_EQ(board.Take("hall"), nullptr) << "it never comes after that was said";
}

TEST(PickBoard, OneThatCouldNotBeSentIsNotDelivered) {
  server::PickBoard board;
  const auto listening = board.Listen("hall");
  auto outcome = std::async(std::launch::async, [&] {
    return board.Deliver("hall", /*may_see=*/true, {}, kPatience, [] { return false; });
  });
  server::PickBoard::TakenPtr taken;
  while (!(taken = board.Take("hall"))) std::this_thread::yield();
  taken.reset();
  EXPECT_FALSE(outcome.get().delivered);
}

}  // namespace
}  // namespace fovea::testing
