// fovea-server: flags → options → server → wait for a signal → drain.
#include <grpc/support/log.h>
#include <malloc.h>
#include <signal.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <memory>
#include <opencv2/core/utility.hpp>

#include "server/command_line.h"
#include "server/server.h"

namespace {

// Signals are blocked in every thread and waited for in this one, so that stopping is ordinary
// code and not a signal handler. Call it before any thread starts.
sigset_t BlockStopSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  sigaddset(&signals, SIGINT);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  return signals;
}

void SetUpLogging(const std::string& level) {
  spdlog::set_default_logger(spdlog::stderr_color_mt("fovea"));
  spdlog::set_pattern("%Y-%m-%dT%H:%M:%S.%e %^%l%$ %v");
  spdlog::set_level(spdlog::level::from_str(level));
  // What matters of gRPC's own messages we report ourselves.
  gpr_set_log_function([](gpr_log_func_args* args) { spdlog::debug("grpc: {}", args->message); });
}

// Every frame allocates and frees the same large images: keeping them spares the page faults, and
// detections run side by side, so each is worth one thread.
void SetUpProcess() {
  mallopt(M_MMAP_THRESHOLD, 64 << 20);
  mallopt(M_TRIM_THRESHOLD, 128 << 20);
  cv::setNumThreads(1);
}

void WarnUnlessLoopback(const std::string& listen) {
  const std::string host = fovea::server::HostOf(listen);
  if (host.starts_with("127.") || host == "localhost" || host == "[::1]") return;
  spdlog::warn("listening beyond loopback without authentication or encryption");
}

void StopGently(fovea::server::Server& server, const fovea::server::ServerOptions& options,
                const sigset_t& signals) {
  spdlog::info("stopping: serving on for {} s as NOT_SERVING, then calls have {} s to finish",
               options.hold_s, options.drain_timeout_s);
  server.StopAdvertising();
  const timespec hold{.tv_sec = options.hold_s, .tv_nsec = 0};
  sigtimedwait(&signals, nullptr, &hold);  // a second signal ends the hold
  server.Drain();
}

int Run(int argc, char** argv) {
  const sigset_t signals = BlockStopSignals();
  const auto options = fovea::server::ParseCommandLine(argc, argv);
  if (!options) return EXIT_SUCCESS;

  SetUpLogging(options->log_level);
  SetUpProcess();
  fovea::server::Server server(*options);
  std::cout << "listening on " << server.Address() << std::endl;
  WarnUnlessLoopback(options->listen);

  int signal = 0;
  sigwait(&signals, &signal);
  StopGently(server, *options, signals);
  return EXIT_SUCCESS;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return Run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "fovea-server: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
