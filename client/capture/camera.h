#pragma once

#include <chrono>
#include <cstdint>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>

#include "client/capture/camera_options.h"
#include "client/capture/intrinsics.h"
#include "client/capture/picture.h"

namespace fovea::capture {

// What became of the images of a camera that made no picture.
struct CameraLosses {
  std::uint64_t missed = 0;      // gaps in the numbers of the depth images
  std::uint64_t unpaired = 0;    // images without a partner of the same moment
  std::uint64_t wrong_size = 0;  // images of another size than set, or cut short
};

// An open camera or recording that delivers.
class Camera {
 public:
  Camera() = default;
  virtual ~Camera() = default;

  Camera(const Camera&) = delete;
  Camera& operator=(const Camera&) = delete;

  // The next picture, where one comes within `patience`. Throws CameraLost where the camera was
  // unplugged or fell silent, CameraError where it never delivered.
  virtual std::optional<Picture> Next(std::chrono::milliseconds patience) = 0;

  // For whoever has not called Next() for a while: lets go of images that wait to be taken, of
  // which recordings have none, and does not take that time for silence. Throws CameraLost.
  virtual void SkipWaiting() = 0;

  // Of a recording: all its frames were delivered.
  virtual bool AtEnd() const = 0;

  // By which CameraOptions.device finds it again.
  virtual std::string Name() const = 0;
  virtual const std::string& Uri() const = 0;
  virtual cv::Size size() const = 0;  // of colour
  virtual FieldOfView StatedFieldOfView() const = 0;
  virtual CameraLosses Losses() const = 0;
};

// By its name: a recording, nodes of V4L2, or a camera of OpenNI2. `notes` gets what a person
// should know. Throws CameraError.
std::unique_ptr<Camera> OpenCamera(const CameraOptions& options, std::ostream& notes);

}  // namespace fovea::capture
