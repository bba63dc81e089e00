#pragma once

#include <opencv2/core/types.hpp>
#include <optional>
#include <stdexcept>
#include <string>

#include "client/cli/intrinsics_flag.h"
#include "fovea/v1/frame.pb.h"

namespace fovea::capture {

// Where the intrinsics come from, best first; empty = not given.
struct IntrinsicsFlags {
  std::string calibration_path;
  std::string numbers_or_file;  // FX,FY,CX,CY, or the path of a calibration, too
  std::string distortion;       // MODEL=K1,… or none, in place of the calibration's
};

// What the flags say, read before there is a camera.
struct KnownIntrinsics {
  std::optional<cli::GivenIntrinsics> camera;  // none = what the camera states is taken
  std::string distortion;                      // as the flag has it
};

// Throws std::exception with one line of text that names the flag or the file.
KnownIntrinsics ReadIntrinsics(const IntrinsicsFlags& flags);

// Throws std::runtime_error where a file is for another image size.
void RequireSize(const KnownIntrinsics& known, const cv::Size& size);

// What the camera states about its colour stream; 0 where it states nothing.
struct FieldOfView {
  double horizontal_rad = 0, vertical_rad = 0;
};

struct ChosenIntrinsics {
  v1::CameraIntrinsics values;
  std::string source;   // for people: "from the calibration file cam.yaml"
  std::string warning;  // empty = none
};

// A pinhole in the middle of the image. Angles must be in (0, π).
v1::CameraIntrinsics FromFieldOfView(const FieldOfView& view, const cv::Size& size);

// Nothing is known of them.
class NoIntrinsics : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Throws std::runtime_error where a file is for another image size, and NoIntrinsics.
ChosenIntrinsics ChooseIntrinsics(const KnownIntrinsics& known, const FieldOfView& view,
                                  const cv::Size& size);

// As a file that --calibration and --intrinsics read. Throws std::runtime_error.
void SaveIntrinsics(const std::string& path, const v1::CameraIntrinsics& values,
                    const cv::Size& size);

// Where the intrinsics of a recording lie: "kitchen.intrinsics.json" of "kitchen.oni".
std::string IntrinsicsPathOf(const std::string& recording);

// "fx 525.0, fy 525.0, cx 319.5, cy 239.5, from the calibration file cam.yaml".
std::string Describe(const ChosenIntrinsics& intrinsics);

}  // namespace fovea::capture
