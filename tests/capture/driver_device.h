#pragma once

#include <Driver/OniDriverAPI.h>

#include <array>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <opencv2/core/mat.hpp>
#include <thread>
#include <vector>

#include "tests/capture/driver_options.h"
#include "tests/capture/driver_stream.h"

namespace fovea::testing {

// The test camera while it is open: serves its frames once both streams run.
class DriverDevice : public oni::driver::DeviceBase {
 public:
  // `opening`: how often the camera has been opened, with this time.
  DriverDevice(DriverOptions options, int opening);
  ~DriverDevice() override;

  OniStatus getSensorInfoList(OniSensorInfo** infos, int* count) override;
  oni::driver::StreamBase* createStream(OniSensorType type) override;
  void destroyStream(oni::driver::StreamBase* stream) override;
  OniStatus getProperty(int id, void* data, int* size) override;
  OniStatus setProperty(int id, const void* data, int size) override;
  OniBool isPropertySupported(int id) override;
  OniBool isImageRegistrationModeSupported(OniImageRegistrationMode mode) override;
  // Somebody waits for a frame.
  OniStatus tryManualTrigger() override;

 private:
  struct Image {
    cv::Mat color, depth;
  };

  void LoadFrames();
  bool BothRun() const;
  bool IsSilent(int index) const;
  void Serve();
  void ServeFrame(int index);
  void DeliverColor(int index, const cv::Mat& color);
  const Image& ImageOf(int index) const;

  const DriverOptions options_;
  const int opening_;  // from 1
  std::vector<Image> images_;
  std::array<std::vector<OniVideoMode>, 2> modes_;
  std::array<OniSensorInfo, 2> infos_{};
  OniImageRegistrationMode registration_ = ONI_IMAGE_REGISTRATION_OFF;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  DriverStream *color_ = nullptr, *depth_ = nullptr;
  bool wanted_ = false, serving_ = false, closing_ = false;
  int owed_color_ = 0;  // index of a colour image that comes late; only of the thread
  std::jthread thread_;
};

}  // namespace fovea::testing
