// Certificates and lists of revoked ones that change while the server serves.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <stdexcept>
#include <string>

#include "server/access/certificates.h"
#include "server/access/client_authority.h"
#include "server/access/credentials.h"
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

std::chrono::sys_seconds ExpiryOf(const PemPair& pair) {
  return server::ExpiryOf(*server::CertificatesOf(pair.certificate).front());
}

double SecondsOf(std::chrono::sys_seconds time) {
  return static_cast<double>(time.time_since_epoch().count());
}

double ExpiryMetric(const Loopback& loopback) {
  return MetricValue(*loopback.server.metrics(), "fovea_certificate_expiry_timestamp_seconds");
}

class CertificateChanges : public ::testing::Test {
 protected:
  CertificateChanges() {
    WriteServer(authority_.Issue("server"));
    options_.tls_key = folder_.At("key.pem");
    options_.tls_cert = folder_.At("cert.pem");
    options_.tls_reload_s = 1;
  }

  void WriteServer(const PemPair& pair) const {
    folder_.Write("key.pem", pair.key);
    folder_.Write("cert.pem", pair.certificate);
  }
  void AskForClientCertificates() {
    options_.tls_client_ca = folder_.Write("clients.pem", clients_.Certificate());
  }
  void Revoke(const std::vector<std::string>& certificates, long due_s = 3600) {
    options_.tls_crl = folder_.Write("crl.pem", clients_.Revoke(certificates, due_s));
  }
  // Not read again by itself as long as a test lasts.
  void ReloadBySignalOnly() { options_.tls_reload_s = 86'400; }

  static ClientOptions Trusting(const Authority& authority, const PemPair& own = {}) {
    ClientOptions options = PatientOptions();
    options.tls = client::TlsOptions{.root_certificates = authority.Certificate(),
                                     .certificate_chain = own.certificate,
                                     .private_key = own.key};
    return options;
  }
  Client ClientOf(const Loopback& loopback, const PemPair& own) const {
    return Client(loopback.server.Address(), Trusting(authority_, own));
  }

  const TemporaryFolder folder_;
  const Authority authority_, clients_;
  server::ServerOptions options_ = LoopbackOptions();
};

TEST_F(CertificateChanges, ServesTheOldCertificateUntilTheNewKeyIsThere) {
  const CapturedLog log;
  const Loopback loopback(FindOne, options_);
  const auto serves = [&](const Authority& authority) {
    return StatusOfDetecting(Client(loopback.server.Address(), Trusting(authority))).ok();
  };
  const Authority other;
  const PemPair pair = other.Issue("renewed");
  folder_.Write("cert.pem", pair.certificate);
  log.Await("the certificates stay as they were: --tls-key: " + options_.tls_key);
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(serves(authority_));
  EXPECT_THAT(log.text(), Not(HasSubstr("CN=renewed")));

  folder_.Write("key.pem", pair.key);
  log.Await("subject \"CN=renewed\", serial number " +
            server::SerialOf(*server::CertificatesOf(pair.certificate).front()));
  while (!serves(other)) {
  }
  EXPECT_FALSE(serves(authority_));
  EXPECT_EQ(loopback.server.CertificateExpiry(), ExpiryOf(pair));
  EXPECT_EQ(ExpiryMetric(loopback), SecondsOf(ExpiryOf(pair)));
}

TEST_F(CertificateChanges, SaysWhenTheCertificateExpires) {
  const CapturedLog log;
  const Loopback loopback(FindOne, options_);
  const auto expiry =
      server::ExpiryOf(*server::CertificatesOf(authority_.Issue("another").certificate).front());
  ASSERT_TRUE(loopback.server.CertificateExpiry());
  EXPECT_LE(*loopback.server.CertificateExpiry(), expiry);
  log.Await("expires soon, at " + server::TextOf(*loopback.server.CertificateExpiry()));
  EXPECT_EQ(ExpiryMetric(loopback), SecondsOf(*loopback.server.CertificateExpiry()));
  const Loopback plain(FindOne);
  EXPECT_FALSE(plain.server.CertificateExpiry());
  EXPECT_EQ(ExpiryMetric(plain), 0) << "there is none without TLS";
}

TEST_F(CertificateChanges, SaysThatTheCertificateIsNotGoodYet) {
  const CapturedLog log;
  const PemPair pair = authority_.Issue("early", 3600);
  options_.tls_cert = folder_.Write("cert.pem", pair.certificate);
  options_.tls_key = folder_.Write("key.pem", pair.key);
  const Loopback loopback(FindOne, options_);
  log.Await("is good from " +
            server::TextOf(server::StartOf(*server::CertificatesOf(pair.certificate).front())) +
            " on, and this machine's clock says");
}

TEST_F(CertificateChanges, ABadFileChangesNothing) {
  ReloadBySignalOnly();
  options_.tokens = folder_.Write(
      "tokens", "kitchen a3ee786b5707c27d42570785081ec17f5c7db9262a01366af362a1aa61a420b9\n");
  Loopback loopback(FindOne, options_);
  ClientOptions robot = Trusting(authority_);
  robot.token = "let-me-in";
  folder_.Write("tokens", "# nobody\n");
  EXPECT_THAT([&] { loopback.server.ReloadAccess(); },
              ::testing::ThrowsMessage<std::invalid_argument>(
                  StartsWith("--tokens: " + options_.tokens + " holds 0 tokens")));
  folder_.Write("tokens",
                "hall a3ee786b5707c27d42570785081ec17f5c7db9262a01366af362a1aa61a420b9\n");
  folder_.Write("cert.pem", "-----BEGIN CERTIFICATE-----\nAAAA\n");
  EXPECT_THAT([&] { loopback.server.ReloadAccess(); },
              ::testing::ThrowsMessage<std::invalid_argument>(
                  StartsWith("--tls-cert: " + options_.tls_cert + " holds a damaged")));
  EXPECT_TRUE(StatusOfDetecting(Client(loopback.server.Address(), robot)).ok());
  const server::Metrics& metrics = *loopback.server.metrics();
  EXPECT_EQ(MetricValue(metrics, "fovea_robot_frames_received_total", "kitchen"), 1);
}

TEST_F(CertificateChanges, RevokedCertificatesEndTheirStreams) {
  ReloadBySignalOnly();
  AskForClientCertificates();
  const PemPair kitchen = clients_.Issue("kitchen"), hall = clients_.Issue("hall");
  Revoke({});
  Loopback loopback(FindOne, options_);
  const Client client = ClientOf(loopback, kitchen), other = ClientOf(loopback, hall);
  const auto stream = AnsweredStream(client), stays = AnsweredStream(other);

  Revoke({kitchen.certificate});
  loopback.server.ReloadAccess();
  const grpc::Status status = StatusOf([&] { stream->Receive(); });
  EXPECT_EQ(status.error_code(), grpc::StatusCode::UNAUTHENTICATED);
  EXPECT_EQ(status.error_message(), "the client certificate was revoked");
  EXPECT_EQ(StatusOfDetecting(client).error_code(), grpc::StatusCode::UNAUTHENTICATED);
  EXPECT_TRUE(StatusOfDetecting(other).ok());
  v1::DetectStreamRequest request;
  *request.mutable_frame() = TestFrame();
  EXPECT_TRUE(stays->Send(request));
  EXPECT_TRUE(stays->Receive());
  EXPECT_EQ(MetricValue(*loopback.server.metrics(), "fovea_refused_total", "UNAUTHENTICATED"), 2);
}

TEST_F(CertificateChanges, RevocationIsSeenWithoutASignal) {
  AskForClientCertificates();
  const PemPair kitchen = clients_.Issue("kitchen");
  Revoke({});
  const Loopback loopback(FindOne, options_);
  const Client client = ClientOf(loopback, kitchen);
  const auto stream = AnsweredStream(client);
  Revoke({kitchen.certificate});
  EXPECT_EQ(StatusOf([&] { stream->Receive(); }).error_message(),
            "the client certificate was revoked");
}

// One that reads before a list is there, and takes over what it read after another one took that.
TEST_F(CertificateChanges, WhoReadFirstDoesNotUndoARevocation) {
  AskForClientCertificates();
  const PemPair kitchen = clients_.Issue("kitchen");
  Revoke({});
  server::Credentials credentials(options_);
  server::GateKeeper gate_keeper("", credentials.authority());
  std::future<bool> second;
  credentials.Reload(gate_keeper, [&] {
    Revoke({kitchen.certificate});
    second = std::async(std::launch::async, [&] { return credentials.Reload(gate_keeper); });
    second.wait_for(std::chrono::milliseconds(500));  // which it is to outlast
  });
  EXPECT_TRUE(second.get());
  EXPECT_THAT([&] { credentials.authority()->GoodUntil(kitchen.certificate, kitchen.certificate); },
              ::testing::ThrowsMessage<std::runtime_error>(HasSubstr("revoked")));
}

TEST_F(CertificateChanges, WhatOthersThrowChangesNothing) {
  AskForClientCertificates();
  const PemPair kitchen = clients_.Issue("kitchen");
  Revoke({});
  server::Credentials credentials(options_);
  server::GateKeeper gate_keeper("", credentials.authority());
  Revoke({kitchen.certificate});
  const auto fail = [] { throw std::invalid_argument("of others"); };
  EXPECT_THROW(credentials.Reload(gate_keeper, fail), std::invalid_argument);
  EXPECT_NO_THROW(credentials.authority()->GoodUntil(kitchen.certificate, kitchen.certificate));
}

TEST_F(CertificateChanges, AnOverdueListIsHeededAndNamed) {
  const CapturedLog log;
  AskForClientCertificates();
  const PemPair kitchen = clients_.Issue("kitchen"), hall = clients_.Issue("hall");
  Revoke({kitchen.certificate}, /*due_s=*/-60);
  const Loopback loopback(FindOne, options_);
  EXPECT_EQ(StatusOfDetecting(ClientOf(loopback, kitchen)).error_message(),
            "the client certificate was revoked");
  EXPECT_TRUE(StatusOfDetecting(ClientOf(loopback, hall)).ok());
  log.Await("--tls-crl: " + options_.tls_crl + ": the list of CN=authority should have been");
}

TEST_F(CertificateChanges, AnotherAuthorityOfClientsEndsTheStreamsOfTheFirst) {
  ReloadBySignalOnly();
  AskForClientCertificates();
  Loopback loopback(FindOne, options_);
  const Client client = ClientOf(loopback, clients_.Issue("kitchen"));
  const auto stream = AnsweredStream(client);
  const Authority others;
  folder_.Write("clients.pem", others.Certificate());
  loopback.server.ReloadAccess();
  const grpc::Status status = StatusOf([&] { stream->Receive(); });
  EXPECT_EQ(status.error_code(), grpc::StatusCode::UNAUTHENTICATED);
  EXPECT_THAT(status.error_message(), StartsWith("the client certificate is not good"));
  const PemPair hall = others.Issue("hall");
  while (!StatusOfDetecting(ClientOf(loopback, hall)).ok()) {
  }
}

// As handshakes have it: what is signed by who has expired is good no more.
TEST(ClientAuthority, NoCertificateIsGoodForLongerThanThoseAboveIt) {
  const Authority authority(/*lifetime_s=*/600);
  const auto above = server::CertificatesOf(authority.Certificate());
  const PemPair robot = authority.Issue("kitchen");
  const auto until = server::ClientAuthority(above, {}).GoodUntil(robot.certificate, "");
  EXPECT_EQ(until, server::ExpiryOf(*above.front()));
  EXPECT_LT(until, ExpiryOf(robot));
}

TEST_F(CertificateChanges, ListsThatDoNotFitAreNamed) {
  AskForClientCertificates();
  const auto error_with = [&](const std::string& list) -> std::string {
    options_.tls_crl = folder_.Write("crl.pem", list);
    try {
      const server::Server server(options_, FindOne);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "none";
  };
  const std::string start = "--tls-crl: " + folder_.At("crl.pem") + " ";
  EXPECT_EQ(error_with(clients_.Revoke({})), "none");
  EXPECT_EQ(error_with("nothing"), start + "holds no revocation list in PEM");
  EXPECT_EQ(error_with(authority_.Revoke({})),
            start + "the list of CN=authority is signed by no authority of --tls-client-ca");
  options_.tls_client_ca =
      folder_.Write("clients.pem", clients_.Certificate() + Authority().Certificate());
  EXPECT_EQ(error_with(clients_.Revoke({})),
            start + "holds no list of CN=authority, an authority of --tls-client-ca");
  options_.tls_client_ca.clear();
  EXPECT_EQ(error_with(clients_.Revoke({})), "--tls-crl: needs --tls-client-ca");
}

}  // namespace
}  // namespace fovea::testing
