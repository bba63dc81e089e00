// Limits on streams and messages, and callers that hold connections and speak no gRPC.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <thread>

#include "tests/server/bare_connection.h"
#include "tests/server/detectors.h"
#include "tests/server/file_limit.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"
#include "tests/server/metric_value.h"
#include "tests/support/certificates.h"
#include "tests/support/temporary_folder.h"

namespace fovea::testing {
namespace {

using client::Client;
using client::ClientOptions;
using ::testing::HasSubstr;

std::unique_ptr<client::DetectStream> OpenStream(const std::string& address,
                                                 const std::string& robot) {
  ClientOptions of_robot = PatientOptions();
  of_robot.robot = robot;
  return AnsweredStream(Client(address, of_robot));
}

TEST(Limits, StreamsAreCountedByRobotAndInAll) {
  server::ServerOptions options = LoopbackOptions();
  options.max_streams = options.max_streams_per_host = 3;
  options.max_streams_per_robot = 2;
  const Loopback loopback(FindOne, options);
  std::vector<std::unique_ptr<client::DetectStream>> open;
  const auto open_stream = [&](const std::string& robot) {
    open.push_back(OpenStream(loopback.server.Address(), robot));
  };
  open_stream("a");
  open_stream("a");
  EXPECT_THAT(StatusOf([&] { open_stream("a"); }).error_message(), HasSubstr("this robot has 2"));
  open_stream("b");
  const grpc::Status full = StatusOf([&] { open_stream("c"); });
  EXPECT_EQ(full.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_EQ(full.error_message(), "all 3 streams are open");
  const server::Metrics& metrics = *loopback.server.metrics();
  EXPECT_EQ(MetricValue(metrics, "fovea_refused_total", "ROBOT_STREAM_LIMIT"), 1);
  EXPECT_EQ(MetricValue(metrics, "fovea_refused_total", "STREAM_LIMIT"), 1);
  open.clear();
  AwaitMetric(*loopback.server.metrics(), "fovea_streams", 0);
  open_stream("c");
}

TEST(Limits, ManyNamesOpenNoMoreStreamsThanOneHostMay) {
  const TemporaryFolder folder;
  server::ServerOptions options = LoopbackOptions();
  options.listen.push_back("unix:" + folder.At("s"));
  options.max_streams = 4;
  options.max_streams_per_robot = 1;
  const Loopback loopback(FindOne, options);
  std::vector<std::unique_ptr<client::DetectStream>> open;
  const auto open_stream = [&](const std::string& address, const std::string& robot) {
    open.push_back(OpenStream(address, robot));
  };
  const std::string address = loopback.server.Address();
  open_stream(address, "a");
  open_stream(address, "b");
  const grpc::Status full = StatusOf([&] { open_stream(address, "c"); });
  EXPECT_EQ(full.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_THAT(full.error_message(), HasSubstr("this host has 2 streams open"));
  const server::Metrics& metrics = *loopback.server.metrics();
  EXPECT_EQ(MetricValue(metrics, "fovea_refused_total", "HOST_STREAM_LIMIT"), 1);
  // Another host has its own, for a robot of the same name too.
  open_stream(options.listen.back(), "a");
  open_stream(options.listen.back(), "c");
}

TEST(Limits, ARobotMayHaveAllStreamsWhereTheOperatorSaysSo) {
  server::ServerOptions options = LoopbackOptions();
  options.max_streams = options.max_streams_per_robot = 3;
  const Loopback loopback(FindOne, options);
  std::vector<std::unique_ptr<client::DetectStream>> open(3);
  for (auto& stream : open) stream = OpenStream(loopback.server.Address(), "a");
  EXPECT_EQ(StatusOf([&] { OpenStream(loopback.server.Address(), "b"); }).error_message(),
            "all 3 streams are open");
}

TEST(Limits, MessagesAreBounded) {
  server::ServerOptions options = LoopbackOptions();
  options.max_message_mib = 1;
  const Loopback loopback(FindOne, options);
  v1::DetectRequest request = TestRequest();
  request.mutable_frame()->mutable_color()->set_data(std::string(2 << 20, 'x'));
  EXPECT_EQ(StatusOf([&] { loopback.client.Detect(request); }).error_code(),
            grpc::StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_NO_THROW(loopback.client.Detect(TestRequest()));
}

TEST(Connections, HalfAHandshakeHoldsUpNobody) {
  const Authority authority;
  const PemPair pair = authority.Issue("server");
  const TemporaryFolder folder;
  server::ServerOptions options = LoopbackOptions();
  options.tls_key = folder.Write("key.pem", pair.key);
  options.tls_cert = folder.Write("cert.pem", pair.certificate);
  Loopback loopback(FindOne, options);
  std::vector<std::unique_ptr<BareConnection>> stuck;
  for (int i = 0; i < 20; ++i) {
    stuck.push_back(std::make_unique<BareConnection>(loopback.server.Address()));
    stuck.back()->Send(std::string("\x16\x03\x01\x02\x00\x01", 6));  // a ClientHello's start
  }
  ClientOptions trusting = PatientOptions();
  trusting.tls.emplace().root_certificates = authority.Certificate();
  EXPECT_NO_THROW(Client(loopback.server.Address(), trusting).Detect(TestRequest()));
  loopback.server.Drain();
}

TEST(Connections, ComeAndGo) {
  const Loopback loopback(FindOne);
  loopback.client.Detect(TestRequest());
  const std::size_t before = NumOpenFiles();
  for (int i = 0; i < 1000; ++i) {
    const BareConnection connection(loopback.server.Address());
    if (i % 2 == 0) connection.Send("PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n");
    if (i % 3 == 0) connection.Send("garbage");
  }
  loopback.client.Detect(TestRequest());
  while (NumOpenFiles() > before) std::this_thread::yield();
}

}  // namespace
}  // namespace fovea::testing
