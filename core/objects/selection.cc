#include "core/objects/selection.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <tuple>
#include <utility>

#include "core/types/interruption.h"
#include "core/types/pixels.h"

namespace fovea {
namespace {

using PixelsOfLabel = std::vector<std::vector<cv::Point>>;

// Calls visit(label, pixel) wherever there is one. Most of an image is none.
template <typename Visit>
void ForEachLabelled(const cv::Mat& labels, Visit visit) {
  constexpr int kTogether = 16;
  for (int row = 0; row < labels.rows; ++row) {
    InterruptionPoint();
    const auto* label = labels.ptr<std::uint16_t>(row);
    for (int first = 0; first < labels.cols; first += kTogether) {
      const int end = std::min(first + kTogether, labels.cols);
      unsigned any = 0;
      for (int col = first; col < end; ++col) any |= label[col];
      if (any == 0) continue;
      for (int col = first; col < end; ++col) {
        if (label[col] != 0) visit(label[col], cv::Point(col, row));
      }
    }
  }
}

PixelsOfLabel CollectPixels(const cv::Mat& labels) {
  std::vector<std::size_t> counts(1);
  ForEachLabelled(labels, [&](std::size_t label, const cv::Point& /*pixel*/) {
    if (label >= counts.size()) counts.resize(label + 1);
    ++counts[label];
  });
  PixelsOfLabel pixels(counts.size());
  for (std::size_t label = 1; label < counts.size(); ++label) pixels[label].reserve(counts[label]);
  ForEachLabelled(
      labels, [&](std::size_t label, const cv::Point& pixel) { pixels[label].push_back(pixel); });
  return pixels;
}

float MeanOf(const cv::Mat& map, const std::vector<cv::Point>& pixels) {
  double sum = 0;
  for (const cv::Point& pixel : pixels) sum += map.at<float>(pixel);
  return static_cast<float>(sum / static_cast<double>(pixels.size()));
}

double FewestPixels(const SelectionOptions& options, const cv::Size& image) {
  return std::max<double>(kFewestPixels, std::round(options.min_pixels * AreaScale(image)));
}

// Leaves the `max_objects` most salient candidates, in their order; 0: all. Returns how many it
// drops.
std::size_t KeepMostSalient(int max_objects, std::vector<Candidate>& candidates) {
  const auto limit = static_cast<std::size_t>(max_objects);
  if (limit == 0 || candidates.size() <= limit) return 0;
  std::vector<std::pair<float, std::size_t>> ranks;  // −saliency, position
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    ranks.emplace_back(-candidates[i].saliency, i);
  }
  std::sort(ranks.begin(), ranks.end());
  const std::size_t num_dropped = candidates.size() - limit;
  for (std::size_t r = limit; r < ranks.size(); ++r) candidates[ranks[r].second].label = 0;
  std::erase_if(candidates, [](const Candidate& candidate) { return candidate.label == 0; });
  return num_dropped;
}

}  // namespace

Selection SelectObjects(const cv::Mat& labels, const std::vector<float>& confidences,
                        const cv::Mat& saliency, const SeenArea& area,
                        const SelectionOptions& options) {
  PixelsOfLabel pixels_of_label = CollectPixels(labels);
  Selection selection;
  for (int label = 1; label < static_cast<int>(pixels_of_label.size()); ++label) {
    std::vector<cv::Point>& pixels = pixels_of_label[label];
    InterruptionPoint();
    if (pixels.empty()) continue;
    if (static_cast<double>(pixels.size()) < FewestPixels(options, labels.size())) {
      ++selection.num_too_small;
      continue;
    }
    const bool truncated = area.CutsOff(pixels);
    const float confidence = confidences.at(static_cast<std::size_t>(label) - 1);
    const float mean_saliency = MeanOf(saliency, pixels);
    selection.candidates.push_back(
        {label, std::move(pixels), confidence, mean_saliency, truncated});
  }
  std::stable_sort(selection.candidates.begin(), selection.candidates.end(),
                   [](const Candidate& a, const Candidate& b) {
                     return std::tuple(-a.confidence, b.pixels.size()) <
                            std::tuple(-b.confidence, a.pixels.size());
                   });
  selection.num_less_salient = KeepMostSalient(options.max_objects, selection.candidates);
  return selection;
}

}  // namespace fovea
