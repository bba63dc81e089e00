#include "server/tracing/trace_exporter.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

#include "server/logging/log_limiter.h"
#include "server/logging/log_record.h"
#include "server/tracing/refused_spans.h"

namespace fovea::server {
namespace {

using std::chrono::milliseconds;

constexpr std::size_t kMaxWaiting = 512;  // frames, each of some 25 spans
constexpr milliseconds kBatch{500};       // how long others may come to the first
constexpr milliseconds kPatience{5000}, kLastPatience{500};

constexpr std::size_t kMaxReason = 300;  // bytes

std::size_t NumSpans(const std::vector<FrameSpans>& frames) {
  std::size_t count = 0;
  for (const FrameSpans& frame : frames) count += frame.size();
  return count;
}

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
    const std::size_t num_dropped = Send(frames, stop);
    num_dropped_ += num_dropped;
    num_sent_ += frames.size() - num_dropped;
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

std::size_t TraceExporter::Send(const std::vector<FrameSpans>& frames,
                                const std::stop_token& stop) {
  const bool last = stop.stop_requested();
  PostResult result;
  RefusedSpans refused;
  try {
    result = PostJson(url_, OtlpJson(frames), last ? kLastPatience : kPatience,
                      [&] { return !last && stop.stop_requested(); });
    refused = RefusedSpansIn(result.body);
  } catch (const std::exception& error) {
    result.problem = error.what();
  }
  if (!result.problem.empty()) {
    Tell(Taken::kNone, "takes no traces: " + result.problem);
    return frames.size();
  }
  const std::size_t num_spans = NumSpans(frames);
  const std::size_t num_refused = std::min<std::size_t>(refused.count, num_spans);
  Tell(num_refused == 0 ? Taken::kAll : Taken::kSome,
       fmt::format("refuses {} of {} spans: \"{}\"", num_refused, num_spans,
                   Harmless(refused.reason.substr(0, kMaxReason))));
  return num_refused == 0 ? 0 : (num_refused * frames.size() + num_spans - 1) / num_spans;
}

void TraceExporter::Tell(Taken taken, const std::string& problem) {
  if (taken == std::exchange(taken_, taken)) return;
  // Limited: a collector may take and refuse by turns.
  LogLimited("--trace-endpoint", spdlog::level::warn,
             "--trace-endpoint: " + (taken == Taken::kAll ? "traces are taken again"
                                                          : url_.Authority() + " " + problem));
}

}  // namespace fovea::server
