#include "server/watching/request_log.h"

#include <spdlog/spdlog.h>

#include "server/status.h"

namespace fovea::server {
namespace {

// A caller must not be able to write lines or keys of its own into the log.
std::string Quoted(const std::string& text) {
  constexpr std::size_t kMaxBytes = 300;
  std::string result = "\"";
  for (const char c : text.substr(0, kMaxBytes)) {
    const bool plain = static_cast<unsigned char>(c) >= 0x20 && c != 0x7F && c != '"' && c != '\\';
    result += plain ? c : '?';
  }
  return result + '"';
}

double Milliseconds(std::chrono::steady_clock::duration duration) {
  return std::chrono::duration<double, std::milli>(duration).count();
}

void LogStages(const FrameRecord& record) {
  std::string stages;
  for (const StageTime& time : record.detections.stage_times) {
    stages += fmt::format(" {}_ms={:.1f}", time.stage, time.duration_ms);
  }
  spdlog::warn("slow request={} total_ms={:.1f}{}", Quoted(record.request_id),
               Milliseconds(record.took), stages);
}

}  // namespace

void LogFrame(const FrameRecord& record, std::chrono::milliseconds slow) {
  const std::string who = fmt::format("request={} robot={} frame={}", Quoted(record.request_id),
                                      Quoted(record.robot), Quoted(record.frame_id));
  const double total_ms = Milliseconds(record.took);
  if (record.status.ok()) {
    spdlog::info("{} code=OK objects={} total_ms={:.1f}", who, record.detections.objects.size(),
                 total_ms);
  } else {
    spdlog::warn("{} code={} total_ms={:.1f} error={}", who, NameOf(record.status.error_code()),
                 total_ms, Quoted(record.status.error_message()));
  }
  if (slow.count() > 0 && record.took > slow) LogStages(record);
}

void LogRefusedStream(const std::string& request_id, const std::string& robot,
                      const grpc::Status& status) {
  spdlog::warn("stream request={} robot={} code={} error={}", Quoted(request_id), Quoted(robot),
               NameOf(status.error_code()), Quoted(status.error_message()));
}

}  // namespace fovea::server
