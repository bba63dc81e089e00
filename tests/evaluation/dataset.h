// Labelled RGB-D scenes in a folder.
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "core/types/rgbd_frame.h"

namespace fovea::evaluation {

// What the values of a label image mean.
enum class LabelEncoding {
  kPlain,  // 0 = not an object, k = object k
  kMosd,  // 0 = none, 1 … 9 = the table, 20 … 29 = parts of the first object, 30 … the second …
  kBoxes,  // no label images but boxes drawn by hand: tests/evaluation/real_frames
};

struct Scene {
  std::string name;
  RgbdFrame frame;
  cv::Mat truth;  // CV_16UC1, 0 = not an object, k = object k
  cv::Mat valid;  // CV_8UC1, 0 where the ground truth has no depth
};

// Reads 8-bit colour and 16-bit depth in millimetres (0 = none) of one size. Throws
// std::runtime_error, which names the file, if one cannot be read or has the wrong type or size.
RgbdFrame LoadFrame(const std::filesystem::path& color, const std::filesystem::path& depth,
                    const CameraIntrinsics& intrinsics);

// The names of all scenes in a folder, numbers in their numerical order: those with
// `<name>_color.png`, `<name>_depth.png` and `<name>_label.png`. Throws std::runtime_error if
// there are none.
std::vector<std::string> SceneNames(const std::filesystem::path& folder);

// Reads one scene: a frame and 8-bit labels. If `<name>_labelled_depth.png` exists, labels hold
// only where it has depth. Throws like LoadFrame.
Scene LoadScene(const std::filesystem::path& folder, const std::string& name,
                LabelEncoding encoding, const CameraIntrinsics& intrinsics);

}  // namespace fovea::evaluation
