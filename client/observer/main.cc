// fovea-observer: flags → servers to watch → a page over HTTP until a signal comes.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "client/cli/connection.h"
#include "client/cli/files.h"
#include "client/cli/program.h"
#include "client/cli/server_address.h"
#include "client/observer/history/history.h"
#include "client/observer/history/recorder.h"
#include "client/observer/http_server.h"
#include "client/observer/routes.h"

namespace {

using fovea::observer::History;
using fovea::observer::HistoryRoutes;
using fovea::observer::HttpOptions;
using fovea::observer::HttpServer;
using fovea::observer::Recorder;
using fovea::observer::Routes;
using fovea::observer::ServerLink;

struct Flags {
  fovea::cli::ConnectionFlags connection;
  std::string listen = "127.0.0.1:8080", https_cert, https_key;
  std::vector<std::string> hosts;
  bool insecure = false;
  std::string history, history_token_file;
  double history_minutes = 10, history_rate_hz = 2;
  std::uint64_t history_bytes = fovea::observer::HistoryLimits().max_bytes;
};

void AddHistoryFlags(CLI::App& app, Flags& flags) {
  const char* group = "History";
  app.add_option("--history", flags.history,
                 "Keep the last minutes of every robot in this folder, with what it sent: for "
                 "stepping back and for bundles")
      ->type_name("DIR")
      ->group(group);
  app.add_option("--history-token-file", flags.history_token_file,
                 "Token to record with, of an observer with the rights view and download; without "
                 "it there is no history. Who looks sees what the own token lets see")
      ->type_name("FILE")
      ->group(group);
  app.add_option("--history-minutes", flags.history_minutes, "Of each robot, before its last frame")
      ->type_name("N")
      ->check(CLI::Range(0.1, 1440.0))
      ->capture_default_str()
      ->group(group);
  app.add_option("--history-size", flags.history_bytes,
                 "On disk at most, of one robot half of it; the oldest goes first")
      ->type_name("BYTES")
      ->transform(CLI::AsSizeValue(/*kb_is_1000=*/false))
      ->check(CLI::Range(std::uint64_t{1} << 20U, std::uint64_t{1} << 50U, "1 MiB to 1 PiB"))
      ->capture_default_str()
      ->group(group);
  app.add_option("--history-rate", flags.history_rate_hz, "Frames of a robot a second at most")
      ->type_name("HZ")
      ->check(CLI::Range(0.01, 30.0))
      ->capture_default_str()
      ->group(group);
}

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
  AddHistoryFlags(app, flags);
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

// What is recorded, and what records it; both null where there is no history.
struct Recording {
  std::unique_ptr<History> history;
  std::unique_ptr<Recorder> recorder;
};

Recording Record(const Flags& flags, const std::vector<ServerLink>& servers) {
  if (flags.history.empty()) {
    if (flags.history_token_file.empty()) return {};
    throw std::invalid_argument("--history-token-file needs --history, the folder to record to");
  }
  if (flags.history_token_file.empty()) {
    std::cerr << "fovea-observer: there is no history: --history needs --history-token-file\n";
    return {};
  }
  fovea::cli::ConnectionFlags own;
  own.token_file = flags.history_token_file;
  const std::string token = fovea::cli::OptionsOf(own).token;
  if (token.empty()) {
    throw std::invalid_argument("--history-token-file: " + flags.history_token_file +
                                " has no token in its first line");
  }
  const fovea::observer::HistoryLimits limits{
      .span = std::chrono::seconds(std::llround(60 * flags.history_minutes)),
      .max_bytes = flags.history_bytes};
  Recording recording;
  recording.history = std::make_unique<History>(flags.history, limits);
  recording.recorder =
      std::make_unique<Recorder>(servers, token, flags.history_rate_hz, *recording.history);
  return recording;
}

int Serve(const Flags& flags) {
  fovea::cli::CheckServerAddress(flags.connection.server);
  RequireProtection(flags);
  std::vector<std::string> hosts = flags.hosts;
  hosts.insert(hosts.end(), {HostOf(flags.listen), "localhost", "127.0.0.1", "[::1]"});
  const std::vector<ServerLink> servers = fovea::observer::LinkServers(
      flags.connection.server, fovea::cli::OptionsOf(flags.connection));
  const Recording recording = Record(flags, servers);
  Routes routes(servers, hosts, !flags.https_cert.empty(),
                HistoryRoutes(recording.history.get(), recording.recorder.get()));
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
