#include "tests/server/detectors.h"

namespace fovea::testing {

Detections FindOne(const RgbdFrame& frame, const DetectorOptions& /*options*/, Trace* trace,
                   const std::function<bool()>& /*should_stop*/) {
  Detections detections;
  detections.labels = cv::Mat::zeros(frame.depth_m.size(), CV_16UC1);
  DetectedObject object;
  object.label = 1;
  object.confidence = 0.75F;
  object.bounds_px = {10, 8, 4, 3};
  detections.labels(object.bounds_px).setTo(1);
  detections.labels.at<std::uint16_t>(8, 10) = 0;
  object.num_pixels = 11;
  object.box.center = {0.1F, 0.2F, 1.0F};
  object.box.size_m = {0.3F, 0.2F, 0.1F};
  object.grasps.resize(1);
  object.cloud.push_back({.x = 1, .y = 2, .z = 3});
  detections.objects = {object};
  detections.stage_times = {{"first", 1.5}};
  if (trace != nullptr) {
    trace->color_saliency = cv::Mat::eye(frame.depth_m.size(), CV_32FC1);
    trace->seeds.resize(2);
  }
  return detections;
}

}  // namespace fovea::testing
