#include "server/access/credentials.h"

#include <grpcpp/security/tls_certificate_provider.h>
#include <grpcpp/security/tls_credentials_options.h>
#include <openssl/ssl.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>

#include "server/conversion/field_error.h"

namespace fovea::server {
namespace {

using SslContext = std::unique_ptr<SSL_CTX, decltype(&SSL_CTX_free)>;

// OpenSSL says "no certificate" of a file that is not there, too.
void RequireReadable(const char* flag, const std::string& path) {
  errno = 0;
  const std::ifstream file(path);
  RequireField(file.good(), flag, "cannot read " + path + ": " + std::strerror(errno));
}

// gRPC would only say so at each handshake.
void RequireUsable(const ServerOptions& options) {
  RequireReadable("--tls-cert", options.tls_cert);
  RequireReadable("--tls-key", options.tls_key);
  const SslContext context(SSL_CTX_new(TLS_server_method()), SSL_CTX_free);
  RequireField(SSL_CTX_use_certificate_chain_file(context.get(), options.tls_cert.c_str()) == 1,
               "--tls-cert", options.tls_cert + " holds no certificate in PEM");
  RequireField(
      SSL_CTX_use_PrivateKey_file(context.get(), options.tls_key.c_str(), SSL_FILETYPE_PEM) == 1 &&
          SSL_CTX_check_private_key(context.get()) == 1,
      "--tls-key", options.tls_key + " does not hold the key, in PEM, of " + options.tls_cert);
  if (options.tls_client_ca.empty()) return;
  RequireReadable("--tls-client-ca", options.tls_client_ca);
  RequireField(
      SSL_CTX_load_verify_locations(context.get(), options.tls_client_ca.c_str(), nullptr) == 1,
      "--tls-client-ca", options.tls_client_ca + " holds no certificate in PEM");
}

}  // namespace

std::shared_ptr<grpc::ServerCredentials> MakeCredentials(const ServerOptions& options) {
  if (options.tls_cert.empty()) return grpc::InsecureServerCredentials();
  RequireUsable(options);
  const auto files = std::make_shared<grpc::experimental::FileWatcherCertificateProvider>(
      options.tls_key, options.tls_cert, options.tls_client_ca,
      static_cast<unsigned int>(options.tls_reload_s));
  grpc::experimental::TlsServerCredentialsOptions tls(files);
  tls.watch_identity_key_cert_pairs();
  if (!options.tls_client_ca.empty()) {
    tls.watch_root_certs();
    tls.set_cert_request_type(GRPC_SSL_REQUEST_AND_REQUIRE_CLIENT_CERTIFICATE_AND_VERIFY);
  }
  return grpc::experimental::TlsServerCredentials(tls);
}

}  // namespace fovea::server
