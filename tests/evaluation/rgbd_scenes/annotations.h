// The annotations of the RGB-D Scenes data set (Lai et al. 2011; the paper's reference [20]).
#pragma once

#include <filesystem>
#include <opencv2/core/types.hpp>
#include <string>
#include <vector>

namespace fovea::evaluation {

struct AnnotatedObject {
  std::string category;  // "bowl", "cap", …
  cv::Rect box;          // pixels of the colour image
};

// The objects of each frame of a sequence, frame 1 first: variable `bboxes` of a MATLAB file, a
// cell for each frame with a struct array of `category`, `instance`, `top`, `bottom`, `left` and
// `right` (pixels from 1, both ends inside). Throws std::runtime_error, which names the file and
// what in it is not so.
std::vector<std::vector<AnnotatedObject>> ReadAnnotations(const std::filesystem::path& file);

}  // namespace fovea::evaluation
