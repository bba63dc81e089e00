#include "server/watching/request_log.h"

#include <spdlog/spdlog.h>

#include "server/status.h"

namespace fovea::server {
namespace {

// A caller must not be able to write lines of its own into the log.
std::string Escaped(const std::string& text) {
  constexpr std::size_t kMaxBytes = 300;
  std::string result;
  for (const char c : text.substr(0, kMaxBytes)) {
    const bool control = static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
    result += control ? '?' : c;
  }
  return result;
}

}  // namespace

void LogFrame(const std::string& frame_id, const grpc::Status& status, std::size_t num_objects,
              std::chrono::steady_clock::duration took) {
  const double took_ms = std::chrono::duration<double, std::milli>(took).count();
  const std::string id = Escaped(frame_id);
  if (status.ok()) {
    spdlog::info("frame \"{}\": {} objects, {:.1f} ms", id, num_objects, took_ms);
  } else {
    spdlog::warn("frame \"{}\": {}: {} ({:.1f} ms)", id, NameOf(status.error_code()),
                 Escaped(status.error_message()), took_ms);
  }
}

}  // namespace fovea::server
