#include "server/limits_of_options.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <cstddef>

#include "server/connections/door.h"

namespace fovea::server {
namespace {

// The door looks every 100 ms while little is on its way, later where processors are short: a link
// of 10 Gbit/s brings 125 MB meanwhile. Connections and calls themselves take some, too.
constexpr std::size_t kBetweenLooks = std::size_t{256} << 20;

std::size_t BytesOfMiB(int mib) { return static_cast<std::size_t>(mib) << 20; }

}  // namespace

SchedulerLimits SchedulerLimitsOf(const ServerOptions& options) {
  const int num_threads = NumComputeThreads(options);
  // An accepted frame waits for the rest of what is computed and for one other frame at most, so
  // that its answer takes no more than thrice the time of one detection. More would only wait: a
  // thread that is done takes what waits, and the next is let in meanwhile.
  const int max_waiting = options.max_waiting >= 0 ? options.max_waiting : num_threads;
  // Leaves a third of the places to other robots.
  const int fair_share = std::max(1, 2 * (num_threads + max_waiting) / 3);
  return {.num_threads = num_threads,
          .max_waiting = max_waiting,
          .max_per_robot = options.max_per_robot > 0 ? options.max_per_robot : fair_share,
          .max_running_per_robot = options.max_running_per_robot,
          .nice = options.compute_nice};
}

ConnectionLimits ConnectionLimitsOf(const ServerOptions& options) {
  // Each connection takes two; the rest is for files, logs, metrics and what is being closed.
  const std::size_t files = FileLimit();
  const auto possible = static_cast<int>(
      std::clamp<std::size_t>((files - std::min<std::size_t>(files / 2, 256)) / 2, 1, 100'000));
  const int max = std::min(options.max_connections, possible);
  if (max < options.max_connections) {
    spdlog::warn("--max-connections: {} of {}, since {} files may be open", max,
                 options.max_connections, files);
  }
  const int per_host = options.max_connections_per_host;
  return {.max_connections = max,
          .max_per_host = per_host > 0 ? std::min(per_host, max) : std::max(1, max / 2),
          .max_receiving = BytesOfMiB(options.max_receiving_mib) / 4 * 3,
          .account = {.max_owed = std::max<std::size_t>(
                          64 << 20, static_cast<std::size_t>(options.max_message_mib) << 21),
                      .max_transfer = std::chrono::seconds(options.max_transfer_s)}};
}

std::size_t GrpcQuotaOf(const ServerOptions& options) {
  const SchedulerLimits limits = SchedulerLimitsOf(options);
  const auto calls = static_cast<std::size_t>(limits.num_threads + limits.max_waiting);
  const std::size_t in_part = BytesOfMiB(options.max_receiving_mib), in_streams = in_part;
  return in_part + in_streams + calls * BytesOfMiB(options.max_message_mib) + kBetweenLooks;
}

StreamLimits StreamLimitsOf(const ServerOptions& options) {
  const int per_robot = options.max_streams_per_robot, per_host = options.max_streams_per_host;
  return {.max_streams = options.max_streams,
          // A robot that a token names counts as a host of its own.
          .max_per_host = std::max(per_host > 0 ? per_host : options.max_streams / 2, per_robot),
          .max_per_robot = per_robot};
}

}  // namespace fovea::server
