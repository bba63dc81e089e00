// fovea-observer: flags → servers to watch → a page over HTTP until a signal comes.
#include <CLI/CLI.hpp>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "client/cli/connection.h"
#include "client/cli/files.h"
#include "client/cli/program.h"
#include "client/cli/server_address.h"
#include "client/observer/http_server.h"
#include "client/observer/routes.h"

namespace {

using fovea::observer::HttpOptions;
using fovea::observer::HttpServer;
using fovea::observer::Routes;

struct Flags {
  fovea::cli::ConnectionFlags connection;
  std::string listen = "127.0.0.1:8080", https_cert, https_key;
  std::vector<std::string> hosts;
  bool insecure = false;
};

void AddFlags(CLI::App& app, Flags& flags) {
  app.set_version_flag("--version", "fovea-observer " FOVEA_VERSION);
  fovea::cli::AddServerFlags(app, flags.connection);
  app.add_option("--listen", flags.listen,
                 "Where browsers find the page, HOST:PORT; port 0 takes a free one. Other than "
                 "loopback only with TLS, or with --insecure")
      ->capture_default_str();
  CLI::Option* cert = app.add_option("--https-cert", flags.https_cert,
                                     "Serve TLS with this certificate chain, PEM file");
  CLI::Option* key = app.add_option("--https-key", flags.https_key, "Its private key, PEM file");
  cert->needs(key);
  key->needs(cert);
  app.add_option("--host", flags.hosts,
                 "Names that browsers may call this machine by, beside the address and localhost; "
                 "requests for others are refused");
  app.add_flag("--insecure", flags.insecure, "Serve other machines without TLS");
}

std::string HostOf(const std::string& address) { return address.substr(0, address.rfind(':')); }

bool IsLoopback(const std::string& host) {
  return host.starts_with("127.") || host == "localhost" || host == "[::1]";
}

void RequireProtection(const Flags& flags) {
  if (IsLoopback(HostOf(flags.listen)) || !flags.https_cert.empty() || flags.insecure) return;
  throw std::invalid_argument("--listen: \"" + flags.listen +
                              "\" is open to other machines; give --https-cert and --https-key, "
                              "or --insecure to serve them unprotected");
}

std::string ReadIfGiven(const std::string& path) {
  return path.empty() ? "" : fovea::cli::ReadFile(path);
}

int Serve(const Flags& flags) {
  fovea::cli::CheckServerAddress(flags.connection.server);
  RequireProtection(flags);
  std::vector<std::string> hosts = flags.hosts;
  hosts.insert(hosts.end(), {HostOf(flags.listen), "localhost", "127.0.0.1", "[::1]"});
  Routes routes(fovea::observer::LinkServers(flags.connection.server,
                                             fovea::cli::OptionsOf(flags.connection)),
                hosts, !flags.https_cert.empty());
  HttpServer server({.listen = flags.listen,
                     .certificate = ReadIfGiven(flags.https_cert),
                     .key = ReadIfGiven(flags.https_key)},
                    {.is_slow = Routes::IsSlow,
                     .answer = [&](const auto& request) { return routes.Answer(request); }});
  std::cout << "open " << (flags.https_cert.empty() ? "http://" : "https://") << server.Address()
            << "/" << std::endl;
  server.Run();
  return EXIT_SUCCESS;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Serves a page that shows what robots see and what a fovea server finds in it.",
               "fovea-observer");
  Flags flags;
  AddFlags(app, flags);
  return fovea::cli::RunProgram(app, argc, argv, [&] { return Serve(flags); });
}
