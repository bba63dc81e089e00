#include "client/observer/flags.h"

#include <CLI/CLI.hpp>

#include "flags/finite_range.h"

namespace fovea::observer {
namespace {

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
      ->check(flags::FiniteRange(0.1, 1440))
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
      ->check(flags::FiniteRange(0.01, 30))
      ->capture_default_str()
      ->group(group);
}

}  // namespace

void AddFlags(CLI::App& app, Flags& flags) {
  app.set_version_flag("--version", "fovea-observer " FOVEA_VERSION);
  cli::AddServerFlags(app, flags.connection);
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

}  // namespace fovea::observer
