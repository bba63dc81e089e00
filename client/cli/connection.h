// How the command line reaches its server.
#pragma once

#include <string>

#include "client/client.h"

namespace CLI {
class App;
}

namespace fovea::cli {

struct ConnectionFlags {
  std::string server = "127.0.0.1:50051";
  std::string tls_ca, tls_cert, tls_key, token_file, robot;
};

void AddConnectionFlags(CLI::App& command, ConnectionFlags& flags);
// Those alone that say where the server is and how to encrypt.
void AddServerFlags(CLI::App& command, ConnectionFlags& flags);

// The first line of the file that `flag` names. Throws std::exception that names both where it
// cannot be read, or holds no token.
std::string ReadToken(const std::string& flag, const std::string& path);

// `options` with token, robot and TLS from the flags. Throws std::exception that names the flag for
// files that cannot be read or hold something else.
client::ClientOptions OptionsOf(const ConnectionFlags& flags, client::ClientOptions options = {});

// Throws std::exception that names the flag for an address that is none and for files that cannot
// be read or hold something else. Token, robot and TLS of `options` come from the flags.
client::Client Connect(const ConnectionFlags& flags, client::ClientOptions options = {});

}  // namespace fovea::cli
