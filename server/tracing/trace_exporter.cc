#include "server/tracing/trace_exporter.h"

#include <spdlog/spdlog.h>

#include <chrono>
#include <exception>
#include <utility>

namespace fovea::server {
namespace {

using std::chrono::milliseconds;

constexpr std::size_t kMaxWaiting = 512;  // frames, each of some 25 spans
constexpr milliseconds kBatch{500};       // how long others may come to the first
constexpr milliseconds kPatience{5000}, kLastPatience{500};

}  // namespace

TraceExporter::TraceExporter(HttpUrl url)
    : url_(std::move(url)), thread_([this](const std::stop_token& stop) { Run(stop); }) {}

TraceExporter::~TraceExporter() = default;

void TraceExporter::Add(FrameSpans frame) {
  const std::lock_guard lock(mutex_);
  if (waiting_.size() >= kMaxWaiting) {
    ++num_dropped_;
    return;
  }
  waiting_.push_back(std::move(frame));
  if (waiting_.size() == 1) changed_.notify_one();
}

void TraceExporter::Run(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (true) {
    const std::vector<FrameSpans> frames = Take(lock, stop);
    if (frames.empty()) return;
    lock.unlock();
    (Send(frames, stop) ? num_sent_ : num_dropped_) += frames.size();
    lock.lock();
    if (stop.stop_requested()) return;
  }
}

std::vector<FrameSpans> TraceExporter::Take(std::unique_lock<std::mutex>& lock,
                                            const std::stop_token& stop) {
  changed_.wait(lock, stop, [this] { return !waiting_.empty(); });
  changed_.wait_for(lock, stop, kBatch, [] { return false; });
  return std::exchange(waiting_, {});
}

bool TraceExporter::Send(const std::vector<FrameSpans>& frames, const std::stop_token& stop) {
  const bool last = stop.stop_requested();
  std::string problem;
  try {
    problem = PostJson(url_, OtlpJson(frames), last ? kLastPatience : kPatience,
                       [&] { return !last && stop.stop_requested(); });
  } catch (const std::exception& error) {
    problem = error.what();
  }
  if (!problem.empty() && !failing_) {
    spdlog::warn("--trace-endpoint: {}:{} takes no traces: {}", url_.host, url_.port, problem);
  }
  if (problem.empty() && failing_) spdlog::warn("--trace-endpoint: traces are taken again");
  failing_ = !problem.empty();
  return problem.empty();
}

}  // namespace fovea::server
