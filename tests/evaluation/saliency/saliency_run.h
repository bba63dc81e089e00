// Runs saliency methods over images with fixations, blurs their maps and adds up the scores.
#pragma once

#include <filesystem>
#include <functional>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "tests/evaluation/saliency/fixations.h"
#include "tests/evaluation/saliency/saliency_methods.h"
#include "tests/evaluation/saliency/saliency_scores.h"

namespace fovea::evaluation {

struct SaliencyRunOptions {
  std::vector<double> sigmas = {0};  // of the blur of the maps, in image widths
  cv::BorderTypes border = cv::BORDER_CONSTANT;
  double center_prior = 0;       // its `share` (map_filters.h), multiplied after the blur; 0: none
  double fixation_sigma = 0.03;  // of the blurred fixations for CC, in image widths
  std::uint64_t seed = 1;        // of AUC-Borji
  int num_threads = 1;
};

// The scores of one method: [index of sigma][index of image].
struct SaliencyResult {
  std::string method;
  std::vector<std::vector<SaliencyScores>> scores;
  double median_ms = 0;  // of computing a map
};

// Called once per image and method with the map before blurring, one call at a time.
using MapDone =
    std::function<void(const FixatedImage&, const std::string& method, const cv::Mat& map)>;

// Scores every method on every image, `num_threads` images at a time; all methods and blurs of an
// image meet the same random pixels. Throws std::runtime_error, which names the file, for an image
// that cannot be read or a fixation outside it.
std::vector<SaliencyResult> RunSaliency(const std::filesystem::path& folder,
                                        const std::vector<FixatedImage>& images,
                                        const std::vector<SaliencyMethod>& methods,
                                        const SaliencyRunOptions& options,
                                        const MapDone& done = {});

}  // namespace fovea::evaluation
