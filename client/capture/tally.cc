#include "client/capture/tally.h"

#include <fmt/printf.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fovea::capture {
namespace {

double Seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
}

std::size_t BytesOf(const Picture& picture) {
  return picture.color.total() * picture.color.elemSize() +
         picture.depth.total() * picture.depth.elemSize();
}

}  // namespace

void Tally::Replaced() {
  const std::lock_guard lock(mutex_);
  ++counts_.replaced;
}

void Tally::Sent(Picture picture) {
  const std::lock_guard lock(mutex_);
  const std::size_t bytes = BytesOf(picture);
  waiting_.push_back({counts_.sent++, std::move(picture)});
  if (bytes == 0) return;
  // All of a run are of one size.
  const std::size_t num_kept = std::max<std::size_t>(max_image_bytes_ / bytes, 1);
  if (waiting_.size() <= num_kept) return;
  Picture& oldest = waiting_[waiting_.size() - 1 - num_kept].picture;
  oldest.color = oldest.depth = cv::Mat();
}

void Tally::NotSent() {
  const std::lock_guard lock(mutex_);
  if (!waiting_.empty()) waiting_.pop_back();
}

std::optional<Picture> Tally::Answered(std::uint64_t sequence) {
  const std::lock_guard lock(mutex_);
  // Those before it were dropped or lost, and get no answer.
  while (!waiting_.empty() && waiting_.front().sequence < sequence) waiting_.pop_front();
  if (waiting_.empty() || waiting_.front().sequence != sequence) return std::nullopt;
  Picture picture = std::move(waiting_.front().picture);
  waiting_.pop_front();
  return picture;
}

void Tally::Count(bool failed, std::uint64_t objects, double latency_ms) {
  const std::lock_guard lock(mutex_);
  if (failed) {
    ++counts_.failed;
    return;
  }
  ++counts_.answered;
  counts_.objects += objects;
  latencies_ms_.push_back(latency_ms);
}

void Tally::Gone(std::uint64_t dropped, std::uint64_t lost) {
  const std::lock_guard lock(mutex_);
  counts_.dropped += dropped;
  counts_.lost += lost;
}

void Tally::Finish() {
  const std::lock_guard lock(mutex_);
  const Counts& c = counts_;
  counts_.lost = c.sent - std::min(c.sent, c.answered + c.failed + c.dropped);
}

Tally::Counts Tally::Snapshot() const {
  const std::lock_guard lock(mutex_);
  return counts_;
}

std::vector<double> Tally::Latencies_ms() const {
  const std::lock_guard lock(mutex_);
  return latencies_ms_;
}

double Percentile(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return 0;
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
  return sorted[std::min(std::max<std::size_t>(rank, 1), sorted.size()) - 1];
}

std::string Summary(const Tally& tally, std::uint64_t num_captured, const CameraLosses& losses,
                    std::uint64_t num_reopened) {
  const Tally::Counts c = tally.Snapshot();
  std::string text = fmt::sprintf(
      "%llu frames captured, %llu sent, %llu answered, %llu failed; %llu %s\n", num_captured,
      c.sent, c.answered, c.failed, c.objects, c.objects == 1 ? "object" : "objects");
  text += fmt::sprintf(
      "dropped: %llu by the camera, %llu by this client, %llu by the server; %llu lost\n",
      losses.missed, c.replaced, c.dropped, c.lost);
  if (losses.unpaired + losses.wrong_size + num_reopened > 0) {
    text += fmt::sprintf(
        "camera: %llu images without a partner, %llu of a wrong size, reopened %llu "
        "times\n",
        losses.unpaired, losses.wrong_size, num_reopened);
  }
  std::vector<double> times = tally.Latencies_ms();
  if (times.empty()) return text;
  std::sort(times.begin(), times.end());
  return text + fmt::sprintf(
                    "latency from frame to result: median %.0f ms, 90 %% %.0f ms, 99 %% %.0f "
                    "ms, longest %.0f ms\n",
                    Percentile(times, 0.5), Percentile(times, 0.9), Percentile(times, 0.99),
                    times.back());
}

std::string CpuUse(double seconds) {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const double used = Seconds(usage.ru_utime) + Seconds(usage.ru_stime);
  std::string text = fmt::sprintf("processor time of this client: %.1f s", used);
  constexpr double kTellingSeconds = 1;  // starting takes more than its share of a short run
  if (seconds >= kTellingSeconds) {
    text += fmt::sprintf(" in %.1f s, %.0f %% of one core", seconds, 100 * used / seconds);
  }
  return text + "\n";
}

}  // namespace fovea::capture
