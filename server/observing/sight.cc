#include "server/observing/sight.h"

namespace fovea::server {
namespace {

std::size_t BytesOf(const cv::Mat& image) { return image.total() * image.elemSize(); }

}  // namespace

bool Sight::IsProblem() const {
  if (!status.ok() || detections.incomplete) return true;
  return detections.objects.empty() && !detections.diagnostics.messages.empty();
}

std::size_t Sight::NumBytes() const {
  constexpr std::size_t kRest = 16 << 10;  // names, options, objects
  const std::size_t answered = answer ? answer->SpaceUsedLong() : 0;
  return answered + frame.color().data().size() + frame.depth().data().size() +
         BytesOf(decoded.color_rgb) + BytesOf(decoded.depth_m) + BytesOf(detections.labels) +
         extras.SpaceUsedLong() + kRest;
}

}  // namespace fovea::server
