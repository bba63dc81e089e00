#pragma once

#include <OpenNI.h>

#include <array>
#include <memory>
#include <opencv2/core/mat.hpp>

#include "client/capture/camera.h"
#include "client/capture/devices.h"
#include "client/capture/openni_setup.h"
#include "client/capture/pairing.h"

namespace fovea::capture {

// A camera or a recording of OpenNI2.
class OpenNiCamera : public Camera {
 public:
  // Opens and starts it; `notes` gets what a person should know. Throws CameraError.
  OpenNiCamera(const CameraOptions& options, std::ostream& notes);

  std::optional<Picture> Next(std::chrono::milliseconds patience) override;
  void SkipWaiting() override { silent_since_ = std::chrono::steady_clock::now(); }
  bool AtEnd() const override;
  std::string Name() const override { return NameWithoutPlace(uri_); }
  const std::string& Uri() const override { return uri_; }
  cv::Size size() const override { return options_.size; }
  FieldOfView StatedFieldOfView() const override;
  CameraLosses Losses() const override;

  // No more frames come.
  void Stop();
  Streams& BothStreams() { return streams_; }
  // Whether an image of one of them has come that Next() has not looked at.
  bool ImageWaits() const;
  // Between two images of a stream, as the camera says.
  std::uint64_t PeriodUs() const { return period_us_; }

 private:
  struct Opened {
    openni::Device device;
    Streams streams;
  };
  struct Closing {
    void operator()(Opened* opened) const;
  };

  void StartRecording(std::ostream& notes);
  void SetSpeed(double speed);
  void StartCamera(std::ostream& notes);
  void Start();
  std::optional<Picture> Read(std::size_t index);
  void CheckSilence() const;
  // The stream that has an image.
  std::optional<std::size_t> Await(std::chrono::milliseconds patience) const;

  CameraOptions options_;
  const std::string uri_;
  UnplugWatch watch_;
  const std::unique_ptr<Opened, Closing> opened_{new Opened};
  openni::Device& device_ = opened_->device;
  Streams& streams_ = opened_->streams;
  const std::array<openni::VideoStream*, 2> both_{&streams_.color, &streams_.depth};
  std::array<int, 2> last_index_{0, 0};
  std::optional<Pairing<cv::Mat>> pairing_;
  CameraLosses losses_;
  double depth_unit_m_ = 0.001;
  std::uint64_t period_us_ = 0;
  bool read_ = false, delivered_ = false;
  std::chrono::steady_clock::time_point silent_since_;
};

}  // namespace fovea::capture
