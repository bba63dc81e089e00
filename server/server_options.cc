#include "server/server_options.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>
#include <thread>

#include "flags/listen_address.h"
#include "server/conversion/option_policy.h"
#include "server/conversion/robot_grippers.h"
#include "server/http/http_url.h"

namespace fovea::server {
namespace {

constexpr std::string_view kUnix = "unix:";

void RequireRange(const char* flag, std::int64_t value, std::int64_t minimum,
                  std::int64_t maximum) {
  if (value >= minimum && value <= maximum) return;
  throw std::invalid_argument(std::string(flag) + ": " + std::to_string(value) +
                              " is not between " + std::to_string(minimum) + " and " +
                              std::to_string(maximum));
}

void RequireListen(const std::vector<std::string>& listen) {
  if (listen.empty()) throw std::invalid_argument("--listen: needs an address");
  for (const std::string& address : listen) {
    if (!IsUnixAddress(address)) {
      flags::RequireListenAddress("--listen", address);
    } else if (!PathOfUnix(address).starts_with('/')) {
      throw std::invalid_argument("--listen: \"" + address + "\" is not unix:/PATH");
    }
  }
}

bool IsLocal(const std::string& address) {
  const std::string host = HostOf(address);
  return IsUnixAddress(address) || host.starts_with("127.") || host == "localhost" ||
         host == "[::1]";
}

void RequireProtection(const ServerOptions& options) {
  if (options.tls_cert.empty() != options.tls_key.empty()) {
    throw std::invalid_argument("--tls-cert and --tls-key: one needs the other");
  }
  if (!options.tls_client_ca.empty() && options.tls_cert.empty()) {
    throw std::invalid_argument("--tls-client-ca: needs --tls-cert and --tls-key");
  }
  if (!options.tls_crl.empty() && options.tls_client_ca.empty()) {
    throw std::invalid_argument("--tls-crl: needs --tls-client-ca");
  }
  const bool knows_callers = !options.tls_client_ca.empty() || !options.tokens.empty();
  const bool is_protected = !options.tls_cert.empty() && knows_callers;
  const auto open = std::ranges::find_if_not(options.listen, IsLocal);
  if (is_protected || options.insecure || open == options.listen.end()) return;
  throw std::invalid_argument(
      "--listen: \"" + *open +
      "\" is open to other machines; give --tls-cert, --tls-key and either --tls-client-ca or "
      "--tokens, or --insecure to serve them unprotected");
}

void RequireTracing(const ServerOptions& options) {
  if (!options.trace_endpoint.empty()) ParseHttpUrl("--trace-endpoint", options.trace_endpoint);
  if (options.trace_share >= 0 && options.trace_share <= 1) return;
  throw std::invalid_argument("--trace-share: " + std::to_string(options.trace_share) +
                              " is not between 0 and 1");
}

void RequireLogLevel(const std::string& level) {
  constexpr std::array<std::string_view, 6> kLevels{"trace", "debug", "info",
                                                    "warn",  "error", "off"};
  if (std::find(kLevels.begin(), kLevels.end(), level) != kLevels.end()) return;
  throw std::invalid_argument("--log-level: \"" + level +
                              "\" is not one of trace, debug, info, warn, error, off");
}

void RequireLogFormat(const std::string& format) {
  if (format == "text" || format == "json") return;
  throw std::invalid_argument("--log-format: \"" + format + "\" is not one of text, json");
}

}  // namespace

void Validate(const ServerOptions& options) {
  RequireListen(options.listen);
  if (!options.metrics_listen.empty()) {
    flags::RequireListenAddress("--metrics-listen", options.metrics_listen);
  }
  RequireProtection(options);
  RequireRange("--tls-reload-s", options.tls_reload_s, 1, 86'400);
  RequireRange("--max-streams", options.max_streams, 1, 10'000);
  RequireRange("--max-streams-per-robot", options.max_streams_per_robot, 1, 10'000);
  RequireRange("--max-streams-per-host", options.max_streams_per_host, 0, 10'000);
  RequireRange("--max-connections", options.max_connections, 1, 100'000);
  RequireRange("--max-connections-per-host", options.max_connections_per_host, 0, 100'000);
  RequireRange("--max-receiving-mib", options.max_receiving_mib, 16, 65'536);
  RequireRange("--max-unsent-mib", options.max_unsent_mib, 16, 65'536);
  RequireRange("--max-transfer-s", options.max_transfer_s, 1, 3600);
  RequireRange("--self-check-s", options.self_check_s, 0, 3600);
  RequireRange("--max-idle-s", options.max_idle_s, 1, 86'400);
  RequireRange("--max-connection-age-s", options.max_connection_age_s, 0, 86'400);
  RequireRange("--max-message-mib", options.max_message_mib, 1, 1024);
  RequireRange("--max-pixels", options.max_pixels, 1, 100'000'000);
  RequireRange("--compute-threads", options.compute_threads, 0, 1024);
  RequireRange("--threads-per-frame", options.threads_per_frame, 0, 1024);
  RequireRange("--compute-nice", options.compute_nice, 0, 19);
  RequireRange("--max-waiting", options.max_waiting, -1, 10'000);
  RequireRange("--max-per-robot", options.max_per_robot, 0, 10'000);
  RequireRange("--max-running-per-robot", options.max_running_per_robot, 0, 1024);
  RequireRange("--max-compute-ms", options.max_compute_ms, 0, 3'600'000);
  RequireRange("--hold-s", options.hold_s, 0, 3600);
  RequireRange("--drain-timeout-s", options.drain_timeout_s, 0, 3600);
  RequireTracing(options);
  RequireRange("--slow-ms", options.slow_ms, 0, 3'600'000);
  const OptionPolicy policy(options.client_options, options.fixed_options);
  const RobotGrippers grippers(options.grippers);
  RequireLogLevel(options.log_level);
  RequireLogFormat(options.log_format);
}

int NumComputeThreads(const ServerOptions& options) {
  if (options.compute_threads > 0) return options.compute_threads;
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

int MaxThreadsPerFrame(const ServerOptions& options) {
  const int num_threads = NumComputeThreads(options);
  return options.threads_per_frame > 0 ? std::min(options.threads_per_frame, num_threads)
                                       : num_threads;
}

std::string HostOf(const std::string& listen) { return listen.substr(0, listen.rfind(':')); }

bool IsUnixAddress(const std::string& listen) { return listen.starts_with(kUnix); }

std::string PathOfUnix(const std::string& listen) { return listen.substr(kUnix.size()); }

}  // namespace fovea::server
