#include "client/cli/step_pictures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

#include "client/cli/lens.h"
#include "client/cli/overlay/drawing.h"
#include "client/cli/overlay/extras.h"
#include "client/cli/overlay/palette.h"

namespace fovea::cli {
namespace {

void RequireFits(bool fits, const char* what) {
  if (!fits) throw std::runtime_error(std::string("the server's answer has a broken ") + what);
}

cv::Mat Grey(const cv::Mat& color) {
  cv::Mat grey;
  cv::cvtColor(color, grey, cv::COLOR_BGR2GRAY);
  cv::cvtColor(grey, grey, cv::COLOR_GRAY2BGR);
  return grey;
}

// The bytes of `Image`, a 16-bit image of the frame's size; lives as long as they do.
template <typename Image>
cv::Mat Pixels16(const Image& image, const cv::Size& frame, const char* what) {
  const bool same = image.width() == static_cast<std::uint32_t>(frame.width) &&
                    image.height() == static_cast<std::uint32_t>(frame.height);
  RequireFits(same && image.data().size() == frame.area() * sizeof(std::uint16_t), what);
  return {frame, CV_16UC1, const_cast<char*>(image.data().data())};
}

// Seeds sent by the server must lie in the frame that they are drawn on.
template <typename Seed>
cv::Point PixelOf(const Seed& seed, const cv::Size& frame) {
  RequireFits(seed.x() < static_cast<std::uint32_t>(frame.width) &&
                  seed.y() < static_cast<std::uint32_t>(frame.height),
              "seed");
  return {static_cast<int>(seed.x()), static_cast<int>(seed.y())};
}

// exp(−γ‖x − x₀‖²) of every point, CV_32FC1; 0 where there is no depth.
// `rays`: of the pixels of depth_m.
cv::Mat Probability(const cv::Mat& depth_m, const cv::Mat& rays, const v1::Vector3& seed,
                    double gamma_per_m2) {
  cv::Mat probability(depth_m.size(), CV_32FC1, cv::Scalar(0));
  for (int row = 0; row < depth_m.rows; ++row) {
    for (int col = 0; col < depth_m.cols; ++col) {
      const double z = depth_m.at<float>(row, col);
      if (!(z > 0)) continue;
      const auto& ray = rays.at<cv::Vec2d>(row, col);
      const cv::Vec3d offset(ray[0] * z - seed.x(), ray[1] * z - seed.y(), z - seed.z());
      probability.at<float>(row, col) =
          static_cast<float>(std::exp(-gamma_per_m2 * offset.dot(offset)));
    }
  }
  return probability;
}

// One frame, half as large, with the hypothesis in warm colours over it.
cv::Mat HypothesisTile(const cv::Mat& grey, const cv::Mat& probability, const cv::Point& seed,
                       int number) {
  cv::Mat bytes, heat, tile = grey * 0.35;
  probability.convertTo(bytes, CV_8U, 255);
  cv::applyColorMap(bytes, heat, cv::COLORMAP_INFERNO);
  cv::addWeighted(tile, 1, heat, 1, 0, tile);
  DrawCross(tile, seed, 9, kRed);
  const cv::Size half(std::max(1, tile.cols / 2), std::max(1, tile.rows / 2));
  cv::resize(tile, tile, half, 0, 0, cv::INTER_AREA);
  DrawBadge(tile, {4, 4}, {std::to_string(number)}, kRed);
  return tile;
}

}  // namespace

cv::Mat DepthPicture(const cv::Mat& depth_m) {
  double nearest = 0, farthest = 0;
  const cv::Mat known = depth_m > 0;
  cv::minMaxLoc(depth_m, &nearest, &farthest, nullptr, nullptr, known);
  const double span = std::max(farthest - nearest, 1e-6);
  cv::Mat bytes, picture;
  depth_m.convertTo(bytes, CV_8U, -235 / span, 245 + 235 * nearest / span);
  cv::applyColorMap(bytes, picture, cv::COLORMAP_TURBO);
  picture.setTo(cv::Scalar::all(0), ~known);
  return picture;
}

cv::Mat SaliencyPicture(const v1::SaliencyMap& map, const cv::Size& frame) {
  RequireFits(map.width() == static_cast<std::uint32_t>(frame.width) &&
                  map.height() == static_cast<std::uint32_t>(frame.height) &&
                  map.data().size() == static_cast<std::size_t>(frame.area()),
              "saliency map");
  const cv::Mat bytes(frame, CV_8UC1, const_cast<char*>(map.data().data()));
  cv::Mat picture;
  cv::applyColorMap(bytes, picture, cv::COLORMAP_INFERNO);
  return picture;
}

cv::Mat SeedPicture(const cv::Mat& color, const v1::Trace& trace) {
  cv::Mat picture = color.clone();
  int without_depth = 0;
  for (const v1::RemovedSeed& seed : trace.removed_seeds()) {
    const bool no_depth = seed.reason() == v1::SEED_REMOVAL_WITHOUT_DEPTH;
    without_depth += no_depth ? 1 : 0;
    DrawCross(picture, PixelOf(seed, color.size()), 6, no_depth ? kBlue : kYellow);
  }
  for (const v1::Seed& seed : trace.seeds()) {
    DrawCross(picture, PixelOf(seed, color.size()), 8, kRed);
  }
  const int on_support = trace.removed_seeds_size() - without_depth;
  int y = 4;
  const auto legend = [&](const cv::Scalar& background, int number, const char* what) {
    const std::string text = std::to_string(number) + " " + what;
    DrawBadge(picture, {4, y}, {text}, background);
    y += BadgeSize({text}).height + 2;
  };
  legend(kRed, trace.seeds_size(), "seeds");
  legend(kYellow, on_support, "removed: on the support");
  legend(kBlue, without_depth, "removed: no depth");
  return picture;
}

cv::Mat HypothesesPicture(const cv::Mat& color, const cv::Mat& depth_m,
                          const v1::CameraIntrinsics& intrinsics, const v1::Trace& trace) {
  constexpr int kMost = 16, kColumns = 4;
  const int count = std::min(trace.seeds_size(), kMost);
  const cv::Mat grey = Grey(color);
  const cv::Size tile((color.cols + 1) / 2, (color.rows + 1) / 2);
  const int columns = std::clamp(count, 1, kColumns);
  const int rows = std::max(1, (count + columns - 1) / columns);
  cv::Mat picture(tile.height * rows, tile.width * columns, CV_8UC3, cv::Scalar::all(0));
  const cv::Mat rays = RaysOf(intrinsics, depth_m.size());
  for (int i = 0; i < count; ++i) {
    const v1::Seed& seed = trace.seeds(i);
    const cv::Mat probability = Probability(depth_m, rays, seed.position(), trace.gamma_per_m2());
    const cv::Mat drawn = HypothesisTile(grey, probability, PixelOf(seed, color.size()), i + 1);
    drawn.copyTo(picture(
        cv::Rect({i % columns * tile.width, i / columns * tile.height},
                 cv::Size(std::min(drawn.cols, tile.width), std::min(drawn.rows, tile.height)))));
  }
  return picture;
}

cv::Mat LabelsPicture(const cv::Mat& color, const v1::LabelImage& labels) {
  const cv::Mat numbers = Pixels16(labels, color.size(), "label image");
  cv::Mat picture = Grey(color) * 0.6;
  for (int row = 0; row < numbers.rows; ++row) {
    for (int col = 0; col < numbers.cols; ++col) {
      const auto label = numbers.at<std::uint16_t>(row, col);
      if (label == 0) continue;
      const cv::Scalar tint = ColorOf(label);
      auto& pixel = picture.at<cv::Vec3b>(row, col);
      for (int i = 0; i < 3; ++i) {
        pixel[i] = cv::saturate_cast<std::uint8_t>(0.3 * pixel[i] + 0.7 * tint[i]);
      }
    }
  }
  return picture;
}

cv::Mat RejectedPicture(const cv::Mat& color, const v1::Detections& detections) {
  cv::Mat picture = Grey(color) * 0.6;
  DrawRejected(picture, detections, {color.size(), 1, {}});
  return picture;
}

cv::Mat FilledDepth(const v1::Trace& trace, const cv::Size& frame) {
  const v1::DepthImage& image = trace.filled_depth();
  RequireFits(image.encoding() == v1::DEPTH_ENCODING_16UC1, "filled depth image");
  cv::Mat depth_m;
  Pixels16(image, frame, "filled depth image").convertTo(depth_m, CV_32F, image.unit_m());
  return depth_m;
}

cv::Mat MeasuredDepth(const std::vector<DepthPoint>& points, const cv::Size& frame) {
  cv::Mat depth_m(frame, CV_32FC1, cv::Scalar(0));
  for (const DepthPoint& point : points) {
    depth_m.at<float>(point.pixel) = static_cast<float>(point.position[2]);
  }
  return depth_m;
}

}  // namespace fovea::cli
