#include "server/watching/request_log.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <map>
#include <vector>

#include "core/options.h"
#include "server/connections/socket_address.h"
#include "server/logging/log_limiter.h"
#include "server/logging/log_record.h"
#include "server/status.h"

namespace fovea::server {
namespace {

double Milliseconds(std::chrono::steady_clock::duration duration) {
  return std::chrono::duration<double, std::milli>(duration).count();
}

// What a caller did wrong, or that he left, he can do as often as he likes. `who`: the robot, or
// the host where there is none.
void LogFault(const LogRecord& record, const std::string& kind, const std::string& who) {
  if (LogLimiter::Global().Admit(kind, spdlog::level::warn, who)) {
    record.Log(spdlog::level::warn);
  }
}

std::string ProfileOf(const v1::DetectOptions& options) {
  return options.profile().empty() ? "default" : options.profile();
}

// "mrf.lambda=3 saliency.levels=2": those that are not as the profile has them, or unknown.
std::string ChangesOf(const v1::DetectOptions& options) {
  const std::vector<std::string> profiles = ProfileNames();
  const bool known = std::ranges::count(profiles, ProfileOf(options)) > 0;
  std::map<std::string, double> usual;
  if (known && options.parameters_size() > 0)
    usual = OptionValues(OptionsOfProfile(ProfileOf(options)));
  const std::map<std::string, double> given(options.parameters().begin(),
                                            options.parameters().end());
  std::string text;
  for (const auto& [name, value] : given) {
    const auto found = usual.find(name);
    if (found != usual.end() && found->second == value) continue;
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", name, value);
  }
  return text;
}

std::string Who(const std::string& robot, const std::string& peer) {
  return robot.empty() ? HostOfPeer(peer) : robot;
}

LogRecord Begin(const FrameRecord& record, const std::string& event, const std::string& title) {
  LogRecord line(event, title);
  line.Text("request", record.request_id).Text("robot", record.robot);
  line.Text("frame", record.frame_id).Word("code", NameOf(record.status.error_code()));
  if (record.robot.empty()) line.Text("peer", record.peer);
  return line;
}

void LogSlow(const FrameRecord& record) {
  const std::string code = NameOf(record.status.error_code());
  LogRecord line = Begin(record, "slow", "slow");
  line.Milliseconds("total_ms", Milliseconds(record.took));
  if (!record.image.empty()) {
    line.Text("image", fmt::format("{}x{}", record.image.width, record.image.height));
  }
  if (record.options != nullptr) {
    line.Text("profile", ProfileOf(*record.options)).Text("options", ChangesOf(*record.options));
  }
  const bool was_looked_at = !record.detections.stage_times.empty();
  if (!was_looked_at) line.Milliseconds("queue_ms", Milliseconds(record.queued));
  for (const StageTime& time : record.detections.stage_times) {
    line.Milliseconds(time.stage + "_ms", time.duration_ms);
  }
  LogFault(line, "slow " + code, Who(record.robot, record.peer));
}

void LogEnd(const std::string& event, const std::string& request_id, const std::string& robot,
            const std::string& peer, const grpc::Status& status) {
  const std::string code = NameOf(status.error_code());
  LogRecord line(event);
  line.Text("request", request_id).Text("robot", robot).Word("code", code);
  if (!peer.empty() && robot.empty()) line.Text("peer", peer);
  LogFault(line.Text("error", status.error_message()), event + " " + code, Who(robot, peer));
}

}  // namespace

void LogFrame(const FrameRecord& record, std::chrono::milliseconds slow) {
  LogRecord line = Begin(record, "frame", "");
  const double total_ms = Milliseconds(record.took);
  if (record.status.ok()) {
    line.Number("objects", static_cast<double>(record.detections.objects.size()));
    line.Milliseconds("total_ms", total_ms).Log(spdlog::level::info);
  } else {
    line.Milliseconds("total_ms", total_ms).Text("error", record.status.error_message());
    LogFault(line, std::string("frame ") + NameOf(record.status.error_code()),
             Who(record.robot, record.peer));
  }
  if (slow.count() > 0 && record.took > slow) LogSlow(record);
}

void LogRefusedStream(const std::string& request_id, const std::string& robot,
                      const std::string& peer, const grpc::Status& status) {
  LogEnd("stream", request_id, robot, peer, status);
}

void LogUntakenAnswer(const std::string& request_id, const std::string& robot,
                      const grpc::Status& status) {
  LogEnd("answer", request_id, robot, /*peer=*/"", status);
}

}  // namespace fovea::server
