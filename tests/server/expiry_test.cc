// What expires, and when that is said.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spdlog/fmt/fmt.h>

#include <chrono>
#include <stdexcept>
#include <string>

#include "server/access/certificates.h"
#include "server/access/credentials.h"
#include "server/access/gate_keeper.h"
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

// Lines of tokens, each with another hash; "" = without an end.
std::string LineOf(const std::string& name, const std::string& rest = "") {
  static int number = 0;
  return fmt::format("{} {:064x}{}\n", name, ++number, rest.empty() ? "" : " " + rest);
}

TEST_F(Expiry, OfTokensIsSaidByName) {
  const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
  const std::string soon = server::TextOf(now + std::chrono::days(10)),
                    later = server::TextOf(now + std::chrono::days(20));
  const std::string gone = "2020-01-01T00:00:00Z";
  options_.tokens =
      folder_.Write("tokens", LineOf("emil") + LineOf("dora", soon) + LineOf("carl", later) +
                                  LineOf("bert", gone) + LineOf("anna", gone));
  options_.observers =
      folder_.Write("observers", LineOf("olga", "view * " + gone) + LineOf("otto", "view *"));
  const CapturedLog log;
  Loopback loopback(FindOne, options_);
  const std::string tokens = "warning] --tokens: " + options_.tokens + " holds ",
                    observers = "warning] --observers: " + options_.observers + " holds ";
  log.Await(observers + "2 tokens; expired: olga");
  EXPECT_THAT(log.text(),
              HasSubstr(tokens + "5 tokens; expired: anna, bert; within 14 days: dora"));
  folder_.Write("tokens", LineOf("emil"));
  folder_.Write("observers", LineOf("otto", "view *"));
  loopback.server.ReloadAccess();
  EXPECT_THAT(log.text(), HasSubstr("info] --tokens: " + options_.tokens + " holds 1 token\n"));
  EXPECT_THAT(log.text(), HasSubstr("--observers: " + options_.observers + " holds 1 token\n"));
}

TEST_F(Expiry, OfAllTokensIsAsIfThereWereNone) {
  options_.tokens = folder_.Write("tokens", LineOf("anna"));
  server::GateKeeper keeper(options_.tokens);
  EXPECT_FALSE(keeper.RefusesEverybody());
  folder_.Write("tokens", LineOf("anna", "2020-01-01T00:00:00Z"));
  EXPECT_THAT([&] { keeper.Reload(); },
              ::testing::ThrowsMessage<std::invalid_argument>(
                  HasSubstr("holds 0 tokens that have not expired: nobody could call")));
  EXPECT_FALSE(keeper.RefusesEverybody());
  EXPECT_TRUE(server::GateKeeper(options_.tokens).RefusesEverybody());
}

}  // namespace
}  // namespace fovea::testing
