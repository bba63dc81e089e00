#pragma once

#include <OpenNI.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <iosfwd>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>

#include "client/capture/camera_setup.h"
#include "client/capture/devices.h"
#include "client/capture/intrinsics.h"
#include "client/capture/pairing.h"
#include "client/capture/picture.h"

namespace fovea::capture {

// What became of the images of a camera that made no picture.
struct CameraLosses {
  std::uint64_t missed = 0;      // gaps in the numbers of the depth images
  std::uint64_t unpaired = 0;    // images without a partner of the same moment
  std::uint64_t wrong_size = 0;  // images of another size than set
};

// An open camera or recording that delivers.
class Camera {
 public:
  // Opens and starts it; `notes` gets what a person should know. Throws CameraError.
  Camera(const CameraOptions& options, std::ostream& notes);
  ~Camera();

  Camera(const Camera&) = delete;
  Camera& operator=(const Camera&) = delete;

  // The next picture, where one comes within `patience`. Throws CameraLost where the camera was
  // unplugged or fell silent, CameraError where it never delivered.
  std::optional<Picture> Next(std::chrono::milliseconds patience);

  // No more frames come.
  void Stop();

  // Of a recording: all its frames were delivered.
  bool AtEnd() const;

  const std::string& Uri() const { return uri_; }
  cv::Size size() const { return options_.size; }
  FieldOfView StatedFieldOfView() const;
  CameraLosses Losses() const;
  Streams& BothStreams() { return streams_; }

 private:
  void StartRecording(std::ostream& notes);
  void SetSpeed(double speed);
  void StartCamera(std::ostream& notes);
  void Start();
  std::optional<Picture> Read(std::size_t index);
  void CheckSilence() const;

  CameraOptions options_;
  const std::string uri_;
  UnplugWatch watch_;
  openni::Device device_;
  Streams streams_;
  const std::array<openni::VideoStream*, 2> both_{&streams_.color, &streams_.depth};
  std::array<int, 2> last_index_{0, 0};
  std::optional<Pairing<cv::Mat>> pairing_;
  CameraLosses losses_;
  double depth_unit_m_ = 0.001;
  bool read_ = false, delivered_ = false;
  std::chrono::steady_clock::time_point last_arrival_;
};

}  // namespace fovea::capture
