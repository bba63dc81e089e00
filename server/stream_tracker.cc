#include "server/stream_tracker.h"

#include <chrono>
#include <random>

#include "server/conversion/field_error.h"
#include "server/conversion/tracking.h"

namespace fovea::server {
namespace {

// Two servers, or one before and after its restart, must not choose the same. Not 0, and exact in
// languages whose numbers are doubles.
std::uint64_t RandomEpoch() {
  thread_local std::mt19937_64 random((static_cast<std::uint64_t>(std::random_device{}()) << 32U) |
                                      std::random_device{}());
  constexpr std::uint64_t kLargest = (std::uint64_t{1} << 53U) - 1;
  return std::uniform_int_distribution<std::uint64_t>(1, kLargest)(random);
}

}  // namespace

void StreamTracker::Add(const v1::Frame& proto, const v1::TrackingOptions& options,
                        const RgbdFrame& frame, Detections& detections,
                        std::vector<StageTime>* times) {
  if (!options.enabled()) {
    tracker_.reset();
    return;
  }
  const auto began = std::chrono::steady_clock::now();
  if (!tracker_ || options.reset() != reset_) tracker_.emplace(RandomEpoch());
  reset_ = options.reset();
  tracker_->Add(frame, ContextOf(proto), detections);
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - began;
  times->push_back({"tracking", took.count()});
}

void RequireStream(const v1::DetectOptions& options, const StreamTracker* tracker) {
  RequireField(!options.tracking().enabled() || tracker != nullptr, "options.tracking.enabled",
               "needs a stream of frames; call DetectStream");
}

}  // namespace fovea::server
