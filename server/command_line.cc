#include "server/command_line.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "flags/misspelling.h"
#include "flags/plain_values.h"
#include "server/access/credentials.h"
#include "server/access/file_to_read_again.h"
#include "server/access/gate_keeper.h"
#include "server/access/observer_gate.h"
#include "server/config_file.h"
#include "server/number_ranges.h"
#include "server/options_page.h"

namespace fovea::server {
namespace {

void AddProtectionFlags(CLI::App& app, ServerOptions& options) {
  app.add_flag("--insecure", options.insecure, "Serve other machines unprotected")
      ->default_str("false");
  app.add_option("--tls-cert", options.tls_cert, "Certificate chain of the server, PEM file");
  app.add_option("--tls-key", options.tls_key, "Its private key, PEM file");
  app.add_option("--tls-client-ca", options.tls_client_ca,
                 "Authority whose certificates clients must show, PEM file");
  app.add_option("--tls-crl", options.tls_crl,
                 "Its list of certificates that it has revoked, PEM file; one for each authority");
  app.add_option("--tls-reload-s", options.tls_reload_s,
                 "How often these files are read again, in seconds")
      ->capture_default_str();
  app.add_option("--tokens", options.tokens,
                 "File with a line `ROBOT SHA256 [EXPIRES]` for every token; callers need one. "
                 "SIGHUP reads it again");
  app.add_option("--observers", options.observers,
                 "File with a line `NAME SHA256 RIGHTS ROBOTS [EXPIRES]` for everybody who may "
                 "watch what robots see, with rights of view, try, download and pick; nobody may "
                 "without. SIGHUP reads it again");
}

void AddConnectionFlags(CLI::App& app, ServerOptions& options) {
  app.add_option("--max-connections", options.max_connections,
                 "Connections open at once; fewer where the limit of open files asks for it")
      ->capture_default_str();
  app.add_option("--max-connections-per-host", options.max_connections_per_host,
                 "Of one host; 0 = half of them")
      ->capture_default_str();
  app.add_option("--max-receiving-mib", options.max_receiving_mib,
                 "What may have come of all messages that are not whole yet, and what may wait of "
                 "frames in streams, MiB each, six messages of --max-message-mib at least; "
                 "connections that hold most are ended, frames without room refused")
      ->capture_default_str();
  app.add_option("--max-unsent-mib", options.max_unsent_mib,
                 "What may wait of answers that their callers have not taken yet, MiB; "
                 "those that wait for longest are ended")
      ->capture_default_str();
  app.add_option("--max-transfer-s", options.max_transfer_s,
                 "How long a message may take to come, and an answer to be taken, in seconds")
      ->capture_default_str();
  app.add_option(
         "--max-idle-s", options.max_idle_s,
         "A connection without a call is closed after so many seconds, at the latest after twice "
         "that")
      ->capture_default_str();
  app.add_option("--max-connection-age-s", options.max_connection_age_s,
                 "Clients are asked for a new connection after so many seconds, and streams end "
                 "after the answer they are at, so that other servers get work; 0 = never")
      ->capture_default_str();
  app.add_option("--self-check-s", options.self_check_s,
                 "How often the server asks itself for its health, in seconds; 0 = never. "
                 "It ends when it is not answered three times in a row")
      ->capture_default_str();
}

void AddAddressFlags(CLI::App& app, ServerOptions& options) {
  app.set_version_flag("--version", "fovea-server " FOVEA_VERSION);
  app.add_option(
         "--listen", options.listen,
         "Addresses to listen on, each HOST:PORT, where port 0 takes a free one, or unix:/PATH. "
         "Other than loopback and UNIX sockets only with TLS and client certificates or tokens, or "
         "with --insecure")
      ->default_str(options.listen.front());  // without the brackets of a list
}

void AddRequestFlags(CLI::App& app, ServerOptions& options) {
  app.add_option("--max-streams", options.max_streams, "Streams open at once")
      ->capture_default_str();
  app.add_option("--max-streams-per-robot", options.max_streams_per_robot,
                 "Streams that one robot may have open")
      ->capture_default_str();
  app.add_option("--max-streams-per-host", options.max_streams_per_host,
                 "Streams that robots without token or certificate may have open from one host; "
                 "0 = half of all. Never fewer than one robot may")
      ->capture_default_str();
  app.add_option("--max-message-mib", options.max_message_mib,
                 "Largest request in MiB; larger ones get RESOURCE_EXHAUSTED")
      ->capture_default_str();
  app.add_option("--max-pixels", options.max_pixels,
                 "Largest image in pixels; checked before it is decoded")
      ->capture_default_str();
}

void AddComputeFlags(CLI::App& app, ServerOptions& options) {
  app.add_option("--compute-threads", options.compute_threads,
                 "Frames computed at once; 0 = one per processor")
      ->capture_default_str();
  app.add_option("--threads-per-frame", options.threads_per_frame,
                 "How many of these may work for one frame while others are idle; 0 = "
                 "all, 1 = one frame a thread")
      ->capture_default_str();
  app.add_option("--compute-nice", options.compute_nice,
                 "How much these give way to the server's other threads, in steps of niceness")
      ->capture_default_str();
  app.add_option("--max-waiting", options.max_waiting,
                 "Frames that wait beyond those; more get RESOURCE_EXHAUSTED. "
                 "-1 = one per compute thread")
      ->capture_default_str();
  app.add_option("--max-per-robot", options.max_per_robot,
                 "Frames that one robot may have waiting or computed; 0 = two thirds of all")
      ->capture_default_str();
  app.add_option("--max-running-per-robot", options.max_running_per_robot,
                 "Frames that one robot may have computed at once; 0 = one per thread, "
                 "but one less while others call")
      ->capture_default_str();
  app.add_option("--max-compute-ms", options.max_compute_ms,
                 "Processor time that one frame may take, ms; more gets "
                 "RESOURCE_EXHAUSTED. 0 = any")
      ->capture_default_str();
}

void AddMethodFlags(CLI::App& app, ServerOptions& options) {
  app.add_option("--client-options", options.client_options,
                 "What requests may change of the method: none, safe (where to look and what to "
                 "report) or all")
      ->capture_default_str();
  app.add_option(
      "--option", options.fixed_options,
      "Options of the method, each NAME=VALUE, that hold for every frame; --list-options "
      "prints all");
  app.add_option(
      "--gripper", options.grippers,
      "Grippers of robots whose requests name none, each ROBOT=GRIPPER with a "
      "fovea.v1.Gripper in JSON, for example 'arm={\"jaw\": {\"max_opening_m\": 0.14}}'; "
      "ROBOT * is every other one");
}

void AddStopFlags(CLI::App& app, ServerOptions& options) {
  app.add_option("--hold-s", options.hold_s,
                 "How long to serve on with health NOT_SERVING after SIGTERM or SIGINT, in "
                 "seconds; a second signal ends it")
      ->capture_default_str();
  app.add_option("--drain-timeout-s", options.drain_timeout_s,
                 "How long calls may finish after that, in seconds")
      ->capture_default_str();
}

void AddWatchingFlags(CLI::App& app, ServerOptions& options) {
  app.add_option(
         "--metrics-listen", options.metrics_listen,
         "Address of Prometheus' metrics and of probes, HTTP at HOST:PORT/metrics, /livez and "
         "/readyz; port 0 takes a free one")
      ->capture_default_str();
  app.add_option("--trace-endpoint", options.trace_endpoint,
                 "Collector that takes spans as OTLP over HTTP, for example "
                 "http://127.0.0.1:4318/v1/traces; none are made without")
      ->capture_default_str();
  app.add_option(
         "--trace-share", options.trace_share,
         "Share of the frames that are traced, 0 to 1, of callers that send no traceparent; "
         "of others, those that the caller records")
      ->capture_default_str();
  app.add_option(
         "--slow-ms", options.slow_ms,
         "Frames that take longer, in ms, get a log line with the time of each stage; 0 = none")
      ->capture_default_str();
  app.add_option("--log-format", options.log_format,
                 "text: key=value; or json: an object a line with the same keys")
      ->capture_default_str();
  app.add_option("--log-level", options.log_level,
                 "trace, debug, info, warn, error or off; SIGHUP reads it again from the file")
      ->capture_default_str();
}

// In the order of --help.
void AddFlags(CLI::App& app, ServerOptions& options) {
  for (const auto add : {AddAddressFlags, AddProtectionFlags, AddConnectionFlags, AddRequestFlags,
                         AddComputeFlags, AddMethodFlags, AddStopFlags, AddWatchingFlags}) {
    add(app, options);
  }
}

// CLI11 itself names neither range nor constraint. The help says the range behind the type.
void RequireNumbers(CLI::App& app) {
  for (CLI::Option* option : app.get_options([](CLI::Option*) { return true; })) {
    const auto problem_of = [flag = option->get_name()](const std::string& value) {
      const std::string why = WhyNoNumber(flag, value);
      return why.empty() ? why : "\"" + value + "\" " + why;
    };
    option->check(CLI::Validator(problem_of, RangeOf(option->get_name())));
  }
}

// What is answered instead of serving.
struct Questions {
  bool list_options = false, check_config = false;
  std::string show;
};

void AddQuestionFlags(CLI::App& app, Questions& questions) {
  app.add_flag("--check-config", questions.check_config,
               "Say whether flags and configuration file are valid, and exit")
      ->configurable(false);
  app.add_option("--show", questions.show,
                 "Print the value that this flag has with the others and the file, and exit")
      ->type_name("KEY")
      ->configurable(false);
  app.add_flag("--list-options", questions.list_options,
               "Print every option of the method with its range, profiles and meaning, and exit")
      ->configurable(false);
}

void Show(const std::string& key, const Settings& settings) {
  const auto found = settings.find(key);
  if (found == settings.end()) {
    throw std::invalid_argument("--show: \"" + key + "\" is no key; --help lists the flags");
  }
  std::cout << ForPeople(found->first, found->second) << '\n';
}

void CheckFiles(const ServerOptions& options) {
  const Credentials credentials(options);
  const GateKeeper gate_keeper(options.tokens);
  const ObserverGate observer_gate(options.observers);
  std::cout << "the configuration is valid\n";
  if (gate_keeper.RefusesEverybody()) std::cout << NoTokens(options) << '\n';
}

}  // namespace

std::string NoTokens(const ServerOptions& options) {
  return "--tokens: " + options.tokens + " holds 0 tokens that have not expired: nobody may call";
}

std::optional<ServerOptions> ParseCommandLine(int argc, char** argv, Settings* settings) {
  CLI::App app("Serves fovea.v1.DetectionService: finds unknown objects in RGB-D frames.",
               "fovea-server");
  ServerOptions options;
  AddFlags(app, options);
  flags::RequirePlainValues(app);
  RequireNumbers(app);
  app.set_config("--config", "",
                 "File with any of these flags, one KEY = VALUE a line; flags given here win")
      ->each([](const std::string& path) { RequireReadable("--config", path); });
  app.config_formatter(std::make_shared<ConfigFile>(app));
  Questions questions;
  AddQuestionFlags(app, questions);
  flags::RequireValuesBehindEquals(argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& wants_text) {  // --help, --version
    app.exit(wants_text);
    return std::nullopt;
  } catch (const CLI::FileError& error) {
    throw std::invalid_argument("--config: " + std::string(error.what()));
  } catch (const CLI::ParseError& error) {
    throw std::invalid_argument(error.what() + flags::Misspelling(app, argc, argv) +
                                " (--help lists the flags)");
  }
  if (questions.list_options) {
    std::cout << OptionsAsMarkdown();
    return std::nullopt;
  }
  Validate(options);
  if (settings != nullptr) *settings = SettingsOf(app);
  if (!questions.show.empty()) Show(questions.show, SettingsOf(app));
  if (questions.check_config) CheckFiles(options);
  if (!questions.show.empty() || questions.check_config) return std::nullopt;
  return options;
}

}  // namespace fovea::server
