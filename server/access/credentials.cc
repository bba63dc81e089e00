#include "server/access/credentials.h"

#include <grpcpp/security/tls_certificate_provider.h>
#include <grpcpp/security/tls_credentials_options.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <utility>

#include "server/access/wall_clock.h"

namespace fovea::server {
namespace {

// Key and chain in one, so that they change at once: readers of PEM skip what they do not look for.
std::string IdentityOf(const TlsFiles& files) { return files.key + "\n" + files.certificate; }

// `what`: "certificate of FILE".
void LogCertificate(const std::string& what, const X509& certificate) {
  const std::chrono::sys_seconds expiry = ExpiryOf(certificate);
  spdlog::info("{}: subject \"{}\", serial number {}, {} {}", what, SubjectOf(certificate),
               SerialOf(certificate), expiry < NowInSeconds() ? "expired at" : "good until",
               TextOf(expiry));
}

void LogServer(const ServerOptions& options, const TlsFiles& files) {
  LogCertificate("certificate of " + options.tls_cert, *files.leaf);
}

void LogAuthorities(const ServerOptions& options, const TlsFiles& files) {
  for (const Certificate& authority : files.authority->authorities()) {
    LogCertificate("authority of clients of " + options.tls_client_ca, *authority);
  }
}

// `what`: "--tls-cert: the certificate of FILE".
void WarnOfTimesOf(const std::string& what, const X509& certificate) {
  constexpr std::chrono::days kSoon{14};
  const std::chrono::sys_seconds start = StartOf(certificate), expiry = ExpiryOf(certificate);
  const std::chrono::sys_seconds now = NowInSeconds();
  if (now < start) {
    spdlog::warn("{} is good from {} on, and this machine's clock says {}", what, TextOf(start),
                 TextOf(now));
  }
  if (expiry < now + kSoon) {
    spdlog::warn("{} {} {}", what, expiry < now ? "has expired at" : "expires soon, at",
                 TextOf(expiry));
  }
}

}  // namespace

Credentials::Credentials(const ServerOptions& options) : options_(options) {
  if (!has_tls()) return;
  files_ = ReadTlsFiles(options_);
  identity_ = std::make_unique<PublishedFile>(IdentityOf(files_));
  if (files_.authority) authorities_ = std::make_unique<PublishedFile>(files_.client_ca);
}

Credentials::~Credentials() = default;

std::shared_ptr<grpc::ServerCredentials> Credentials::ForGrpc() {
  if (!has_tls()) return grpc::InsecureServerCredentials();
  LogServer(options_, files());
  if (authorities_) LogAuthorities(options_, files());
  constexpr unsigned int kPeriodS = 1;
  const auto watcher = std::make_shared<grpc::experimental::FileWatcherCertificateProvider>(
      identity_->path(), identity_->path(), authorities_ ? authorities_->path() : "", kPeriodS);
  grpc::experimental::TlsServerCredentialsOptions tls(watcher);
  tls.watch_identity_key_cert_pairs();
  if (authorities_) {
    tls.watch_root_certs();
    tls.set_cert_request_type(GRPC_SSL_REQUEST_AND_REQUIRE_CLIENT_CERTIFICATE_AND_VERIFY);
  }
  return grpc::experimental::TlsServerCredentials(tls);
}

bool Credentials::Reload(GateKeeper& gate_keeper, const std::function<void()>& others) {
  const std::lock_guard lock(reloading_);
  TlsFiles read;
  if (has_tls()) read = ReadTlsFiles(options_);
  if (others) others();
  if (!has_tls() || !TakeOver(std::move(read))) return false;
  gate_keeper.SetAuthority(authority());
  return true;
}

bool Credentials::TakeOver(TlsFiles read) {
  const std::lock_guard lock(mutex_);
  if (read.IsSameAs(files_)) return false;
  if (IdentityOf(read) != IdentityOf(files_)) {
    identity_->Replace(IdentityOf(read));
    LogServer(options_, read);
  }
  if (read.client_ca != files_.client_ca) {
    authorities_->Replace(read.client_ca);
    LogAuthorities(options_, read);
  }
  if (read.revoked != files_.revoked) {
    spdlog::info("revoked certificates taken over from {}", options_.tls_crl);
  }
  files_ = std::move(read);
  return true;
}

std::shared_ptr<const ClientAuthority> Credentials::authority() const { return files().authority; }

std::optional<std::chrono::sys_seconds> Credentials::Expiry() const {
  if (!has_tls()) return std::nullopt;
  return ExpiryOf(*files().leaf);
}

std::optional<std::chrono::sys_seconds> Credentials::AuthorityExpiry() const {
  const auto authority = this->authority();
  if (!authority) return std::nullopt;
  std::chrono::sys_seconds first = std::chrono::sys_seconds::max();
  for (const Certificate& one : authority->authorities()) first = std::min(first, ExpiryOf(*one));
  return first;
}

void Credentials::WarnOfWhatIsDue() const {
  if (!has_tls()) return;
  const TlsFiles files = this->files();
  WarnOfTimesOf("--tls-cert: the certificate of " + options_.tls_cert, *files.leaf);
  if (!files.authority) return;
  for (const Certificate& authority : files.authority->authorities()) {
    WarnOfTimesOf(
        "--tls-client-ca: the authority " + SubjectOf(*authority) + " of " + options_.tls_client_ca,
        *authority);
  }
  for (const std::string& list : files.authority->OverdueLists(NowInSeconds())) {
    spdlog::warn("--tls-crl: {}: {}; what it revokes stays revoked", options_.tls_crl, list);
  }
}

TlsFiles Credentials::files() const {
  const std::lock_guard lock(mutex_);
  return files_;
}

}  // namespace fovea::server
