// What systemd wants to know of a service (Type=notify, WatchdogSec); nothing where it does not
// ask.
#pragma once

#include <chrono>

namespace fovea::server {

void NotifyReady();
// Until NotifyReady is called again.
void NotifyReloading();
void NotifyStopping();
// Within WatchdogSec of the last time, else systemd restarts the service.
void NotifyAlive();

// `wanted`, where 0 = never, or less where the watchdog asks for it: a third of its time, 1 s at
// least.
std::chrono::seconds CheckPeriod(std::chrono::seconds wanted);

}  // namespace fovea::server
