#include "server/process.h"

#include <google/protobuf/stubs/logging.h>
#include <grpc/support/log.h>
#include <malloc.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <opencv2/core/utility.hpp>

namespace fovea::server {

void SetUpLogging(const std::string& level) {
  spdlog::set_default_logger(spdlog::stderr_color_mt("fovea"));
  spdlog::set_pattern("%Y-%m-%dT%H:%M:%S.%e %^%l%$ %v");
  SetLogLevel(level);
  // What matters of gRPC's and protobuf's own messages we report ourselves; callers could fill the
  // log with them, for example by names that are not UTF-8.
  gpr_set_log_function([](gpr_log_func_args* args) { spdlog::debug("grpc: {}", args->message); });
  google::protobuf::SetLogHandler(
      [](google::protobuf::LogLevel, const char*, int, const std::string& message) {
        spdlog::debug("protobuf: {}", message);
      });
}

void SetLogLevel(const std::string& level) { spdlog::set_level(spdlog::level::from_str(level)); }

// Every frame allocates and frees the same large images: keeping them spares the page faults, and
// detections run side by side, so each is worth one thread. Each of malloc's arenas keeps the most
// that it ever held; glibc makes eight for each processor, over which threads and with them such
// peaks wander for hours.
void SetUpProcess(int num_threads) {
  mallopt(M_ARENA_MAX, num_threads + 1);
  mallopt(M_MMAP_THRESHOLD, 64 << 20);
  mallopt(M_TRIM_THRESHOLD, 128 << 20);
  cv::setNumThreads(1);
}

}  // namespace fovea::server
