#include "tests/evaluation/saliency/fixations.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace fovea::evaluation {
namespace {

std::vector<cv::Point> Pixels(const nlohmann::json& pairs) {
  std::vector<cv::Point> pixels;
  for (const nlohmann::json& pair : pairs) {
    const auto [x, y] = pair.get<std::pair<int, int>>();
    pixels.emplace_back(x, y);
  }
  std::sort(pixels.begin(), pixels.end(), [](const cv::Point& a, const cv::Point& b) {
    return a.y != b.y ? a.y < b.y : a.x < b.x;
  });
  pixels.erase(std::unique(pixels.begin(), pixels.end()), pixels.end());
  return pixels;
}

}  // namespace

std::vector<FixatedImage> LoadFixations(const std::filesystem::path& path) {
  std::ifstream file(path);
  const nlohmann::json json = nlohmann::json::parse(file, nullptr, false);
  if (!json.is_object() || json.empty()) {
    throw std::runtime_error(path.string() + ": expected {\"image\": [[x, y], …], …}");
  }
  std::vector<FixatedImage> images;
  for (const auto& [name, pairs] : json.items()) {
    try {
      images.push_back({name, Pixels(pairs)});
    } catch (const nlohmann::json::exception&) {
      throw std::runtime_error(path.string() + ": " + name + ": expected pairs of pixels [x, y]");
    }
    if (images.back().fixations.empty()) {
      throw std::runtime_error(path.string() + ": " + name + ": no fixations");
    }
  }
  return images;
}

}  // namespace fovea::evaluation
