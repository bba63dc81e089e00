#include "core/detector.h"

namespace fovea {

Detections Detect(const RgbdFrame& frame, const DetectorOptions&, Trace*,
                  const std::function<bool()>&) {
  Validate(frame);
  Detections detections;
  detections.labels = cv::Mat::zeros(frame.depth_m.size(), CV_16UC1);
  return detections;
}

}  // namespace fovea
