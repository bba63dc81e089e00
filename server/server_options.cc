#include "server/server_options.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>
#include <thread>

#include "flags/listen_address.h"
#include "server/connections/socket_address.h"
#include "server/conversion/option_policy.h"
#include "server/conversion/robot_grippers.h"
#include "server/http/http_url.h"
#include "server/number_ranges.h"

namespace fovea::server {
namespace {

constexpr std::string_view kUnix = "unix:";

// Of the largest: four that come at once end no connection, however little the server may hold.
constexpr int kLeastMessages = 6;

void RequireListen(const std::vector<std::string>& listen) {
  if (listen.empty()) throw std::invalid_argument("--listen: needs an address");
  for (const std::string& address : listen) {
    if (!IsUnixAddress(address)) {
      flags::RequireListenAddress("--listen", address);
    } else if (!PathOfUnix(address).starts_with('/')) {
      throw std::invalid_argument("--listen: \"" + address + "\" is not unix:/PATH");
    } else {
      UnixSocketAddress(PathOfUnix(address));
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

void RequireRoomForMessages(const ServerOptions& options) {
  const int least = kLeastMessages * options.max_message_mib;
  if (options.max_receiving_mib >= least) return;
  throw std::invalid_argument("--max-receiving-mib: " + std::to_string(options.max_receiving_mib) +
                              " is less than six messages of --max-message-mib (" +
                              std::to_string(options.max_message_mib) + "), which are " +
                              std::to_string(least) + "; raise it, or lower --max-message-mib");
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
  RequireRanges(options);
  RequireRoomForMessages(options);
  RequireTracing(options);
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
