#include "client/observer/command_line.h"

#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "client/cli/connection.h"
#include "client/cli/files.h"
#include "client/cli/program.h"
#include "client/cli/server_address.h"
#include "client/observer/flags.h"
#include "client/observer/history/history.h"
#include "client/observer/history/recorder.h"
#include "client/observer/http_server.h"
#include "client/observer/routes.h"
#include "flags/listen_address.h"

namespace {

using fovea::observer::Encryption;
using fovea::observer::Flags;
using fovea::observer::History;
using fovea::observer::HistoryRoutes;
using fovea::observer::HttpServer;
using fovea::observer::PemFile;
using fovea::observer::Recorder;
using fovea::observer::Routes;
using fovea::observer::ServerLink;
using fovea::observer::TlsFiles;

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

Encryption EncryptionOf(const Flags& flags) {
  if (!flags.https_cert.empty()) return Encryption::kOwn;
  return flags.insecure ? Encryption::kPerhapsInFront : Encryption::kNone;
}

// Not of a pipe, which would be waited for when it is read again.
PemFile ReadPem(const char* flag, const std::string& path) {
  if (path.empty()) return {};
  if (std::filesystem::is_fifo(path)) {
    throw std::runtime_error(std::string(flag) + ": " + path +
                             " is no file that can be read again");
  }
  return {.path = path, .text = fovea::cli::ReadFlagFile(flag, path)};
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
  const std::string token = fovea::cli::ReadToken("--history-token-file", flags.history_token_file);
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
  std::signal(SIGPIPE, SIG_IGN);  // a reader of the log that has gone is an error like others
  // They would end it while it reads its history; HttpServer says that they do nothing.
  std::signal(SIGUSR1, SIG_IGN);
  std::signal(SIGUSR2, SIG_IGN);
  fovea::cli::CheckServerAddress(flags.connection.server);
  fovea::flags::RequireListenAddress("--listen", flags.listen);
  RequireProtection(flags);
  std::vector<std::string> hosts = flags.hosts;
  hosts.insert(hosts.end(), {HostOf(flags.listen), "localhost", "127.0.0.1", "[::1]"});
  const std::vector<ServerLink> servers = fovea::observer::LinkServers(
      flags.connection.server, fovea::cli::OptionsOf(flags.connection));
  const Recording recording = Record(flags, servers);
  Routes routes(servers, hosts, EncryptionOf(flags),
                HistoryRoutes(recording.history.get(), recording.recorder.get()));
  const auto read_tls = [&] {
    return TlsFiles{.certificate = ReadPem("--https-cert", flags.https_cert),
                    .key = ReadPem("--https-key", flags.https_key)};
  };
  HttpServer server({.listen = flags.listen, .read_tls = read_tls},
                    {.is_slow = Routes::IsSlow,
                     .answer = [&](const auto& request) { return routes.Answer(request); },
                     .end = [&] { routes.End(); }});
  std::cout << "open " << (flags.https_cert.empty() ? "http://" : "https://") << server.Address()
            << "/" << std::endl;
  server.Run();
  return EXIT_SUCCESS;
}

}  // namespace

namespace fovea::observer {

int RunCommandLine(int argc, char** argv) {
  CLI::App app("Serves a page that shows what robots see and what a fovea server finds in it.",
               "fovea-observer");
  Flags flags;
  AddFlags(app, flags);
  return cli::RunProgram(app, argc, argv, [&] { return Serve(flags); });
}

}  // namespace fovea::observer
