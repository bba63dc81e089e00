#include "client/cli/connection.h"

#include "client/cli/files.h"

namespace fovea::cli {
namespace {

std::string ReadIfGiven(const std::string& path) { return path.empty() ? "" : ReadFile(path); }

std::string FirstLine(const std::string& text) {
  return text.substr(0, text.find_first_of("\r\n"));
}

}  // namespace

void AddConnectionFlags(CLI::App& command, ConnectionFlags& flags) {
  const char* group = "Server";
  command.add_option("--server", flags.server, "Address of the server, HOST:PORT")
      ->type_name("HOST:PORT")
      ->capture_default_str()
      ->group(group);
  const auto add_file = [&](const char* flag, std::string& path, const char* help) {
    return command.add_option(flag, path, help)->type_name("FILE")->group(group);
  };
  CLI::Option* ca =
      add_file("--tls-ca", flags.tls_ca, "Encrypt, and trust the authority in this PEM file");
  CLI::Option* cert = add_file("--tls-cert", flags.tls_cert, "Certificate to show, PEM");
  CLI::Option* key = add_file("--tls-key", flags.tls_key, "Its private key, PEM");
  cert->needs(ca)->needs(key);
  key->needs(cert);
  add_file("--token-file", flags.token_file, "File whose first line is the token to send");
  command.add_option("--robot", flags.robot, "Name of this robot")->type_name("NAME")->group(group);
}

client::Client Connect(const ConnectionFlags& flags, client::ClientOptions options) {
  options.token = FirstLine(ReadIfGiven(flags.token_file));
  options.robot = flags.robot;
  if (!flags.tls_ca.empty()) {
    options.tls = client::TlsOptions{.root_certificates = ReadFile(flags.tls_ca),
                                     .certificate_chain = ReadIfGiven(flags.tls_cert),
                                     .private_key = ReadIfGiven(flags.tls_key)};
  }
  return client::Client(flags.server, options);
}

// gRPC's text about a server that is away names neither the cause nor a remedy.
std::string Explain(const client::RpcError& error, const std::string& server) {
  if (error.code() != grpc::StatusCode::UNAVAILABLE) return error.what();
  return "no server answers at " + server + "; is fovea-server running there? (" + error.message() +
         ")";
}

}  // namespace fovea::cli
