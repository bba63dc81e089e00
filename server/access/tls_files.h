#pragma once

#include <memory>
#include <string>

#include "server/access/client_authority.h"
#include "server/server_options.h"

namespace fovea::server {

// What the files of --tls-cert, --tls-key, --tls-client-ca and --tls-crl hold, as it fits together.
struct TlsFiles {
  std::string certificate, key, client_ca, revoked;  // as read; empty where there is no such flag
  Certificate leaf;                                  // the first of `certificate`
  std::shared_ptr<const ClientAuthority> authority;  // null without --tls-client-ca

  bool IsSameAs(const TlsFiles& other) const;
};

// Needs --tls-cert. Throws std::invalid_argument that names flag and file where one cannot be read
// or does not fit the others.
TlsFiles ReadTlsFiles(const ServerOptions& options);

}  // namespace fovea::server
