// fovea-server: flags → options → server → wait for a signal → drain.
#include <signal.h>
#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>
#include <memory>
#include <mutex>
#include <string>
#include <system_error>

#include "flags/one_line.h"
#include "server/build_info.h"
#include "server/command_line.h"
#include "server/compute_process.h"
#include "server/connections/self_check.h"
#include "server/logging/log_format.h"
#include "server/logging/log_record.h"
#include "server/logging/logging.h"
#include "server/reload.h"
#include "server/server.h"
#include "server/service_manager.h"
#include "server/spare_memory.h"
#include "server/watching/metrics_endpoint.h"

namespace {

using fovea::server::MetricsEndpoint;
using fovea::server::SelfCheck;

// Signals are blocked in every thread and waited for in this one, so that stopping is ordinary
// code and not a signal handler. Call it before any thread starts.
sigset_t BlockSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGHUP);
  sigaddset(&signals, SIGUSR1);  // which would end it
  sigaddset(&signals, SIGUSR2);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  return signals;
}

// A second signal to stop ends the hold. Another one, or that the process goes on after it was
// stopped (EINTR), does not.
void Hold(std::chrono::seconds time) {
  using std::chrono::nanoseconds;
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  sigaddset(&signals, SIGINT);
  const auto end = std::chrono::steady_clock::now() + time;
  timespec left{};
  int signal = 0;
  do {
    const nanoseconds rest = std::max(end - std::chrono::steady_clock::now(), nanoseconds(0));
    left = {.tv_sec = rest / std::chrono::seconds(1),
            .tv_nsec = (rest % std::chrono::seconds(1)).count()};
    signal = sigtimedwait(&signals, nullptr, &left);
  } while (signal < 0 && errno == EINTR);
  if (signal > 0) spdlog::info("a second signal: no longer serving on");
}

void StopGently(fovea::server::Server& server, const fovea::server::ServerOptions& options) {
  spdlog::info("stopping: serving on for {} s as NOT_SERVING, then calls have {} s to finish",
               options.hold_s, options.drain_timeout_s);
  server.StopAdvertising();
  Hold(std::chrono::seconds(options.hold_s));
  const std::size_t num_cancelled = server.Drain();
  spdlog::info("ended: {} cancelled (--drain-timeout-s)",
               num_cancelled == 1 ? "1 call was" : fmt::format("{} calls were", num_cancelled));
}

void WarnOfTokens(const fovea::server::ServerOptions& options,
                  const fovea::server::Server& server) {
  if (server.RefusesEverybody()) spdlog::warn(fovea::server::NoTokens(options));
}

// A server that nobody can reach any more had better be started again by whoever started it.
[[noreturn]] void GiveUp(const std::string& why) {
  spdlog::critical("nobody can reach this server any more: {}; it ends", why);
  spdlog::default_logger()->flush();
  std::_Exit(EXIT_FAILURE);
}

std::unique_ptr<SelfCheck> MakeSelfCheck(const fovea::server::ServerOptions& options,
                                         fovea::server::Server& server) {
  const auto period = fovea::server::CheckPeriod(std::chrono::seconds(options.self_check_s));
  if (period.count() == 0) return nullptr;
  return std::make_unique<SelfCheck>(
      server.door(), period,
      SelfCheck::Listener{.on_answer = fovea::server::NotifyAlive, .on_failure = GiveUp});
}

// The check as long as the server is meant to be reached; asked by probes meanwhile.
class Life {
 public:
  void Watch(std::unique_ptr<SelfCheck> check) {
    const std::lock_guard lock(mutex_);
    check_.swap(check);
  }
  bool IsLive() const {
    const std::lock_guard lock(mutex_);
    return check_ == nullptr || check_->is_live();
  }

 private:
  mutable std::mutex mutex_;
  std::unique_ptr<SelfCheck> check_;
};

std::unique_ptr<MetricsEndpoint> MakeMetricsEndpoint(const fovea::server::ServerOptions& options,
                                                     const fovea::server::Server& server,
                                                     const Life& life) {
  if (options.metrics_listen.empty()) return nullptr;
  return std::make_unique<MetricsEndpoint>(
      options.metrics_listen, server.metrics(),
      fovea::server::Health{.is_live = [&life] { return life.IsLive(); },
                            .is_ready = [&server] { return server.IsServing(); }});
}

// The plain line is what whoever starts the server waits for; a log that programs read has it, too.
void AnnounceAddress(const std::string& event, const std::string& line,
                     const std::string& address) {
  fovea::server::Announce(line + " " + address);
  if (fovea::server::GetLogFormat() != fovea::server::LogFormat::kJson) return;
  fovea::server::LogRecord(event).Text("address", address).Log(spdlog::level::info);
}

// One that has something to do here.
int WaitFor(const sigset_t& signals) {
  while (true) {
    int signal = 0;
    sigwait(&signals, &signal);
    if (signal != SIGUSR1 && signal != SIGUSR2) return signal;
    spdlog::warn("SIG{} does nothing here; SIGHUP has files read again", sigabbrev_np(signal));
  }
}

// Of a thread that could not be started the system says no more than "try again".
const char* AdviceOn(const std::exception& error) {
  const auto* of_system = dynamic_cast<const std::system_error*>(&error);
  const bool no_thread =
      of_system != nullptr && of_system->code() == std::errc::resource_unavailable_try_again;
  return no_thread ? ": no thread can be started (limits of threads, processes or memory)" : "";
}

int Run(int argc, char** argv) {
  fovea::server::GuardStandardStreams();
  const sigset_t signals = BlockSignals();
  fovea::server::Settings settings;
  const auto options = fovea::server::ParseCommandLine(argc, argv, &settings);
  if (!options) return EXIT_SUCCESS;

  fovea::server::SetUpComputing(NumComputeThreads(*options));
  const fovea::server::Logging logging(options->log_level,
                                       fovea::server::ParseLogFormat(options->log_format));
  fovea::server::RaiseFileLimit();
  const fovea::server::SpareMemory spare_memory(std::chrono::minutes{1});
  fovea::server::Server server(*options);
  Life life;
  const auto metrics = MakeMetricsEndpoint(*options, server, life);
  spdlog::info("fovea-server {} ({}) serves", fovea::server::Version(), fovea::server::Commit());
  fovea::server::LogSettings(settings);
  for (const std::string& address : server.Addresses()) {
    AnnounceAddress("listening", "listening on", address);
  }
  if (metrics)
    AnnounceAddress("metrics", "metrics at", "http://" + metrics->Address() + "/metrics");
  if (options->insecure) spdlog::warn("other machines may call unprotected (--insecure)");

  WarnOfTokens(*options, server);
  life.Watch(MakeSelfCheck(*options, server));
  fovea::server::NotifyReady();
  while (WaitFor(signals) == SIGHUP) {
    fovea::server::NotifyReloading();
    fovea::server::Reload(argc, argv, server, &settings);
    fovea::server::NotifyReady();
  }
  fovea::server::NotifyStopping();
  life.Watch(nullptr);
  StopGently(server, *options);
  return EXIT_SUCCESS;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return Run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "fovea-server: " << fovea::flags::OneLine(error.what()) << AdviceOn(error) << '\n';
    return EXIT_FAILURE;
  }
}
