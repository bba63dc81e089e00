#pragma once

#include <Driver/OniDriverAPI.h>

#include <atomic>
#include <functional>
#include <opencv2/core/mat.hpp>

namespace fovea::testing {

// Colour or depth of the test camera.
class DriverStream : public oni::driver::StreamBase {
 public:
  // `on_start` is told when the stream starts or stops.
  DriverStream(OniSensorType type, const OniVideoMode& mode, std::function<void()> on_start);

  OniStatus start() override;
  void stop() override;
  OniStatus getProperty(int id, void* data, int* size) override;
  OniStatus setProperty(int id, const void* data, int size) override;
  OniBool isPropertySupported(int id) override;

  bool Running() const { return running_; }
  // Hands out one image: CV_8UC3, R first, or CV_16UC1.
  void Deliver(const cv::Mat& image, int index, std::uint64_t time_us, bool only_half = false);

 private:
  const OniSensorType type_;
  OniVideoMode mode_;
  const std::function<void()> on_start_;
  OniBool mirrored_ = TRUE;  // as cameras wake up
  std::atomic<bool> running_ = false;
};

}  // namespace fovea::testing
