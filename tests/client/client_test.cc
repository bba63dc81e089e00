#include "client/client.h"

#include <gmock/gmock.h>
#include <grpcpp/server_builder.h>
#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <set>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <thread>

#include "client/cli/parsing.h"
#include "client/images.h"
#include "client/too_large.h"
#include "tests/server/detectors.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"
#include "tests/support/held_address.h"

namespace fovea::client {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::Loopback;
using ::testing::StartsWith;
using ::testing::ThrowsMessage;

TEST(Client, SaysWhenNoServerIsThere) {
  const testing::HeldAddress nobody;
  const Client client(nobody.Text());
  const grpc::Status call = testing::StatusOf([&] { client.Detect({}); });
  EXPECT_EQ(call.error_code(), grpc::StatusCode::UNAVAILABLE);
  const grpc::Status wait =
      testing::StatusOf([&] { client.WaitUntilReady(std::chrono::milliseconds(100)); });
  EXPECT_EQ(wait.error_code(), grpc::StatusCode::DEADLINE_EXCEEDED);
  EXPECT_THAT(wait.error_message(), StartsWith("the server is not ready"));
}

TEST(Client, EndsACallThatIsStopped) {
  testing::Gate gate;
  const Loopback loopback(std::ref(gate));
  ClientOptions options = testing::PatientOptions();
  options.retry.max_attempts = 5;
  const Client client(loopback.server.Address(), options);
  std::stop_source stop;
  std::jthread stopping([&] {
    gate.WaitUntilBegun();
    stop.request_stop();
  });
  const auto detect = [&] { client.Detect(testing::TestRequest(), {.stop = stop.get_token()}); };
  EXPECT_EQ(testing::StatusOf(detect).error_code(), grpc::StatusCode::CANCELLED);
  gate.Let();
  EXPECT_EQ(testing::StatusOf(detect).error_code(), grpc::StatusCode::CANCELLED) << "it stays so";
  EXPECT_EQ(loopback.client.GetStatistics().frames_received(), 1U) << "no other attempt";
}

TEST(Client, RefusesWhatMetadataCannotHold) {
  for (const char* text : {"k\u00fcche", "a\tb", "a\n"}) {
    ClientOptions robot, token;
    robot.robot = text;
    token.token = text;
    EXPECT_THROW(Client("localhost:1", robot), std::invalid_argument) << text;
    EXPECT_THROW(Client("localhost:1", token), std::invalid_argument) << text;
  }
}

TEST(Client, RefusesPathsInPlaceOfPem) {
  const std::string certificate = "-----BEGIN CERTIFICATE-----";
  const auto client_with = [](TlsOptions tls) {
    ClientOptions options;
    options.tls = std::move(tls);
    return [options] { Client("localhost:1", options); };
  };
  EXPECT_THAT(client_with({"ca.pem", "", ""}),
              ThrowsMessage<std::invalid_argument>(HasSubstr("tls.root_certificates: holds no")));
  EXPECT_THAT(client_with({certificate, "robot.pem", "robot.key"}),
              ThrowsMessage<std::invalid_argument>(HasSubstr("tls.certificate_chain: holds no")));
  EXPECT_THAT(client_with({certificate, certificate, "robot.key"}),
              ThrowsMessage<std::invalid_argument>(HasSubstr("tls.private_key: holds no PRIVATE")));
}

TEST(Client, RefusesHalfOfATlsPair) {
  for (const TlsOptions& half : {TlsOptions{"", "PEM", ""}, TlsOptions{"", "", "PEM"}}) {
    ClientOptions options;
    options.tls = half;
    EXPECT_THROW(Client("localhost:1", options), std::invalid_argument);
  }
}

TEST(Client, RefusesALimitThatGrpcCannotHold) {
  for (const int mib : {-1, 0, 2048, 4096}) {
    ClientOptions options;
    options.max_answer_mib = mib;
    EXPECT_THAT([&] { Client("localhost:1", options); },
                ThrowsMessage<std::invalid_argument>("max_answer_mib: " + std::to_string(mib) +
                                                     " is not 1 to 2047"));
  }
  const Loopback loopback(testing::FindOne);
  ClientOptions largest;
  largest.max_answer_mib = 2047;
  EXPECT_NO_THROW(Client(loopback.server.Address(), largest).Detect(testing::TestRequest()));
}

TEST(Client, SaysWhatIsTooLargeAndWhatHelps) {
  server::ServerOptions options = testing::LoopbackOptions();
  options.max_message_mib = 1;
  const Loopback loopback(testing::FindOne, options);
  v1::DetectStreamRequest large;
  *large.mutable_frame() = testing::TestFrame();
  large.mutable_frame()->mutable_color()->mutable_data()->resize(2 << 20);
  v1::DetectRequest call;
  *call.mutable_frame() = large.frame();
  const std::string says = "the frame is 2.0 MiB, the server takes 1.0 MiB (--max-message-mib): ";
  EXPECT_THAT(testing::StatusOf([&] { loopback.client.Detect(call); }).error_message(),
              StartsWith(says));
  const auto stream = loopback.client.OpenStream(testing::kPatience);
  stream->Send(large);
  EXPECT_THAT(testing::StatusOf([&] { stream->Receive(); }).error_message(), StartsWith(says));
}

TEST(Client, KnowsItsOwnLimitOfAnswers) {
  const auto text = [](const std::string& message) {
    return SayingWhatIsTooLarge({grpc::StatusCode::RESOURCE_EXHAUSTED, message}, 2).error_message();
  };
  EXPECT_EQ(text("Received message larger than max (3145728 vs. 2097152)"),
            "the answer is 3.0 MiB, this client takes 2.0 MiB (max_answer_mib)");
  EXPECT_THAT(text("Received message larger than max (3145728 vs. 1048576)"),
              StartsWith("the frame is 3.0 MiB, the server takes 1.0 MiB (--max-message-mib)"));
  EXPECT_EQ(text("larger than it should be"), "larger than it should be");
}

TEST(Client, WaitsAsLongAsItIsTold) {
  constexpr auto kForever = std::chrono::milliseconds::max();
  const Loopback loopback(testing::FindOne);
  const Client client(loopback.server.Address(), {.timeout = kForever});
  EXPECT_NO_THROW(client.WaitUntilReady(kForever));
  EXPECT_TRUE(client.IsServing());
  EXPECT_NO_THROW(client.Detect(testing::TestRequest()));
  EXPECT_NO_THROW(client.Detect(testing::TestRequest(), kForever));
  v1::DetectStreamRequest request;
  *request.mutable_frame() = testing::TestFrame();
  const auto stream = client.OpenStream(kForever);
  stream->Send(request);
  EXPECT_TRUE(stream->Receive());
  const auto resuming = client.OpenResumingStream(kForever);
  resuming->Send(request);
  EXPECT_TRUE(resuming->Receive());
  constexpr auto kLongAgo = std::chrono::milliseconds::min();
  EXPECT_EQ(
      testing::StatusOf([&] { client.Detect(testing::TestRequest(), kLongAgo); }).error_code(),
      grpc::StatusCode::DEADLINE_EXCEEDED);
}

TEST(Client, ThrowsWhatTheServerSays) {
  const Loopback loopback;
  try {
    loopback.client.Detect({});
    FAIL() << "an empty request was answered";
  } catch (const RpcError& error) {
    EXPECT_EQ(error.code(), grpc::StatusCode::INVALID_ARGUMENT);
    EXPECT_EQ(error.what(),
              "INVALID_ARGUMENT: frame: is missing (request " + error.request_id() + ")");
  }
}

// Tells the connections of its callers apart.
struct Reception : v1::DetectionService::Service {
  grpc::Status GetServerInfo(grpc::ServerContext* context, const v1::GetServerInfoRequest*,
                             v1::GetServerInfoResponse*) override {
    peers.insert(context->peer());
    return {};
  }

  std::set<std::string> peers;
};

TEST(Client, HasAConnectionOfItsOwn) {
  Reception reception;
  int port = 0;
  const auto server = grpc::ServerBuilder()
                          .AddListeningPort("127.0.0.1:0", grpc::InsecureServerCredentials(), &port)
                          .RegisterService(&reception)
                          .BuildAndStart();
  const Client first("127.0.0.1:" + std::to_string(port));
  const Client second("127.0.0.1:" + std::to_string(port));
  for (const Client* client : {&first, &second, &first, &second}) client->GetServerInfo();
  EXPECT_EQ(reception.peers.size(), 2U);
  server->Shutdown();
}

TEST(Client, DetectsInFramesMadeByItsHelpers) {
  const Loopback loopback;
  v1::DetectRequest request;
  v1::Frame& frame = *request.mutable_frame();
  const cv::Mat color = testing::TestColor(), depth = testing::TestDepth(),
                meters = testing::TestMeters();
  *frame.mutable_intrinsics() = MakeIntrinsics(30, 30, 15.5, 11.5);
  *frame.mutable_color() =
      MakeColorImage(color.data, testing::kWidth, testing::kHeight, v1::COLOR_ENCODING_RGB8);
  *frame.mutable_depth() =
      MakeDepthImage(depth.ptr<std::uint16_t>(), testing::kWidth, testing::kHeight);
  EXPECT_NO_THROW(loopback.client.Detect(request));
  *frame.mutable_depth() = MakeDepthImage(meters.ptr<float>(), testing::kWidth, testing::kHeight);
  EXPECT_NO_THROW(loopback.client.Detect(request));
  *frame.mutable_color() = MakeColorImage(testing::JpegOf(color));
  *frame.mutable_depth() = MakeDepthImage(testing::PngOf(depth));
  EXPECT_NO_THROW(loopback.client.Detect(request));
}

TEST(MakeImage, RefusesFilesOfAnotherKind) {
  EXPECT_THROW(MakeColorImage("GIF89a"), std::invalid_argument);
  EXPECT_THROW(MakeColorImage(""), std::invalid_argument);
  EXPECT_THROW(MakeDepthImage(testing::JpegOf(testing::TestColor())), std::invalid_argument);
}

TEST(Parsing, ReadsNumbersAndSettings) {
  EXPECT_THAT(cli::ParseNumbers("525,-5e2,.5", 3, "--f", "A,B,C"), ElementsAre(525, -500, 0.5));
  EXPECT_THAT(cli::ParseNumbers(" 1, 2 ,3 ", 3, "--f", "A,B,C"), ElementsAre(1, 2, 3));
  EXPECT_EQ(cli::ParseSetting("mrf.gamma=80"), std::pair(std::string("mrf.gamma"), 80.0));
  for (const char* text : {"", "1,2", "1,2,3,4", "1,,3", "1,2,x", "1,2 5,3", "1, ,3", "1,2,3,"}) {
    EXPECT_THROW(cli::ParseNumbers(text, 3, "--f", "A,B,C"), std::invalid_argument) << text;
  }
  for (const char* text : {"", "=", "=1", "name", "name=", "name=x", "name=1x"}) {
    EXPECT_THROW(cli::ParseSetting(text), std::invalid_argument) << text;
  }
}

}  // namespace
}  // namespace fovea::client
