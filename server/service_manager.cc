#include "server/service_manager.h"

#include <systemd/sd-daemon.h>
#include <time.h>

#include <algorithm>
#include <cstdint>
#include <string>

namespace fovea::server {

void NotifyReady() { sd_notify(/*unset_environment=*/0, "READY=1"); }

void NotifyReloading() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);  // the clock that systemd asks for
  const std::int64_t now_us = std::int64_t{now.tv_sec} * 1'000'000 + now.tv_nsec / 1000;
  sd_notify(/*unset_environment=*/0,
            ("RELOADING=1\nMONOTONIC_USEC=" + std::to_string(now_us)).c_str());
}

void NotifyStopping() { sd_notify(/*unset_environment=*/0, "STOPPING=1"); }

void NotifyAlive() { sd_notify(/*unset_environment=*/0, "WATCHDOG=1"); }

std::chrono::seconds CheckPeriod(std::chrono::seconds wanted) {
  std::uint64_t watchdog_us = 0;
  if (sd_watchdog_enabled(/*unset_environment=*/0, &watchdog_us) <= 0) return wanted;
  const auto third =
      std::chrono::floor<std::chrono::seconds>(std::chrono::microseconds(watchdog_us) / 3);
  const auto often_enough = std::max(std::chrono::seconds{1}, third);
  return wanted.count() == 0 ? often_enough : std::min(wanted, often_enough);
}

}  // namespace fovea::server
