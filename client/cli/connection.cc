#include "client/cli/connection.h"

#include <CLI/App.hpp>
#include <stdexcept>
#include <utility>

#include "client/cli/files.h"
#include "client/cli/server_address.h"

namespace fovea::cli {
namespace {

constexpr const char* kGroup = "Server";

CLI::Option* AddFile(CLI::App& command, const char* flag, std::string& path, const char* help) {
  return command.add_option(flag, path, help)->type_name("FILE")->group(kGroup);
}

// gRPC takes any text and fails at each call, without a word about the file.
std::string ReadPem(const char* flag, const std::string& path, const char* kind) {
  if (path.empty()) return {};
  std::string text = ReadFlagFile(flag, path);
  if (text.find(std::string(kind) + "-----") != std::string::npos) return text;
  throw std::invalid_argument(std::string(flag) + ": " + path + " holds no " + kind + " in PEM");
}

}  // namespace

void AddServerFlags(CLI::App& command, ConnectionFlags& flags) {
  command
      .add_option("--server", flags.server,
                  "Address of the server, HOST:PORT or unix:/PATH; of several, with commas between")
      ->type_name("HOST:PORT")
      ->capture_default_str()
      ->group(kGroup);
  const auto add_file = [&](const char* flag, std::string& path, const char* help) {
    return AddFile(command, flag, path, help);
  };
  CLI::Option* ca =
      add_file("--tls-ca", flags.tls_ca, "Encrypt, and trust the authority in this PEM file");
  CLI::Option* cert = add_file("--tls-cert", flags.tls_cert, "Certificate to show, PEM");
  CLI::Option* key = add_file("--tls-key", flags.tls_key, "Its private key, PEM");
  cert->needs(ca)->needs(key);
  key->needs(cert);
}

void AddConnectionFlags(CLI::App& command, ConnectionFlags& flags) {
  AddServerFlags(command, flags);
  AddFile(command, "--token-file", flags.token_file, "File whose first line is the token to send");
  command.add_option("--robot", flags.robot, "Name of this robot")
      ->type_name("NAME")
      ->group(kGroup);
}

std::string ReadToken(const std::string& flag, const std::string& path) {
  const std::string text = ReadFlagFile(flag, path);
  std::string token = text.substr(0, text.find_first_of("\r\n"));
  if (token.empty()) {
    throw std::invalid_argument(flag + ": " + path + " has no token in its first line");
  }
  if (!client::IsPrintableAscii(token)) {
    throw std::invalid_argument(flag + ": the token in " + path +
                                " has characters that are not printable ASCII");
  }
  return token;
}

client::ClientOptions OptionsOf(const ConnectionFlags& flags, client::ClientOptions options) {
  options.token = flags.token_file.empty() ? "" : ReadToken("--token-file", flags.token_file);
  options.robot = flags.robot;
  if (!client::IsPrintableAscii(options.robot)) {
    throw std::invalid_argument("--robot: \"" + options.robot +
                                "\" has characters that are not printable ASCII");
  }
  if (!flags.tls_ca.empty()) {
    options.tls = client::TlsOptions{
        .root_certificates = ReadPem("--tls-ca", flags.tls_ca, "CERTIFICATE"),
        .certificate_chain = ReadPem("--tls-cert", flags.tls_cert, "CERTIFICATE"),
        .private_key = ReadPem("--tls-key", flags.tls_key, "PRIVATE KEY")};
  }
  return options;
}

client::Client Connect(const ConnectionFlags& flags, client::ClientOptions options) {
  CheckServerAddress(flags.server);
  return client::Client(flags.server, OptionsOf(flags, std::move(options)));
}

}  // namespace fovea::cli
