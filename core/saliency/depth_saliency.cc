#include "core/saliency/depth_saliency.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <opencv2/core.hpp>
#include <span>
#include <vector>

#include "core/saliency/superpixels.h"

namespace fovea {
namespace {

// Stands for "no depth" in a map of nearness: never the least value along a line.
constexpr float kNone = std::numeric_limits<float>::infinity();

constexpr int kBlurRadius_px = 3;
constexpr double kBlurSigma_px = 1.75;
constexpr double kLeastContrast = 1e-5;  // 1/m; a map that nowhere reaches it is rounding error
constexpr float kCompactness = 20;       // of superpixels, where the nearness spans 0 to 255

// One of the eight scan lines: `count` samples at multiples of `step` from the pixel.
struct ScanLine {
  cv::Point step;
  int count = 0;
};

// Steps along diagonals are rounded to whole pixels in x and y.
std::array<ScanLine, 8> ScanLines(cv::Size size, const DepthSaliencyOptions& options) {
  const double length_px = options.line_length * std::hypot(size.width, size.height);
  const int straight = options.line_step_px;
  const int diagonal = std::max(1, static_cast<int>(std::lround(straight * std::sqrt(0.5))));
  std::array<ScanLine, 8> lines;
  std::size_t next = 0;
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      if (x == 0 && y == 0) continue;
      const cv::Point step = cv::Point(x, y) * (x == 0 || y == 0 ? straight : diagonal);
      lines[next++] = {step, static_cast<int>(length_px / std::hypot(step.x, step.y))};
    }
  }
  return lines;
}

// Written for loops that the compiler vectorises: no call, no branch.
bool HasDepth(float depth_m) { return (depth_m > 0) & (depth_m < kNone); }

using Kernel = std::array<float, 2 * kBlurRadius_px + 1>;

Kernel GaussianKernel() {
  Kernel kernel;
  for (int i = -kBlurRadius_px; i <= kBlurRadius_px; ++i) {
    kernel[static_cast<std::size_t>(i + kBlurRadius_px)] =
        static_cast<float>(std::exp(-i * i / (2 * kBlurSigma_px * kBlurSigma_px)));
  }
  return kernel;
}

// Sums of the rows about each row, weighted by the kernel; what lies outside counts as 0.
cv::Mat BlurColumns(const cv::Mat& map, const Kernel& kernel) {
  cv::Mat blurred = cv::Mat::zeros(map.size(), CV_32F);
  for (int y = 0; y < map.rows; ++y) {
    float* to = blurred.ptr<float>(y);
    const int last = std::min(y + kBlurRadius_px, map.rows - 1);
    for (int from_y = std::max(y - kBlurRadius_px, 0); from_y <= last; ++from_y) {
      const float weight = kernel[static_cast<std::size_t>(from_y - y + kBlurRadius_px)];
      const float* from = map.ptr<float>(from_y);
      for (int x = 0; x < map.cols; ++x) to[x] += weight * from[x];
    }
  }
  return blurred;
}

// The same along rows.
cv::Mat BlurRows(const cv::Mat& map, const Kernel& kernel) {
  cv::Mat blurred = cv::Mat::zeros(map.size(), CV_32F);
  for (int y = 0; y < map.rows; ++y) {
    const float* from = map.ptr<float>(y);
    float* to = blurred.ptr<float>(y);
    for (int shift = -kBlurRadius_px; shift <= kBlurRadius_px; ++shift) {
      const float weight = kernel[static_cast<std::size_t>(shift + kBlurRadius_px)];
      const int end = std::min(map.cols, map.cols - shift);
      for (int x = std::max(0, -shift); x < end; ++x) to[x] += weight * from[x + shift];
    }
  }
  return blurred;
}

// 1/depth, smoothed over the neighbours that have depth. Ju's maps are stereo disparities, which
// are proportional to it. Not cv::GaussianBlur, whose bits depend on the machine's vector width.
cv::Mat SmoothNearness(const cv::Mat& depth_m) {
  cv::Mat nearness(depth_m.size(), CV_32F), presence(depth_m.size(), CV_32F);
  for (int y = 0; y < depth_m.rows; ++y) {
    const float* depth = depth_m.ptr<float>(y);
    float* near = nearness.ptr<float>(y);
    float* present = presence.ptr<float>(y);
    for (int x = 0; x < depth_m.cols; ++x) {
      const float inverse = 1.0F / depth[x];
      near[x] = HasDepth(depth[x]) ? inverse : 0.0F;
      present[x] = HasDepth(depth[x]) ? 1.0F : 0.0F;
    }
  }
  const Kernel kernel = GaussianKernel();
  nearness = BlurColumns(BlurRows(nearness, kernel), kernel);
  presence = BlurColumns(BlurRows(presence, kernel), kernel);
  for (int y = 0; y < depth_m.rows; ++y) {
    const float* depth = depth_m.ptr<float>(y);
    const float* present = presence.ptr<float>(y);
    float* near = nearness.ptr<float>(y);
    for (int x = 0; x < depth_m.cols; ++x) {
      const float mean = near[x] / present[x];
      near[x] = HasDepth(depth[x]) ? mean : kNone;
    }
  }
  return nearness;
}

// map(p) = min(map(p), map(p + shift)) where p + shift lies in the image; in place, in an order
// that reads every row before it changes.
void TakeShiftedMinimum(cv::Mat& map, cv::Point shift) {
  const int first_x = std::max(0, -shift.x);
  const int count_x = map.cols - std::abs(shift.x);
  const int count_y = map.rows - std::abs(shift.y);
  if (count_x <= 0) return;
  std::vector<float> same_row(static_cast<std::size_t>(count_x));
  for (int turn = 0; turn < count_y; ++turn) {
    const int y = shift.y >= 0 ? turn : map.rows - 1 - turn;
    const float* from = map.ptr<float>(y + shift.y) + first_x + shift.x;
    float* to = map.ptr<float>(y) + first_x;
    if (shift.y == 0) {
      std::copy_n(from, count_x, same_row.begin());
      from = same_row.data();
    }
    for (int x = 0; x < count_x; ++x) to[x] = std::min(to[x], from[x]);
  }
}

// Turns every value into the least along a line from its pixel, itself included. A run of 2n
// samples is two runs of n, and any longer one is two overlapping runs.
void TakeLineMinima(const ScanLine& line, cv::Mat& map) {
  const int samples = line.count + 1;
  int covered = 1;
  for (; 2 * covered <= samples; covered *= 2) TakeShiftedMinimum(map, line.step * covered);
  if (covered < samples) TakeShiftedMinimum(map, line.step * (samples - covered));
}

cv::Mat ContrastOfPixels(const cv::Mat& nearness, const std::array<ScanLine, 8>& lines) {
  cv::Mat contrast = cv::Mat::zeros(nearness.size(), CV_32F);
  cv::Mat minima;
  for (const ScanLine& line : lines) {
    nearness.copyTo(minima);
    TakeLineMinima(line, minima);
    for (int y = 0; y < nearness.rows; ++y) {
      const float* own = nearness.ptr<float>(y);
      const float* least = minima.ptr<float>(y);
      float* sum = contrast.ptr<float>(y);
      for (int x = 0; x < nearness.cols; ++x) sum[x] += own[x] - least[x];
    }
  }
  contrast.setTo(0.0F, nearness == kNone);
  return contrast;
}

// Ju's contribution of one scan line to a superpixel.
float LineContrast(const cv::Mat& nearness, const Superpixel& center, const ScanLine& line) {
  const cv::Rect image({0, 0}, nearness.size());
  cv::Point sample(static_cast<int>(std::lround(center.x_px)),
                   static_cast<int>(std::lround(center.y_px)));
  float least = center.value;
  for (int i = 0; i < line.count; ++i) {
    sample += line.step;
    if (!image.contains(sample)) break;
    least = std::min(least, nearness.at<float>(sample));
  }
  return center.value - least;
}

cv::Mat ContrastOfSuperpixels(const cv::Mat& nearness, const std::array<ScanLine, 8>& lines,
                              int count) {
  double least = 0, most = 0;
  cv::minMaxLoc(nearness, &least, &most, nullptr, nullptr, nearness != kNone);
  const auto compactness = static_cast<float>(kCompactness / 255.0 * (most - least));
  const Superpixels superpixels = DivideIntoSuperpixels(nearness, count, compactness);

  std::vector<float> contrasts;
  for (const Superpixel& center : superpixels.all) {
    float sum = 0;
    if (center.pixels > 0) {
      for (const ScanLine& line : lines) sum += LineContrast(nearness, center, line);
    }
    contrasts.push_back(sum);
  }
  cv::Mat contrast = cv::Mat::zeros(nearness.size(), CV_32F);
  for (int y = 0; y < contrast.rows; ++y) {
    const int* labels = superpixels.labels.ptr<int>(y);
    float* to = contrast.ptr<float>(y);
    for (int x = 0; x < contrast.cols; ++x) {
      if (labels[x] >= 0) to[x] = contrasts[static_cast<std::size_t>(labels[x])];
    }
  }
  return contrast;
}

void ScaleToOne(cv::Mat& map) {
  double most = 0;
  cv::minMaxLoc(map, nullptr, &most);
  if (most < kLeastContrast) {
    map = 0.0F;
    return;
  }
  for (int y = 0; y < map.rows; ++y) {
    float* row = map.ptr<float>(y);
    for (int x = 0; x < map.cols; ++x) row[x] /= static_cast<float>(most);
  }
}

// The nearness at which the nearer half of the pixels begins. Positive floats are in the order of
// their bits: a histogram of the upper half of the bits leaves few candidates to sort.
float NearerHalf(const cv::Mat& nearness) {
  const auto bin_of = [](float value) { return std::bit_cast<std::uint32_t>(value) >> 16; };
  const std::span values(nearness.ptr<float>(), nearness.total());  // continuous, being our own
  std::vector<int> histogram(bin_of(kNone) + 1, 0);
  for (const float value : values) ++histogram[bin_of(value)];
  int below = (static_cast<int>(nearness.total()) - histogram[bin_of(kNone)]) / 2;
  std::uint32_t bin = 0;
  for (; histogram[bin] <= below; ++bin) below -= histogram[bin];

  std::vector<float> candidates;
  for (const float value : values) {
    if (bin_of(value) == bin) candidates.push_back(value);
  }
  std::nth_element(candidates.begin(), candidates.begin() + below, candidates.end());
  return candidates[static_cast<std::size_t>(below)];
}

// Ju's depth prior: × nearness / T below T.
void ApplyDepthPrior(const cv::Mat& nearness, cv::Mat& map) {
  const float threshold = NearerHalf(nearness);
  for (int y = 0; y < map.rows; ++y) {
    const float* near = nearness.ptr<float>(y);
    float* to = map.ptr<float>(y);
    for (int x = 0; x < map.cols; ++x) to[x] *= std::min(1.0F, near[x] / threshold);
  }
}

// Ju's centre prior: × exp(−(Δrow/(H/2))² − (Δcolumn/(W/2))²).
void ApplyCenterPrior(cv::Mat& map) {
  const auto weight = [](int index, int size) {
    const double offset = (index - (size - 1) / 2.0) / (size / 2.0);
    return static_cast<float>(std::exp(-offset * offset));
  };
  std::vector<float> across;
  for (int x = 0; x < map.cols; ++x) across.push_back(weight(x, map.cols));
  for (int y = 0; y < map.rows; ++y) {
    const float down = weight(y, map.rows);
    float* row = map.ptr<float>(y);
    for (int x = 0; x < map.cols; ++x) row[x] *= down * across[static_cast<std::size_t>(x)];
  }
}

}  // namespace

cv::Mat DepthSaliency(const cv::Mat& depth_m, const DepthSaliencyOptions& options) {
  const cv::Mat nearness = SmoothNearness(depth_m);
  if (cv::countNonZero(nearness != kNone) == 0) return cv::Mat::zeros(depth_m.size(), CV_32F);

  const std::array<ScanLine, 8> lines = ScanLines(depth_m.size(), options);
  const double diagonal_px = std::hypot(depth_m.cols, depth_m.rows);
  const auto superpixels =
      static_cast<int>(std::lround(options.superpixels_per_diagonal * diagonal_px));
  cv::Mat saliency = superpixels > 0 ? ContrastOfSuperpixels(nearness, lines, superpixels)
                                     : ContrastOfPixels(nearness, lines);
  ScaleToOne(saliency);
  if (options.depth_prior) ApplyDepthPrior(nearness, saliency);
  if (options.center_prior) ApplyCenterPrior(saliency);
  return saliency;
}

}  // namespace fovea
