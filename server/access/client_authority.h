#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

#include "server/access/certificates.h"

namespace fovea::server {

// Whose certificates clients must have, and which of these were revoked. gRPC checks certificates
// as they are at the handshake; this is for what changes thereafter, and for revocation. Never
// changes but for what it remembers; thread-safe.
class ClientAuthority {
 public:
  // `lists` may be empty: then nothing is revoked. Else each must be signed by one of the
  // authorities, and each authority that signed itself must have one. Throws std::invalid_argument,
  // without a path.
  ClientAuthority(std::vector<Certificate> authorities, std::vector<RevocationList> lists);

  const std::vector<Certificate>& authorities() const { return authorities_; }

  // Until when the certificate, and all above it, are good. `certificate` and `chain` (what leads
  // to the authority) are in PEM. Throws std::runtime_error that says why it is not. Costs 0.1 to
  // 0.3 ms the first time.
  std::chrono::sys_seconds GoodUntil(const std::string& certificate,
                                     const std::string& chain) const;

  // Those whose next issue is overdue: what they revoke stays revoked, what was revoked since is
  // not known. One text each.
  std::vector<std::string> OverdueLists(std::chrono::sys_seconds now) const;

 private:
  std::chrono::sys_seconds Verify(const std::string& certificate, const std::string& chain) const;

  const std::vector<Certificate> authorities_;
  const std::vector<RevocationList> lists_;
  const std::shared_ptr<X509_STORE> store_;
  mutable std::mutex mutex_;
  mutable std::map<std::string, std::chrono::sys_seconds> good_;  // bounded
};

}  // namespace fovea::server
