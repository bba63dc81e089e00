// What expires, and when that is said.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "server/access/certificates.h"
#include "server/access/credentials.h"
#include "tests/server/captured_log.h"
#include "tests/server/detectors.h"
#include "tests/server/loopback.h"
#include "tests/server/metric_value.h"
#include "tests/support/certificates.h"
#include "tests/support/temporary_folder.h"

namespace fovea::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::chrono::sys_seconds EndOf(const std::string& pem) {
  return server::ExpiryOf(*server::CertificatesOf(pem).front());
}

class Expiry : public ::testing::Test {
 protected:
  void UseTls(const PemPair& pair) {
    options_.tls_cert = folder_.Write("cert.pem", pair.certificate);
    options_.tls_key = folder_.Write("key.pem", pair.key);
  }

  const TemporaryFolder folder_;
  server::ServerOptions options_ = LoopbackOptions();
};

TEST_F(Expiry, OfTheAuthoritiesOfClientsIsSaid) {
  UseTls(Authority().Issue("server"));
  const Authority soon(600), late(-60), good(60 * kDay_s);
  options_.tls_client_ca =
      folder_.Write("clients.pem", soon.Certificate() + late.Certificate() + good.Certificate());
  const std::string of_soon = server::TextOf(EndOf(soon.Certificate())),
                    of_late = server::TextOf(EndOf(late.Certificate())),
                    of_good = server::TextOf(EndOf(good.Certificate()));
  server::Credentials credentials(options_);
  const std::string named =
      "authority of clients of " + options_.tls_client_ca + ": subject \"CN=authority\", serial";
  {
    const CapturedLog log;
    credentials.ForGrpc();
    EXPECT_THAT(log.text(), HasSubstr(named));
    EXPECT_THAT(log.text(), HasSubstr("good until " + of_soon));
    EXPECT_THAT(log.text(), HasSubstr("expired at " + of_late));
    EXPECT_THAT(log.text(), HasSubstr("good until " + of_good));
  }
  const CapturedLog log;
  credentials.WarnOfWhatIsDue();
  const std::string start =
      "--tls-client-ca: the authority CN=authority of " + options_.tls_client_ca;
  EXPECT_THAT(log.text(), HasSubstr(start + " expires soon, at " + of_soon));
  EXPECT_THAT(log.text(), HasSubstr(start + " has expired at " + of_late));
  EXPECT_THAT(log.text(), Not(HasSubstr(of_good)));
}

TEST_F(Expiry, OfTheFirstAuthorityOfClientsIsAMetric) {
  UseTls(Authority().Issue("server"));
  const auto metric_of = [&] {
    const Loopback loopback(FindOne, options_);
    return MetricValue(*loopback.server.metrics(),
                       "fovea_client_authority_expiry_timestamp_seconds");
  };
  EXPECT_EQ(metric_of(), 0) << "clients need no certificates";
  const Authority first(600), second;
  options_.tls_client_ca = folder_.Write("clients.pem", second.Certificate() + first.Certificate());
  EXPECT_EQ(metric_of(),
            static_cast<double>(EndOf(first.Certificate()).time_since_epoch().count()));
}

}  // namespace
}  // namespace fovea::testing
