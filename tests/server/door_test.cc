// Connections: where they come in, how many find a place, and what they may hold.
#include "server/connections/door.h"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <grpcpp/create_channel.h>
#include <grpcpp/generic/generic_stub.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include <atomic>
#include <filesystem>
#include <future>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "grpc/health/v1/health.grpc.pb.h"
#include "server/connections/self_check.h"
#include "server/connections/socket_address.h"
#include "tests/server/bare_connection.h"
#include "tests/server/captured_log.h"
#include "tests/server/detectors.h"
#include "tests/server/file_limit.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"
#include "tests/server/metric_value.h"
#include "tests/support/temporary_folder.h"

namespace fovea::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::Not;

std::vector<BareConnection> Connect(const std::string& address, int number) {
  std::vector<BareConnection> connections;
  connections.reserve(static_cast<std::size_t>(number));
  for (int i = 0; i < number; ++i) connections.emplace_back(address);
  return connections;
}

void AwaitOpen(const server::Server& server, std::size_t number) {
  while (server.connections().counts().open != number) std::this_thread::yield();
}

server::SocketAddress AddressOf(const char* host) {
  sockaddr_in6 address{};
  address.sin6_family = AF_INET6;
  address.sin6_port = htons(1234);
  inet_pton(AF_INET6, host, &address.sin6_addr);
  return {reinterpret_cast<const sockaddr*>(&address), sizeof address};
}

TEST(SocketAddress, IsWrittenAsGrpcDoes) {
  EXPECT_EQ(AddressOf("::1").Uri(), "ipv6:%5B::1%5D:1234");
  EXPECT_EQ(AddressOf("::ffff:10.0.0.7").Uri(), "ipv4:10.0.0.7:1234");
}

TEST(SocketAddress, IsReachedByItsOwnMachineAlsoWithoutIpv6) {
  EXPECT_EQ(AddressOf("::").OrLoopback().Uri(), "ipv4:127.0.0.1:1234");
  EXPECT_EQ(AddressOf("::1").OrLoopback().Uri(), "ipv6:%5B::1%5D:1234");
}

TEST(SocketAddress, OfAPeerIsThatWithoutThePort) {
  EXPECT_EQ(server::AddressOfPeer("ipv4:10.0.0.7:1234"), "ipv4:10.0.0.7");
  EXPECT_EQ(server::AddressOfPeer("ipv6:%5B2001:db8::7%5D:1234"), "ipv6:%5B2001:db8::7%5D");
  EXPECT_EQ(server::AddressOfPeer("unix:"), "unix");
}

TEST(SocketAddress, HostsAreCountedByWhatOneOfThemHas) {
  using server::HostOfPeer;
  EXPECT_EQ(HostOfPeer("ipv4:10.0.0.7:1234"), "ipv4:10.0.0.7");
  EXPECT_EQ(HostOfPeer("unix:"), "unix");
  for (const char* same : {"ipv6:%5B2001:db8:1:2::7%5D:1234", "ipv6:[2001:db8:1:2::8]:99",
                           "ipv6:%5B2001:db8:1:2:ffff:ffff:ffff:ffff%5D:1234"}) {
    EXPECT_EQ(HostOfPeer(same), "ipv6:2001:db8:1:2::/64") << same;
  }
  EXPECT_EQ(HostOfPeer("ipv6:%5B2001:db8:1:3::7%5D:1234"), "ipv6:2001:db8:1:3::/64");
  EXPECT_EQ(HostOfPeer("ipv6:%5Bfe80::7%252%5D:1234"), "ipv6:fe80::/64");
  EXPECT_EQ(HostOfPeer("ipv6:%5B::ffff:10.0.0.7%5D:1234"), "ipv4:10.0.0.7");
  EXPECT_EQ(HostOfPeer("ipv6:%5B::1%5D:1234"), "ipv6:%5B::1%5D");
  EXPECT_EQ(HostOfPeer("ipv6:"), "ipv6");
}

TEST(Door, ListensAtSeveralAddresses) {
  const TemporaryFolder folder;
  const std::string unix_address = "unix:" + folder.At("fovea.sock");
  server::ServerOptions options = LoopbackOptions();
  options.listen = {"127.0.0.1:0", "[::1]:0", unix_address};
  const Loopback loopback(FindOne, options);
  const std::vector<std::string> addresses = loopback.server.Addresses();
  ASSERT_EQ(addresses.size(), 3U);
  EXPECT_THAT(addresses[0], MatchesRegex("127\\.0\\.0\\.1:[1-9][0-9]*"));
  EXPECT_THAT(addresses[1], MatchesRegex("\\[::1\\]:[1-9][0-9]*"));
  EXPECT_EQ(addresses[2], unix_address);
  for (const std::string& address : addresses) {
    EXPECT_NO_THROW(client::Client(address, PatientOptions()).Detect(TestRequest())) << address;
  }
}

TEST(Door, LeavesNoSocketFileBehindAndTakesOverOneThatWasLeft) {
  const TemporaryFolder folder;
  const std::string path = folder.At("fovea.sock");
  server::ServerOptions options = LoopbackOptions();
  options.listen = {"unix:" + path};
  {
    const server::FileDescriptor killed(socket(AF_UNIX, SOCK_STREAM, 0));
    const server::SocketAddress address = server::UnixSocketAddress(path);
    ASSERT_EQ(bind(killed.get(), address.get(), address.size()), 0);
  }
  {
    const mode_t before = umask(0022);
    const Loopback loopback(FindOne, options);
    umask(before);
    struct stat file {};
    ASSERT_EQ(stat(path.c_str(), &file), 0);
    EXPECT_EQ(file.st_mode & 0777, 0660U);  // owner and group, nobody else
    EXPECT_THAT([&] { server::Server second(options); },
                ThrowsMessage<std::runtime_error>(HasSubstr("in use")));
  }
  EXPECT_FALSE(std::filesystem::exists(path));
  options.listen = {"unix:" + folder.Write("text", "")};
  EXPECT_THAT([&] { server::Server server(options); },
              ThrowsMessage<std::runtime_error>(HasSubstr("something else than a socket")));
}

TEST(Door, StrangersMakeRoomForRobots) {
  server::ServerOptions options = LoopbackOptions();
  options.max_connections = 8;
  options.max_connections_per_host = 8;
  Loopback loopback(FindOne, options);
  const auto silent = Connect(loopback.server.Address(), 8);
  AwaitOpen(loopback.server, 8);
  EXPECT_TRUE(silent.front().IsOpen());
  // The client comes again until a stranger has been there for long enough to go.
  client::ClientOptions patient = PatientOptions();
  patient.retry.max_attempts = 1000;
  const client::Client robot(loopback.server.Address(), patient);
  EXPECT_NO_THROW(robot.Detect(TestRequest()));
  EXPECT_GE(loopback.server.connections().counts().ended, 1U);
}

TEST(Door, RobotsKeepTheirPlaces) {
  server::ServerOptions options = LoopbackOptions();
  options.max_connections = 1;
  const Loopback loopback(FindOne, options);
  loopback.client.Detect(TestRequest());
  for (int i = 0; i < 20; ++i) {
    BareConnection(loopback.server.Address()).AwaitEnd();  // refused
  }
  EXPECT_NO_THROW(loopback.client.Detect(TestRequest()));
  const auto counts = loopback.server.connections().counts();
  EXPECT_EQ(counts.accepted, 1U);
  EXPECT_EQ(counts.refused, 20U);
}

TEST(Door, TakesNoCompressedMessages) {
  const Loopback loopback(FindOne);
  namespace health = grpc::health::v1;
  const auto channel =
      grpc::CreateChannel(loopback.server.Address(), grpc::InsecureChannelCredentials());
  for (const auto algorithm : {GRPC_COMPRESS_GZIP, GRPC_COMPRESS_DEFLATE}) {
    grpc::ClientContext context;
    context.set_compression_algorithm(algorithm);
    health::HealthCheckRequest request;
    request.set_service(std::string(1 << 20, 'a'));
    health::HealthCheckResponse response;
    EXPECT_EQ(health::Health::NewStub(channel)->Check(&context, request, &response).error_code(),
              grpc::StatusCode::UNIMPLEMENTED);
  }
}

TEST(Transfer, OfAMessageThatDoesNotComeEndsTheCall) {
  server::ServerOptions options = LoopbackOptions();
  options.max_transfer_s = 1;
  const Loopback loopback(FindOne, options);
  grpc::GenericStub generic(
      grpc::CreateChannel(loopback.server.Address(), grpc::InsecureChannelCredentials()));
  grpc::ClientContext context;
  grpc::CompletionQueue queue;
  const auto call =
      generic.PrepareCall(&context, "/fovea.v1.DetectionService/Detect", &queue);  // sends nothing
  grpc::Status status;
  call->StartCall(&queue);
  call->Finish(&status, &status);
  for (bool ended = false; !ended;) {
    void* tag = nullptr;
    bool ok = false;
    ASSERT_TRUE(queue.Next(&tag, &ok));
    ended = tag == &status;
  }
  EXPECT_EQ(status.error_code(), grpc::StatusCode::CANCELLED);
  EXPECT_EQ(status.error_message(), "the message did not come in time (--max-transfer-s)");
  EXPECT_EQ(context.GetServerTrailingMetadata().count("fovea-request-id"), 1U);
}

TEST(Transfer, OfAnAnswerThatNobodyTakesEndsTheStream) {
  server::ServerOptions options = LoopbackOptions();
  options.max_transfer_s = 1;
  const CapturedLog log;
  const Loopback loopback(FindOne, options);
  const auto stream = loopback.client.OpenStream(kPatience);
  v1::DetectStreamRequest request;
  *request.mutable_frame() = TestFrame();
  // It answers frame by frame until its answers fill what may be on the way, and is ended then.
  while (stream->Send(request)) {
  }
  EXPECT_THROW(while (stream->Receive()){}, client::RpcError);
  AwaitMetric(*loopback.server.metrics(), "fovea_streams", 0);
  EXPECT_EQ(MetricValue(*loopback.server.metrics(), "fovea_untaken_answers_total"), 1);
  EXPECT_THAT(log.text(), HasSubstr("the answer was not taken in time (--max-transfer-s)"));
  EXPECT_THAT(log.text(), Not(HasSubstr("the caller left")));
}

// The frame's own line says that it was answered.
TEST(Transfer, OfAnAnswerThatNobodyTakesIsLogged) {
  server::ServerOptions options = LoopbackOptions();
  options.max_transfer_s = 1;
  const CapturedLog log;
  const Loopback loopback(
      [](const auto&... arguments) {
        Detections much = FindOne(arguments...);
        much.objects.front().cloud.resize(1'000'000);
        return much;
      },
      options);
  v1::DetectRequest request = TestRequest();
  request.mutable_options()->set_return_clouds(true);
  grpc::GenericStub generic(
      grpc::CreateChannel(loopback.server.Address(), grpc::InsecureChannelCredentials()));
  grpc::ClientContext context;
  grpc::CompletionQueue queue;
  const auto call = generic.PrepareCall(&context, "/fovea.v1.DetectionService/Detect", &queue);
  const auto wait = [&] {
    void* tag = nullptr;
    bool ok = false;
    return queue.Next(&tag, &ok) && ok;
  };
  call->StartCall(nullptr);
  EXPECT_TRUE(wait());
  const grpc::Slice slice(request.SerializeAsString());
  call->WriteLast(grpc::ByteBuffer(&slice, 1), {}, nullptr);
  EXPECT_TRUE(wait());
  log.Await("answer request=");  // it is not read
  EXPECT_THAT(log.text(), HasSubstr("code=OK"));
  EXPECT_THAT(log.text(), HasSubstr("the answer was not taken in time (--max-transfer-s)"));
  AwaitMetric(*loopback.server.metrics(), "fovea_untaken_answers_total", 1);
  context.TryCancel();
  grpc::Status status;
  call->Finish(&status, nullptr);
  wait();
}

TEST(SelfCheck, IsAnsweredThroughTheDoorAlsoWhereNoPlaceIsLeftAndTlsIsAskedFor) {
  const TemporaryFolder folder;
  for (const std::string address : {"127.0.0.1:0", "0.0.0.0:0", "[::]:0", ""}) {
    server::ServerOptions options = LoopbackOptions();
    options.insecure = true;
    options.max_connections = 1;
    options.listen.front() = address.empty() ? "unix:" + folder.At("s") : address;
    Loopback loopback(FindOne, options);
    loopback.client.Detect(TestRequest());
    std::promise<std::string> outcome;
    std::atomic<bool> said = false;
    const auto say = [&](const std::string& what) {
      if (!said.exchange(true)) outcome.set_value(what);
    };
    const server::SelfCheck check(loopback.server.door(), std::chrono::seconds{1},
                                  {.on_answer = [&] { say("answered"); }, .on_failure = say});
    EXPECT_EQ(outcome.get_future().get(), "answered") << address;
    EXPECT_TRUE(check.is_live());
  }
}

TEST(SelfCheck, SaysThatNoMoreFilesMayBeOpen) {
  Loopback loopback(FindOne);
  std::promise<std::string> why;
  std::unique_ptr<server::SelfCheck> check;
  {
    const FileLimit none(0);
    check = std::make_unique<server::SelfCheck>(
        loopback.server.door(), std::chrono::seconds{0},
        server::SelfCheck::Listener{
            .on_answer = [] {},
            .on_failure = [&](const std::string& what) { why.set_value(what); }});
    EXPECT_EQ(why.get_future().get(), "no socket: Too many open files");
  }
  check.reset();
}

}  // namespace
}  // namespace fovea::testing
