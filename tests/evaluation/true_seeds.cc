#include "tests/evaluation/true_seeds.h"

#include <cstdint>
#include <limits>
#include <map>
#include <stdexcept>

namespace fovea::evaluation {
namespace {

std::map<int, std::vector<cv::Point>> PixelsOfObjects(const cv::Mat& truth) {
  std::map<int, std::vector<cv::Point>> pixels;
  for (int row = 0; row < truth.rows; ++row) {
    const auto* label = truth.ptr<std::uint16_t>(row);
    for (int col = 0; col < truth.cols; ++col) {
      if (label[col] != 0) pixels[label[col]].emplace_back(col, row);
    }
  }
  return pixels;
}

cv::Point2d Centroid(const std::vector<cv::Point>& pixels) {
  cv::Point2d sum;
  for (const cv::Point& pixel : pixels) sum += cv::Point2d(pixel);
  return sum / static_cast<double>(pixels.size());
}

}  // namespace

std::vector<cv::Point> TrueSeeds(const Scene& scene) {
  std::vector<cv::Point> seeds;
  for (const auto& [label, pixels] : PixelsOfObjects(scene.truth)) {
    const cv::Point2d center = Centroid(pixels);
    double nearest = std::numeric_limits<double>::infinity();
    cv::Point seed;
    for (const cv::Point& pixel : pixels) {
      const cv::Point2d offset = cv::Point2d(pixel) - center;
      // False for pixels without depth, NaN or 0.
      if (scene.frame.depth_m.at<float>(pixel) > 0 && offset.dot(offset) < nearest) {
        nearest = offset.dot(offset);
        seed = pixel;
      }
    }
    if (nearest < std::numeric_limits<double>::infinity()) seeds.push_back(seed);
  }
  return seeds;
}

DetectFunction DetectFromTrueSeeds(const DetectorOptions& options) {
  if (!options.paper)
    throw std::invalid_argument("--true-seeds: profile \"paper\" alone takes them");
  return [options](const Scene& scene) {
    DetectorOptions seeded = options;
    seeded.paper->fixations = TrueSeeds(scene);
    return Detect(scene.frame, seeded);
  };
}

}  // namespace fovea::evaluation
