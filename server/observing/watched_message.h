#pragma once

#include <grpcpp/support/slice.h>

#include <cstdint>
#include <optional>
#include <string>

#include "fovea/v1/observation_service.pb.h"
#include "server/observing/sight.h"
#include "server/observing/wish.h"

namespace fovea::server {

// The messages that show one frame to watchers who want different parts of it. Each part is made
// once, when it is first asked for.
class WatchedMessages {
 public:
  WatchedMessages(const Sight& sight, std::uint64_t max_pixels)
      : sight_(sight), max_pixels_(max_pixels) {}

  // A WatchResponse with these parts, without `dropped`.
  grpc::Slice With(WatchParts parts);

 private:
  v1::WatchedFrame Base() const;
  void AddAnswer(bool whole, v1::WatchedFrame* frame);
  void AddPictures(WatchParts parts, v1::WatchedFrame* frame);

  const Sight& sight_;
  const std::uint64_t max_pixels_;
  std::optional<v1::Detections> answer_;
  std::optional<std::string> preview_, picture_;
  std::optional<v1::WatchedDepth> depth_;
};

}  // namespace fovea::server
