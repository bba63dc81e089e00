// How far places stand out from their surroundings along scan lines: the core of the anisotropic
// centre-surround difference (Ju et al. 2014).
#pragma once

#include <array>
#include <functional>
#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

namespace fovea {

// One of the eight directions: `count` samples at multiples of `step` from a pixel.
struct ScanLine {
  cv::Point step;
  int count = 0;
};

// The lines every 45°, sampled every `step_px` up to `length_px`. Steps along diagonals are
// rounded to whole pixels in x and y.
std::array<ScanLine, 8> ScanLines(double length_px, int step_px);

// The sum over the lines of a pixel's nearness minus the least nearness of the line, the pixel
// included. Samples without depth or outside the image do not count. `nearness`: as from
// SmoothNearness. Returns CV_32FC1 of its size, ≥ 0; 0 where there is no depth.
cv::Mat ContrastOfPixels(const cv::Mat& nearness, const std::array<ScanLine, 8>& lines);

// That, or what stands for it; some pixel of `nearness` has depth.
using Contrast =
    std::function<cv::Mat(const cv::Mat& nearness, const std::array<ScanLine, 8>& lines)>;

}  // namespace fovea
