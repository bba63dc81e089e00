#include "server/logging/logging.h"

#include <fcntl.h>
#include <google/protobuf/stubs/logging.h>
#include <grpc/support/log.h>
#include <signal.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <stop_token>

#include "server/log_exception.h"
#include "server/logging/failed_handshakes.h"
#include "server/logging/line_sink.h"
#include "server/logging/log_limiter.h"
#include "server/logging/log_record.h"

namespace fovea::server {
namespace {

// Failed handshakes are among gRPC's errors. A kind is a place in its code, of which there are few.
void LogOfGrpc(gpr_log_func_args* args) {
  const std::string message = "grpc: " + Harmless(args->message);
  if (args->severity != GPR_LOG_SEVERITY_ERROR) {
    spdlog::debug(message);
    return;
  }
  if (message.starts_with("grpc: Handshake failed")) NoteFailedHandshake();
  const std::string file = args->file;
  LogLimited("grpc " + file.substr(file.rfind('/') + 1) + ":" + std::to_string(args->line),
             spdlog::level::err, message);
}

// Callers could fill the log with them, for example by names that are not UTF-8.
void LogOfProtobuf(google::protobuf::LogLevel /*level*/, const char* /*file*/, int /*line*/,
                   const std::string& message) {
  spdlog::debug("protobuf: {}", Harmless(message));
}

void Summarize(const std::stop_token& stop) {
  std::mutex mutex;
  std::condition_variable_any never;
  std::unique_lock lock(mutex);
  const auto stopped = [&] { return stop.stop_requested(); };
  while (!never.wait_for(lock, stop, std::chrono::seconds(1), stopped)) {
    try {
      LogLimiter::Global().Summarize();
      spdlog::default_logger_raw()->flush();
    } catch (...) {
      LogCurrentException("cannot say what was left out of the log");
    }
  }
}

}  // namespace

Logging::Logging(const std::string& level, LogFormat format) {
  auto sink = std::make_shared<LineSink>(STDERR_FILENO);
  auto logger = std::make_shared<spdlog::logger>("fovea", std::move(sink));
  logger->set_formatter(MakeFormatter(format));
  SetLogFormat(format);
  spdlog::set_default_logger(std::move(logger));
  SetLevel(level);
  gpr_set_log_function(LogOfGrpc);
  google::protobuf::SetLogHandler(LogOfProtobuf);
  summaries_ = std::jthread(Summarize);
}

Logging::~Logging() {
  summaries_ = {};
  LogLimiter::Global().Summarize(LogLimiter::Clock::time_point::max());
  spdlog::default_logger_raw()->flush();
}

void Logging::SetLevel(const std::string& level) {
  spdlog::set_level(spdlog::level::from_str(level));
}

void GuardStandardStreams() {
  signal(SIGPIPE, SIG_IGN);
  signal(SIGXFSZ, SIG_IGN);
  int fd = open("/dev/null", O_RDWR);
  while (fd >= 0 && fd <= STDERR_FILENO) fd = open("/dev/null", O_RDWR);
  if (fd > STDERR_FILENO) close(fd);
}

void Announce(const std::string& line) { LineWriter(STDOUT_FILENO).Write(line + "\n"); }

}  // namespace fovea::server
