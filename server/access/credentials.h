#pragma once

#include <grpcpp/security/server_credentials.h>

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "server/access/gate_keeper.h"
#include "server/access/published_file.h"
#include "server/access/tls_files.h"
#include "server/server_options.h"

namespace fovea::server {

// TLS where certificate and key are given, mutual TLS where the clients' authority is too, else
// none. gRPC 1.51 reads files again by itself, but takes them over whether they fit together or
// not, and says nothing: so it gets files of ours, which hold what was found to fit. Thread-safe.
class Credentials {
 public:
  // Throws std::invalid_argument that names flag and file where they cannot be used.
  explicit Credentials(const ServerOptions& options);
  ~Credentials();

  Credentials(const Credentials&) = delete;
  Credentials& operator=(const Credentials&) = delete;

  // For whoever listens. `this` must outlive them.
  std::shared_ptr<grpc::ServerCredentials> ForGrpc();

  bool has_tls() const { return !options_.tls_cert.empty(); }

  // Takes over what the files hold now, which new connections see within a second, and has
  // `gate_keeper` go by it. Whether it is something new; the log tells what. Throws like the
  // constructor, and changes nothing then. Once the files are read it calls `others`, which may
  // throw and so have nothing changed, too. Of several that reload at once the last one to read is
  // the last one to take over.
  bool Reload(GateKeeper& gate_keeper, const std::function<void()>& others = {});

  // Null where clients need no certificates.
  std::shared_ptr<const ClientAuthority> authority() const;

  // When the server's certificate expires; none without TLS.
  std::optional<std::chrono::sys_seconds> Expiry() const;

  // When the first of the authorities of clients does; none where clients need no certificates.
  std::optional<std::chrono::sys_seconds> AuthorityExpiry() const;

  // Says in the log what is due: a certificate or an authority of clients that expires within two
  // weeks, lists of revoked ones that should have been replaced.
  void WarnOfWhatIsDue() const;

 private:
  TlsFiles files() const;

  bool TakeOver(TlsFiles read);

  const ServerOptions options_;
  std::mutex reloading_;  // held by whoever reads and takes over
  mutable std::mutex mutex_;
  TlsFiles files_;
  std::unique_ptr<PublishedFile> identity_, authorities_;  // what gRPC watches
};

}  // namespace fovea::server
