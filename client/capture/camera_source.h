#pragma once

#include <chrono>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>

#include "client/capture/camera.h"
#include "client/capture/camera_error.h"

namespace fovea::capture {

// A camera that comes back: pictures numbered over all openings.
class CameraSource {
 public:
  // Opens it; a camera that goes away later is waited for as long as `patience`. Throws
  // CameraError.
  CameraSource(const CameraOptions& options, std::chrono::milliseconds patience,
               std::ostream& notes);

  // Waits a moment at most. Throws CameraError where the camera does not come back.
  std::optional<Picture> Next();

  // What was seen until now and not taken is no next picture.
  void SkipWaiting();

  bool AtEnd() const { return camera_ && camera_->AtEnd(); }
  const Camera& CurrentCamera() const { return *camera_; }  // as it was when opened
  std::uint64_t NumPictures() const { return num_pictures_; }
  std::uint64_t NumReopened() const { return num_reopened_; }
  CameraLosses Losses() const;

 private:
  std::optional<Picture> NextOf(Camera& camera);
  void Lose(const std::string& reason);
  void GiveUpOrWait(const CameraError& error);
  void TryToReopen();

  CameraOptions options_;
  const std::chrono::milliseconds patience_;
  std::ostream& notes_;
  std::unique_ptr<Camera> camera_;  // none while it is away
  CameraLosses earlier_losses_;
  std::uint64_t num_pictures_ = 0, num_reopened_ = 0;
  // Until it delivers again, which an open camera need not do; none: it delivers.
  std::optional<std::chrono::steady_clock::time_point> away_since_;
};

}  // namespace fovea::capture
