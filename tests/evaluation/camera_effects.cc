#include "tests/evaluation/camera_effects.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "tests/support/sensor_noise.h"

namespace fovea::evaluation {
namespace {

using scenes::Random;

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

cv::Mat ZeroWhereNone(const cv::Mat& depth_m) {
  cv::Mat zeroed = depth_m.clone();
  cv::patchNaNs(zeroed, 0);
  return zeroed;
}

void Stereo(RgbdFrame& frame, Random& random) {
  const cv::Mat measured = frame.depth_m == frame.depth_m;  // false for NaN
  frame.depth_m = scenes::WithStereoNoise(frame.depth_m, frame.intrinsics.fx_px, random);
  frame.depth_m.setTo(kNone, ~measured);
}

// The mean over 3 × 3 pixels, of those that are measured.
void FlyingPixels(RgbdFrame& frame, Random& /*random*/) {
  const cv::Mat depth = ZeroWhereNone(frame.depth_m);
  cv::Mat sum, count, measured;
  cv::Mat(depth > 0).convertTo(measured, CV_32F, 1.0 / 255);
  cv::boxFilter(depth, sum, CV_32F, {3, 3}, {-1, -1}, false);
  cv::boxFilter(measured, count, CV_32F, {3, 3}, {-1, -1}, false);
  cv::divide(sum, count, frame.depth_m);
  frame.depth_m.setTo(kNone, depth == 0);
}

void ErodedEdges(RgbdFrame& frame, Random& random) {
  constexpr double kWidth_px = 3.5;
  scenes::ErodeEdges(frame.depth_m, scenes::DepthEdges(frame.depth_m, {3, 3}), kWidth_px, kWidth_px,
                     random);
}

void Holes(RgbdFrame& frame, Random& random) {
  frame.depth_m.setTo(kNone, scenes::Noise(frame.depth_m.size(), 4, random) > 1.6);
}

void WhiteNoise(RgbdFrame& frame, Random& random) {
  constexpr double kDeviation = 0.003;  // of the depth
  frame.depth_m += kDeviation * frame.depth_m.mul(scenes::Noise(frame.depth_m.size(), 0, random));
}

void CoarseDepth(RgbdFrame& frame, Random& /*random*/) {
  cv::Mat half;
  cv::resize(frame.depth_m, half, {}, 0.5, 0.5, cv::INTER_NEAREST);
  cv::resize(half, frame.depth_m, frame.depth_m.size(), 0, 0, cv::INTER_NEAREST);
}

void MedianFilter(RgbdFrame& frame, Random& /*random*/) {
  const cv::Mat depth = ZeroWhereNone(frame.depth_m);
  cv::medianBlur(depth, frame.depth_m, 5);
  frame.depth_m.setTo(kNone, (depth == 0) | (frame.depth_m == 0));
}

void CoarseSteps(RgbdFrame& frame, Random& /*random*/) {
  constexpr float kStep_m = 0.005F;
  frame.depth_m.forEach<float>(
      [](float& depth, const int*) { depth = std::round(depth / kStep_m) * kStep_m; });
}

void MovedColor(RgbdFrame& frame, Random& /*random*/) {
  const cv::Matx23d move(1, 0, 4, 0, 1, 2);
  cv::warpAffine(frame.color_rgb.clone(), frame.color_rgb, move, frame.color_rgb.size(),
                 cv::INTER_NEAREST, cv::BORDER_REPLICATE);
}

void Grey(RgbdFrame& frame, Random& /*random*/) {
  cv::Mat grey;
  cv::cvtColor(frame.color_rgb, grey, cv::COLOR_RGB2GRAY);
  cv::cvtColor(grey, frame.color_rgb, cv::COLOR_GRAY2RGB);
}

void Darken(RgbdFrame& frame, Random& random, double brightness, double deviation) {
  frame.color_rgb.forEach<cv::Vec3b>([brightness](cv::Vec3b& color, const int*) {
    for (int i = 0; i < 3; ++i) color[i] = cv::saturate_cast<uchar>(brightness * color[i]);
  });
  std::vector<cv::Mat> channels;
  cv::split(frame.color_rgb, channels);
  for (cv::Mat& channel : channels) {
    cv::add(channel, deviation * scenes::Noise(channel.size(), 0, random), channel, {}, CV_8U);
  }
  cv::merge(channels, frame.color_rgb);
}

void Dark(RgbdFrame& frame, Random& random) { Darken(frame, random, 0.3, 5); }

void Dusk(RgbdFrame& frame, Random& random) { Darken(frame, random, 0.1, 5); }

void Night(RgbdFrame& frame, Random& random) { Darken(frame, random, 0, 2); }

struct Effect {
  CameraEffect text;
  void (*apply)(RgbdFrame&, Random&);
};

const std::vector<Effect>& Effects() {
  static const std::vector<Effect> effects = {
      {{"stereo", "edges given to what is nearer, noise of 3 mm at 1 m over 5 px"}, Stereo},
      {{"flying_pixels", "depth averaged over 3x3 pixels, across edges too"}, FlyingPixels},
      {{"eroded_edges", "no depth within 3.5 px of edges"}, ErodedEdges},
      {{"holes", "no depth in blobs, a twentieth of the image"}, Holes},
      {{"white_noise", "3 mm at 1 m in every pixel on its own"}, WhiteNoise},
      {{"coarse_depth", "half of the resolution"}, CoarseDepth},
      {{"median", "depth filtered by a 5x5 median"}, MedianFilter},
      {{"coarse_steps", "depth in steps of 5 mm"}, CoarseSteps},
      {{"moved_color", "colour 4 px right and 2 px down of depth"}, MovedColor},
      {{"grey", "no colour"}, Grey},
      {{"dark", "three tenths of the brightness, noise of 5 of 255"}, Dark},
      {{"dusk", "a tenth of it, the same noise"}, Dusk},
      {{"night", "nothing but noise of 2 in the colour image"}, Night},
  };
  return effects;
}

}  // namespace

const std::vector<CameraEffect>& CameraEffects() {
  static const std::vector<CameraEffect> texts = [] {
    std::vector<CameraEffect> all;
    for (const Effect& effect : Effects()) all.push_back(effect.text);
    return all;
  }();
  return texts;
}

RgbdFrame WithCameraEffect(const RgbdFrame& frame, const std::string& name, std::uint64_t seed) {
  const auto found = std::find_if(Effects().begin(), Effects().end(),
                                  [&](const Effect& effect) { return effect.text.name == name; });
  if (found == Effects().end()) throw std::invalid_argument(name + ": no such camera effect");
  RgbdFrame changed = frame;
  changed.color_rgb = frame.color_rgb.clone();
  changed.depth_m = frame.depth_m.clone();
  Random random(seed);
  found->apply(changed, random);
  return changed;
}

}  // namespace fovea::evaluation
