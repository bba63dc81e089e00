#include "client/server_load.h"

#include <algorithm>

namespace fovea::client {
namespace {

double Seconds(const google::protobuf::Duration& duration) {
  return static_cast<double>(duration.seconds()) + duration.nanos() * 1e-9;
}

double NumAnswered(const v1::GetStatisticsResponse& statistics) {
  double sum = 0;
  for (const auto& [code, count] : statistics.frames_answered()) sum += static_cast<double>(count);
  return sum;
}

// Of all frames, without their time in the queue. What they wait for a processor is in the others.
double WorkSeconds(const v1::GetStatisticsResponse& statistics) {
  double sum = 0;
  for (const auto& [stage, times] : statistics.stages()) {
    if (stage != "queue" && stage != "processor_wait") sum += Seconds(times.total());
  }
  return sum;
}

}  // namespace

void ServerLoad::Note(const v1::GetStatisticsResponse& statistics) {
  num_waiting_ = static_cast<double>(statistics.frames_waiting());
  s_per_frame_.reset();
  if (last_) {
    const double seconds = Seconds(statistics.uptime()) - Seconds(last_->uptime());
    const double num_frames = NumAnswered(statistics) - NumAnswered(*last_);
    const double work_s = WorkSeconds(statistics) - WorkSeconds(*last_);
    const bool was_restarted = seconds <= 0 || num_frames < 0;
    if (!was_restarted && num_frames > 0) {
      // Where nothing waits there may be more to have: what one thread can do at least.
      s_per_frame_ = (is_overloaded() ? seconds : std::min(seconds, work_s)) / num_frames;
    } else if (!was_restarted && !is_overloaded()) {
      s_per_frame_ = 0;
    }
  }
  last_ = statistics;
}

std::optional<double> ServerLoad::Turn(int more) const {
  if (!s_per_frame_) return std::nullopt;
  constexpr int kComputed = 1;
  return (num_waiting_ + kComputed + more) * *s_per_frame_;
}

}  // namespace fovea::client
