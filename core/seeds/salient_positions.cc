#include "core/seeds/salient_positions.h"

namespace fovea {
namespace {

// Returns how many positions there are.
std::size_t Append(const SeedCandidates& candidates, Seed::Source source,
                   SalientPositions& positions) {
  positions.seeds.insert(positions.seeds.end(), candidates.seeds.begin(), candidates.seeds.end());
  for (const cv::Point& pixel : candidates.without_depth) {
    positions.removed.push_back({pixel, source, RemovedSeed::Reason::kWithoutDepth});
  }
  return candidates.seeds.size() + candidates.without_depth.size();
}

}  // namespace

SalientPositions FindSalientPositions(const cv::Mat& color_saliency, int color_block_px,
                                      const cv::Mat& depth_saliency, int depth_block_px,
                                      const cv::Mat& points, const SeedOptions& options,
                                      Diagnostics& counts) {
  SalientPositions positions;
  if (options.from_color) {
    constexpr auto kSource = Seed::Source::kColorSaliency;
    counts.seeds_from_color = Append(
        FindSeeds(color_saliency, points, kSource, options, color_block_px), kSource, positions);
  }
  if (options.from_depth) {
    constexpr auto kSource = Seed::Source::kDepthSaliency;
    counts.seeds_from_depth = Append(
        FindSeeds(depth_saliency, points, kSource, options, depth_block_px), kSource, positions);
  }
  counts.seeds_without_depth = positions.removed.size();
  return positions;
}

}  // namespace fovea
