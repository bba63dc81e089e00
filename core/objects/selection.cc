#include "core/objects/selection.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>

#include "core/types/interruption.h"
#include "core/types/pixels.h"

namespace fovea {
namespace {

// The first column from `col` on that has a label. Most of an image has none.
int NextLabelled(const std::uint16_t* labels, int col, int cols) {
  constexpr int kTogether = 16;
  for (; col + kTogether <= cols; col += kTogether) {
    unsigned any = 0;
    for (int i = 0; i < kTogether; ++i) any |= labels[col + i];
    if (any != 0) break;
  }
  while (col < cols && labels[col] == 0) ++col;
  return col;
}

struct LabelledRun {
  int label = 0;
  PixelRun pixels;
};

// Row by row.
std::vector<LabelledRun> CollectRuns(const cv::Mat& labels) {
  constexpr int kUsualRuns = 4;  // of a row, or fewer
  std::vector<LabelledRun> runs;
  runs.reserve(kUsualRuns * static_cast<std::size_t>(labels.rows));
  const int cols = labels.cols;
  for (int row = 0; row < labels.rows; ++row) {
    InterruptionPoint();
    const auto* of_row = labels.ptr<std::uint16_t>(row);
    for (int end = 0, first = 0; (first = NextLabelled(of_row, end, cols)) < cols;) {
      const int label = of_row[first];
      for (end = first + 1; end < cols && of_row[end] == label;) ++end;
      runs.push_back({label, {row, first, end}});
    }
  }
  return runs;
}

// One entry a label, the background's first and empty.
std::vector<PixelRuns> RunsOfLabels(const cv::Mat& labels, std::size_t num_labels) {
  const std::vector<LabelledRun> all = CollectRuns(labels);
  std::vector<std::size_t> counts(num_labels + 1, 0);
  for (const LabelledRun& run : all) ++counts.at(run.label);
  std::vector<PixelRuns> runs(counts.size());
  for (std::size_t label = 0; label < runs.size(); ++label) runs[label].reserve(counts[label]);
  for (const LabelledRun& run : all) runs[run.label].push_back(run.pixels);
  return runs;
}

float MeanOf(const BlockImage& map, const PixelRuns& pixels, std::size_t num_pixels) {
  double sum = 0;
  for (const PixelRun& run : pixels) {
    const float* values = map.values.ptr<float>(run.row / map.size_px);
    for (int col = run.first; col < run.end;) {
      const int block = col / map.size_px;
      const int end = std::min((block + 1) * map.size_px, run.end);
      for (; col < end; ++col) sum += values[block];
    }
  }
  return static_cast<float>(sum / static_cast<double>(num_pixels));
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

Selection SelectObjects(const cv::Mat& labels, const LabelFacts& facts, const BlockImage& saliency,
                        const SeenArea& area, const SelectionOptions& options) {
  std::vector<PixelRuns> runs = RunsOfLabels(labels, facts.confidences.size());
  Selection selection;
  selection.candidates.reserve(facts.confidences.size());
  for (int label = 1; label < static_cast<int>(runs.size()); ++label) {
    PixelRuns& pixels = runs[label];
    const std::size_t num_pixels = CountPixels(pixels);
    InterruptionPoint();
    if (num_pixels == 0) continue;
    if (static_cast<double>(num_pixels) < FewestPixels(options, labels.size())) {
      ++selection.num_too_small;
      continue;
    }
    const std::size_t k = static_cast<std::size_t>(label) - 1;
    const bool is_cut = !facts.is_cut_by_region.empty() && facts.is_cut_by_region.at(k) != 0;
    const bool truncated = is_cut || area.CutsOff(pixels);
    const float confidence = facts.confidences.at(k);
    const float mean_saliency = MeanOf(saliency, pixels, num_pixels);
    selection.candidates.push_back(
        {label, std::move(pixels), num_pixels, confidence, mean_saliency, truncated});
  }
  std::stable_sort(selection.candidates.begin(), selection.candidates.end(),
                   [](const Candidate& a, const Candidate& b) {
                     return std::tuple(-a.confidence, b.num_pixels) <
                            std::tuple(-b.confidence, a.num_pixels);
                   });
  selection.num_less_salient = KeepMostSalient(options.max_objects, selection.candidates);
  return selection;
}

}  // namespace fovea
