#include "server/service_manager.h"

#include <systemd/sd-daemon.h>

#include <algorithm>
#include <cstdint>

namespace fovea::server {

void NotifyReady() { sd_notify(/*unset_environment=*/0, "READY=1"); }

void NotifyStopping() { sd_notify(/*unset_environment=*/0, "STOPPING=1"); }

void NotifyAlive() { sd_notify(/*unset_environment=*/0, "WATCHDOG=1"); }

std::chrono::seconds CheckPeriod(std::chrono::seconds wanted) {
  std::uint64_t watchdog_us = 0;
  if (sd_watchdog_enabled(/*unset_environment=*/0, &watchdog_us) <= 0) return wanted;
  const auto third =
      std::chrono::floor<std::chrono::seconds>(std::chrono::microseconds(watchdog_us) / 3);
  return std::max(std::chrono::seconds{1}, std::min(wanted, third));
}

}  // namespace fovea::server
