// TLS, mutual TLS and tokens over real connections.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <string>

#include "server/access/token_table.h"
#include "tests/server/captured_log.h"
#include "tests/server/detectors.h"
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
using ::testing::Not;
using ::testing::StartsWith;
using ::testing::ThrowsMessage;

ClientOptions With(const std::string& token) {
  ClientOptions options = PatientOptions();
  options.token = token;
  return options;
}

grpc::StatusCode CodeOf(const Client& client) { return StatusOfDetecting(client).error_code(); }

class Tls : public ::testing::Test {
 protected:
  Tls() { WriteServerFiles(authority_); }

  void WriteServerFiles(const Authority& authority) {
    const PemPair pair = authority.Issue("server");
    options_.tls_key = folder_.Write("key.pem", pair.key);
    options_.tls_cert = folder_.Write("cert.pem", pair.certificate);
  }

  void AskForClientCertificates() {
    options_.tls_client_ca = folder_.Write("clients.pem", clients_.Certificate());
  }

  static ClientOptions Trusting(const Authority& authority, const PemPair& own = {}) {
    ClientOptions options = PatientOptions();
    options.tls = client::TlsOptions{.root_certificates = authority.Certificate(),
                                     .certificate_chain = own.certificate,
                                     .private_key = own.key};
    return options;
  }

  const TemporaryFolder folder_;
  const Authority authority_, clients_;
  server::ServerOptions options_ = LoopbackOptions();
};

TEST_F(Tls, ServesThoseWhoTrustIt) {
  const Loopback loopback(FindOne, options_);
  EXPECT_EQ(CodeOf(Client(loopback.server.Address(), Trusting(authority_))), grpc::StatusCode::OK);
  EXPECT_EQ(CodeOf(Client(loopback.server.Address(), Trusting(clients_))),
            grpc::StatusCode::UNAVAILABLE);
  EXPECT_EQ(CodeOf(loopback.client), grpc::StatusCode::UNAVAILABLE);  // in plain text
}

TEST_F(Tls, KnowsRobotsByTheirCertificates) {
  AskForClientCertificates();
  const Loopback loopback(FindOne, options_);
  ClientOptions robot = Trusting(authority_, clients_.Issue("kitchen"));
  robot.robot = "somebody-else";
  EXPECT_EQ(CodeOf(Client(loopback.server.Address(), robot)), grpc::StatusCode::OK);
  EXPECT_EQ(MetricValue(*loopback.server.metrics(), "fovea_robot_frames_received_total", "kitchen"),
            1);
  for (const PemPair& wrong : {PemPair{}, authority_.Issue("kitchen")}) {
    EXPECT_EQ(CodeOf(Client(loopback.server.Address(), Trusting(authority_, wrong))),
              grpc::StatusCode::UNAVAILABLE);
  }
}

TEST_F(Tls, TakesOverNewCertificates) {
  options_.tls_reload_s = 1;
  const Loopback loopback(FindOne, options_);
  const Authority other;
  WriteServerFiles(other);
  // Each client makes a connection of its own; only the new certificate satisfies it.
  while (CodeOf(Client(loopback.server.Address(), Trusting(other))) != grpc::StatusCode::OK) {
  }
}

TEST_F(Tls, RefusesFilesThatCannotBeUsed) {
  const auto error_of = [&](auto change) {
    server::ServerOptions options = options_;
    change(options);
    try {
      const server::Server server(options, FindOne);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  EXPECT_EQ(error_of([](auto&) {}), "none");
  EXPECT_THAT(error_of([](auto& o) { o.tls_key = ""; }), StartsWith("--tls-cert and --tls-key:"));
  EXPECT_THAT(error_of([](auto& o) { o.tls_cert = "/nowhere"; }),
              StartsWith("--tls-cert: cannot read /nowhere: No such file"));
  EXPECT_THAT(error_of([&](auto& o) { o.tls_cert = o.tls_key; }),
              HasSubstr("holds no certificate"));
  const std::string other_key = folder_.Write("other.pem", authority_.Issue("other").key);
  EXPECT_THAT(error_of([&](auto& o) { o.tls_key = other_key; }),
              StartsWith("--tls-key: " + other_key + " does not hold the key"));
  const PemPair locked = authority_.IssueWithPassword("locked");
  EXPECT_THAT(error_of([&](auto& o) {
                o.tls_cert = folder_.Write("locked.pem", locked.certificate);
                o.tls_key = folder_.Write("locked.key", locked.key);
              }),
              StartsWith("--tls-key: " + folder_.At("locked.key") + " needs a password"));
  const PemPair weak = authority_.IssueWithShortKey("weak");
  EXPECT_THAT(error_of([&](auto& o) {
                o.tls_cert = folder_.Write("weak.pem", weak.certificate);
                o.tls_key = folder_.Write("weak.key", weak.key);
              }),
              StartsWith("--tls-cert: " + folder_.At("weak.pem") +
                         " is too weak, or nothing for servers: ee key too small"));
  EXPECT_THAT(error_of([](auto& o) { o.tls_key = "/"; }),
              StartsWith("--tls-key: cannot read /: Is a directory"));
  EXPECT_THAT(error_of([](auto& o) { o.tls_client_ca = "/nowhere"; }),
              StartsWith("--tls-client-ca: cannot read /nowhere"));
}

TEST(Protection, IsNeededBeyondLoopback) {
  const auto error_of = [](auto change) -> std::string {
    server::ServerOptions options;
    options.listen = {"0.0.0.0:0"};
    change(options);
    try {
      Validate(options);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "valid";
  };
  const auto tls = [](auto& o) { o.tls_cert = o.tls_key = "file"; };
  EXPECT_THAT(error_of([](auto&) {}), StartsWith("--listen: \"0.0.0.0:0\" is open to other"));
  EXPECT_THAT(error_of([](auto& o) { o.tokens = "file"; }), StartsWith("--listen: "));
  EXPECT_THAT(error_of(tls), StartsWith("--listen: "));
  EXPECT_EQ(error_of([](auto& o) { o.insecure = true; }), "valid");
  EXPECT_EQ(error_of([&](auto& o) { tls(o), o.tokens = "file"; }), "valid");
  EXPECT_EQ(error_of([&](auto& o) { tls(o), o.tls_client_ca = "file"; }), "valid");
  for (const char* local : {"127.0.0.1:1", "127.0.0.2:1", "localhost:1", "[::1]:1"}) {
    EXPECT_EQ(error_of([&](auto& o) { o.listen = {local}; }), "valid") << local;
  }
}

class Tokens : public ::testing::Test {
 protected:
  Tokens() { options_.tokens = folder_.Write("tokens", LineOf("kitchen", "let-me-in")); }

  // As `printf %s TOKEN | sha256sum` prints it.
  static std::string HashOf(const std::string& token) {
    if (token == "let-me-in") {
      return "a3ee786b5707c27d42570785081ec17f5c7db9262a01366af362a1aa61a420b9";
    }
    return "d9298a10d1b0735837dc4bd85dac641b0f3cef27a47e5d53a54f2f3f5b2fcffa";  // of "other"
  }
  static std::string LineOf(const std::string& robot, const std::string& token,
                            const std::string& expires = "") {
    return robot + " " + HashOf(token) + " " + expires + "\n";
  }

  const TemporaryFolder folder_;
  server::ServerOptions options_ = LoopbackOptions();
};

TEST_F(Tokens, LetInWhoHasOne) {
  const Loopback loopback(FindOne, options_);
  ClientOptions robot = With("let-me-in");
  robot.robot = "somebody-else";
  const Client kitchen(loopback.server.Address(), robot);
  EXPECT_EQ(CodeOf(kitchen), grpc::StatusCode::OK);
  EXPECT_NO_THROW(kitchen.GetStatistics());
  EXPECT_EQ(MetricValue(*loopback.server.metrics(), "fovea_robot_frames_received_total", "kitchen"),
            1);
}

TEST_F(Tokens, KeepOutWhoHasNone) {
  const Loopback loopback(FindOne, options_);
  for (const std::string token : {"", "let-me-out", "let-me-in ", "LET-ME-IN"}) {
    const Client client(loopback.server.Address(), With(token));
    EXPECT_EQ(CodeOf(client), grpc::StatusCode::UNAUTHENTICATED) << token;
    const auto unauthenticated = [](auto call) {
      return StatusOf(call).error_code() == grpc::StatusCode::UNAUTHENTICATED;
    };
    EXPECT_TRUE(unauthenticated([&] { client.GetServerInfo(); }));
    EXPECT_TRUE(unauthenticated([&] { client.GetStatistics(); }));
    EXPECT_TRUE(unauthenticated([&] { client.OpenStream(kPatience)->Receive(); }));
    EXPECT_TRUE(client.IsServing());  // probes have no token
  }
  const server::Metrics& metrics = *loopback.server.metrics();
  EXPECT_EQ(MetricValue(metrics, "fovea_frames_received_total"), 0);
  // A call and a stream with each token.
  EXPECT_EQ(MetricValue(metrics, "fovea_refused_total", "UNAUTHENTICATED"), 8);
}

TEST_F(Tokens, WhoHasNoneFindsItsLineInTheLog) {
  const Loopback loopback(FindOne, options_);
  const Client client(loopback.server.Address(), With("let-me-out"));
  const CapturedLog log;
  StatusOf([&] { client.Detect(TestRequest(), {.request_id = "my-call"}); });
  log.Await(
      "request=\"my-call\" robot=\"\" frame=\"\" code=UNAUTHENTICATED peer=\"ipv4:127.0.0.1:");
  try {
    client.OpenStream(kPatience)->Receive();
    FAIL() << "the stream was let in";
  } catch (const client::RpcError& error) {
    EXPECT_FALSE(error.request_id().empty());
    log.Await("stream request=\"" + error.request_id() + "\" robot=\"\" code=UNAUTHENTICATED" +
              " peer=\"ipv4:127.0.0.1:");
  }
}

TEST_F(Tokens, Expire) {
  folder_.Write("tokens", LineOf("kitchen", "let-me-in", "2020-01-31T12:00:00Z") +
                              LineOf("hall", "other", "2999-01-31T12:00:00Z"));
  const Loopback loopback(FindOne, options_);
  const grpc::Status status =
      StatusOf([&] { Client(loopback.server.Address(), With("let-me-in")).Detect(TestRequest()); });
  EXPECT_EQ(status.error_code(), grpc::StatusCode::UNAUTHENTICATED);
  EXPECT_EQ(status.error_message(), "the token has expired");
  EXPECT_EQ(CodeOf(Client(loopback.server.Address(), With("other"))), grpc::StatusCode::OK);
}

TEST_F(Tokens, StayWhereTheFileOfObserversHasAMistake) {
  options_.observers = folder_.Write("observers", "");
  Loopback loopback(FindOne, options_);
  const Client kitchen(loopback.server.Address(), With("let-me-in"));
  folder_.Write("tokens", LineOf("hall", "other"));
  folder_.Write("observers", "ann");
  EXPECT_THROW(loopback.server.ReloadAccess(), std::invalid_argument);
  EXPECT_EQ(CodeOf(kitchen), grpc::StatusCode::OK);
}

TEST_F(Tokens, AreNotRepeatedWhereTheyStandInPlaceOfTheirHash) {
  const std::string hash = HashOf("let-me-in");
  for (const std::string& line :
       {std::string("kitchen let-me-in"), "kitchen " + hash + " let-me-in",
        "kitchen " + hash + " 2999-01-31T12:00:00Z let-me-in"}) {
    const std::string path = folder_.Write("bad", line);
    EXPECT_THAT([&] { server::TokenTable::FromFile(path); },
                ThrowsMessage<std::invalid_argument>(Not(HasSubstr("let-me-in"))));
  }
}

TEST_F(Tokens, HashesMayHaveCapitals) {
  std::string hash = HashOf("let-me-in");
  std::ranges::transform(hash, hash.begin(), [](unsigned char c) { return std::toupper(c); });
  const auto table = server::TokenTable::FromFile(folder_.Write("capitals", "kitchen " + hash));
  EXPECT_EQ(table.EntryOf("let-me-in", {}).robot, "kitchen");
  EXPECT_THAT(
      [&] {
        server::TokenTable::FromFile(
            folder_.Write("twice", "kitchen " + hash + "\nhall " + HashOf("let-me-in")));
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr(":2: the token: is there twice")));
}

TEST_F(Tokens, FileMistakesAreNamed) {
  const std::string good = HashOf("let-me-in");
  const std::vector<std::pair<std::string, std::string>> cases{
      {"kitchen", ":1: the hash: is not a SHA-256"},
      {"# fine\nkitchen abc", ":2: the hash: is not a SHA-256"},
      {"kitchen " + std::string(64, 'g'),
       ":1: the hash: is not a SHA-256 in 64 hexadecimal digits; it has other characters, too"},
      {"my robot " + good, ":1: the name: has a blank; it must be one word"},
      {"my old robot " + good + " 2999-01-31T12:00:00Z", ":1: the name: has a blank"},
      {"kitchen " + good + " tomorrow", ":1: when it expires: is not a time"},
      {"kitchen " + good + " 2999-01-31T12:00:00Z more", ":1: the fourth word: is too much"},
      {"kitchen " + good + "\nhall " + good, ":2: the token: is there twice"},
      {std::string(65, 'x') + " " + good, ":1: the robot's name"},
      {"k\xFC" + (" " + good), ":1: the robot's name: is no UTF-8"}};
  for (const auto& [text, error] : cases) {
    const std::string path = folder_.Write("bad", text);
    const std::string start = std::string("--tokens: ").append(path).append(error);
    EXPECT_THAT([&] { server::TokenTable::FromFile(path); },
                ThrowsMessage<std::invalid_argument>(StartsWith(start)));
  }
}

}  // namespace
}  // namespace fovea::testing
