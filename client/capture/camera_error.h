#pragma once

#include <stdexcept>
#include <string>

namespace fovea::capture {

// One line of text that says what is wrong with the camera and what helps.
class CameraError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A camera that worked is gone: unplugged, or it fell silent. It may come back.
class CameraLost : public CameraError {
 public:
  using CameraError::CameraError;
};

// The camera `uri` could not be opened; `reason` is what OpenNI2 says.
CameraError CannotOpen(const std::string& uri, const std::string& reason);

// Throws where `path` is no file that OpenNI2 can have recorded.
void CheckRecording(const std::string& path);

bool IsRecording(const std::string& device);

// OpenNI2's own words, in one line.
std::string OpenNiReason();

}  // namespace fovea::capture
