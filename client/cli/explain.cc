#include "client/cli/explain.h"

#include <string>

namespace fovea::cli {
namespace {

bool Has(const client::RpcError& error, const char* text) {
  return error.message().find(text) != std::string::npos;
}

// The texts are those of gRPC 1.51 and OpenSSL 3; others get the last answer.
std::string WhyUnavailable(const client::RpcError& error, const ConnectionFlags& flags) {
  if (Has(error, "Socket closed") && flags.tls_ca.empty()) {
    return flags.server + " closes the connection; does the server want TLS (--tls-ca)?";
  }
  if (Has(error, "Socket closed") && flags.tls_cert.empty()) {
    return flags.server + " closes the connection; does the server want a certificate " +
           "(--tls-cert and --tls-key)?";
  }
  if (Has(error, "wrong version number")) {
    return flags.server + " does not speak TLS; leave --tls-ca out?";
  }
  if (Has(error, "Failed parsing HTTP/2") || Has(error, "missing selected ALPN")) {
    return "what answers at " + flags.server + " is no fovea-server";
  }
  if (Has(error, "certificate verify failed")) {
    return "--tls-ca: " + flags.tls_ca + " does not certify the server at " + flags.server;
  }
  if (Has(error, "is not in peer certificate")) {
    return "the certificate of the server at " + flags.server +
           " is for other names; call it by one of them";
  }
  if (Has(error, "empty address list") && !flags.tls_cert.empty()) {
    return "--tls-key: " + flags.tls_key + " does not hold the key, in PEM, of " + flags.tls_cert +
           "?";
  }
  return "no server answers at " + flags.server + "; is fovea-server running there?";
}

}  // namespace

std::string Explain(const client::RpcError& error, const ConnectionFlags& flags,
                    const std::string& limit) {
  switch (error.code()) {
    case grpc::StatusCode::UNAVAILABLE:
      return WhyUnavailable(error, flags) + " (" + error.message() + ")";
    case grpc::StatusCode::DEADLINE_EXCEEDED:
      return "DEADLINE_EXCEEDED: no answer from " + flags.server + " within " + limit;
    case grpc::StatusCode::UNAUTHENTICATED:
      return std::string(error.what()) + (flags.token_file.empty()
                                              ? "; give it with --token-file"
                                              : " (--token-file " + flags.token_file + ")");
    case grpc::StatusCode::UNIMPLEMENTED:
      return std::string(error.what()) + "; is a fovea-server of this version at " + flags.server +
             "?";
    default:
      return error.what();
  }
}

std::string DefaultLimit() {
  return std::to_string(client::ClientOptions{}.timeout.count() / 1000) + " s";
}

}  // namespace fovea::cli
