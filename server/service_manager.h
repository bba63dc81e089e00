// What systemd wants to know of a service (Type=notify, WatchdogSec); nothing where it does not
// ask.
#pragma once

#include <chrono>

namespace fovea::server {

void NotifyReady();
void NotifyStopping();
// Within WatchdogSec of the last time, else systemd restarts the service.
void NotifyAlive();

// `wanted`, or less where the watchdog asks for it: a third of its time.
std::chrono::seconds CheckPeriod(std::chrono::seconds wanted);

}  // namespace fovea::server
