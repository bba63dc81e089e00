#pragma once

#include <grpcpp/security/server_credentials.h>

#include <memory>

#include "server/server_options.h"

namespace fovea::server {

// TLS where certificate and key are given, mutual TLS where the clients' authority is too, else
// none. The files are read again every options.tls_reload_s; ones that do not fit are not taken.
// Throws std::invalid_argument that names flag and file where they cannot be used.
std::shared_ptr<grpc::ServerCredentials> MakeCredentials(const ServerOptions& options);

}  // namespace fovea::server
