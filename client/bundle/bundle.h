#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/bundle/zip_reader.h"
#include "fovea/v1/detection_service.pb.h"

namespace fovea::bundle {

// One frame of a bug report.
struct BundledFrame {
  v1::DetectRequest request = {};                       // frame and options as the robot sent them
  std::optional<v1::Detections> answer = std::nullopt;  // as the robot got it
  std::optional<v1::FrameError> error = std::nullopt;   // or this
  std::string robot = {}, server = {}, server_version = {};
  std::chrono::system_clock::time_point answered_at = {};
  double took_ms = 0;  // from its arrival to its answer
};

// What the bundle as a whole says of itself.
struct BundleNote {
  std::string made_by = {};      // program and version
  std::size_t num_left_out = 0;  // frames that were there and found no room
};

// A zip file of frame_0001_color.png (or .jpg), frame_0001_depth.png, frame_0001_options.json,
// frame_0001_answer.json and .pb, frame_0001_request.pb, and so on, with intrinsics.json and
// fovea_capture.json of the first, bundle.json and README.txt. Unpacked, it is a folder that `fovea
// detect --input` reads; request.pb alone is what was sent, byte for byte. Throws
// std::runtime_error.
std::string WriteBundle(std::vector<BundledFrame> frames, const BundleNote& note);

// The same in the other direction. Thread-safe.
class Bundle {
 public:
  // Throws std::invalid_argument that says what is wrong.
  explicit Bundle(std::string zip, const ZipLimits& limits = {});

  // "frame_0001", in order.
  const std::vector<std::string>& names() const { return names_; }

  // Throw std::invalid_argument that names the file.
  v1::DetectRequest RequestOf(const std::string& name) const;
  std::optional<v1::Detections> AnswerOf(const std::string& name) const;  // none: it was an error

  // What it was refused with; none where there is no answer and nothing readable says why.
  std::optional<v1::FrameError> ErrorOf(const std::string& name) const;

  // The bytes of readable images; throw std::invalid_argument where they could not be made.
  std::string ColorFileOf(const std::string& name) const;
  std::string DepthFileOf(const std::string& name) const;

 private:
  void CheckAbout() const;

  const ZipReader zip_;
  std::vector<std::string> names_;
};

}  // namespace fovea::bundle
