// Where people looked.
#pragma once

#include <filesystem>
#include <opencv2/core/types.hpp>
#include <string>
#include <vector>

namespace fovea::evaluation {

struct FixatedImage {
  std::string file;                  // name of the image in its folder
  std::vector<cv::Point> fixations;  // pixels, each once, in the order of rows
};

// Reads a JSON object {image file: [[x, y], …], …}; images come in the order of their names. A
// pixel that several people fixated counts once, as in the binary maps of the usual benchmarks.
// Throws std::runtime_error, which names the file and the image, for anything else.
std::vector<FixatedImage> LoadFixations(const std::filesystem::path& path);

}  // namespace fovea::evaluation
