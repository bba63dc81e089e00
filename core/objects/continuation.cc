#include "core/objects/continuation.h"

#include "core/objects/outline.h"
#include "core/segmentation/labels.h"
#include "core/types/interruption.h"
#include "core/types/pixels.h"

namespace fovea {
namespace {

// Whether a segment is, for all one can see, a part of something that goes on: above it, or beyond
// the end of the image. Things stand against walls, but what ends with the image as well as at a
// wall is more likely a strip of it.
bool GoesOn(const Outline& outline, double max_share) {
  const Outline::Upper& upper = outline.upper;
  const int open = upper.open + (outline.num_sides_at_end > 0 ? 0 : upper.at_wall);
  return upper.Total() - open > max_share * upper.Total() ||
         outline.num_sides_at_end > max_share * outline.num_sides;
}

// Labels up to `max_label` without those of a few pixels, which are noise.
std::vector<int> WithoutSpecks(const VoxelGrid& grid, std::vector<int> labels,
                               std::size_t max_label) {
  std::vector<int> num_pixels(max_label + 1);
  for (std::size_t v = 0; v < labels.size(); ++v) {
    num_pixels[labels[v]] += grid.voxels[v].num_points;
  }
  for (int& label : labels) {
    if (num_pixels[label] < kFewestPixels) label = 0;
  }
  return labels;
}

}  // namespace

PlausibleSegments RemoveContinued(const VoxelGrid& grid, const std::vector<int>& labels,
                                  const cv::Mat& points, const CameraIntrinsics& intrinsics,
                                  const std::vector<char>& on_wall, const Eigen::Vector3f& up,
                                  const ContinuationOptions& options) {
  PlausibleSegments result{labels, 0};
  if (options.max_share >= 1) return result;
  const cv::Mat wall_pixels = LabelImage(grid, {on_wall.begin(), on_wall.end()});
  for (bool changed = true; changed;) {
    InterruptionPoint();
    const std::size_t num_labels = CountLabels(result.labels);
    const cv::Mat segments = LabelImage(grid, WithoutSpecks(grid, result.labels, num_labels));
    const std::vector<Outline> outlines =
        FindOutlines(segments, points, wall_pixels, intrinsics, up);
    std::vector<char> goes_on(num_labels + 1, 0);
    changed = false;
    for (std::size_t label = 1; label < outlines.size(); ++label) {
      if (!GoesOn(outlines[label], options.max_share)) continue;
      goes_on[label] = 1;
      ++result.num_removed;
      changed = true;
    }
    for (int& label : result.labels) label = goes_on[label] ? 0 : label;
  }
  return result;
}

}  // namespace fovea
