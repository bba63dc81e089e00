#include "tests/evaluation/saliency/saliency_methods.h"

#include <map>
#include <opencv2/imgproc.hpp>
#include <opencv2/saliency.hpp>
#include <stdexcept>

#include "core/options.h"
#include "core/saliency/strength_saliency.h"
#include "tests/evaluation/saliency/map_filters.h"

namespace fovea::evaluation {
namespace {

using Compute = std::function<cv::Mat(const cv::Mat&)>;

constexpr double kCenterShare = 0.25;

Compute Strength(const char* profile) {
  return [options = OptionsOfProfile(profile).color_saliency](const cv::Mat& color_rgb) {
    return StrengthSaliency(color_rgb, options);
  };
}

// A new instance each time: they keep state while they compute.
template <typename OpenCvMethod>
cv::Mat OpenCvSaliency(const cv::Mat& color_rgb) {
  cv::Mat color_bgr, saliency, map;
  cv::cvtColor(color_rgb, color_bgr, cv::COLOR_RGB2BGR);
  if (!OpenCvMethod::create()->computeSaliency(color_bgr, saliency)) {
    throw std::runtime_error("OpenCV computed no saliency");
  }
  saliency.convertTo(map, CV_32F);
  cv::resize(map, map, color_rgb.size());
  return map;
}

const std::map<std::string, Compute>& Methods() {
  static const std::map<std::string, Compute> kMethods = {
      {"strength", Strength("paper")},
      {"strength_default", Strength("default")},
      {"spectral_residual", OpenCvSaliency<cv::saliency::StaticSaliencySpectralResidual>},
      {"fine_grained", OpenCvSaliency<cv::saliency::StaticSaliencyFineGrained>},
      {"center", [](const cv::Mat& color) { return CenterPrior(color.size(), kCenterShare); }}};
  return kMethods;
}

}  // namespace

std::vector<std::string> SaliencyMethodNames() {
  return {"strength", "strength_default", "spectral_residual", "fine_grained", "center"};
}

SaliencyMethod MakeSaliencyMethod(const std::string& name) {
  const auto found = Methods().find(name);
  if (found == Methods().end()) {
    throw std::invalid_argument("saliency method: \"" + name + "\" is unknown");
  }
  return {name, found->second};
}

}  // namespace fovea::evaluation
