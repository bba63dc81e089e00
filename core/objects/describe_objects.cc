#include "core/objects/describe_objects.h"

#include <algorithm>
#include <cmath>

#include "core/depth/seen_area.h"
#include "core/objects/color_names.h"
#include "core/objects/selection.h"
#include "core/shape/complete_objects.h"
#include "core/types/helpers.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

// The object knows how many there are.
void SetColoredCloud(const RgbdFrame& frame, const PixelPoints& points, const PixelRuns& pixels,
                     DetectedObject& object) {
  std::array<std::size_t, 3> color_sum{};
  Eigen::Vector3d position_sum = Eigen::Vector3d::Zero();
  object.cloud.resize(object.num_pixels);
  ColoredPoint* next = object.cloud.data();
  for (const PixelRun& run : pixels) {
    const auto* color = frame.color_rgb.ptr<cv::Vec3b>(run.row);
    for (int col = run.first; col < run.end; ++col) {
      const Eigen::Vector3f p = points.At(run.row, col);
      const cv::Vec3b& c = color[col];
      *next++ = {p.x(), p.y(), p.z(), c[0], c[1], c[2]};
      position_sum += p.cast<double>();
      for (int channel = 0; channel < 3; ++channel) color_sum[channel] += c[channel];
    }
  }
  const auto count = static_cast<double>(object.num_pixels);
  object.centroid = (position_sum / count).cast<float>();
  for (int channel = 0; channel < 3; ++channel) {
    object.mean_color[channel] =
        static_cast<std::uint8_t>(std::lround(static_cast<double>(color_sum[channel]) / count));
  }
}

float LowestHeight(const std::vector<Eigen::Vector3f>& positions, const SupportSurface& support) {
  float lowest = support.HeightOf(positions.front());
  for (const Eigen::Vector3f& p : positions) lowest = std::min(lowest, support.HeightOf(p));
  return lowest;
}

// The surface that most of the points are above: the highest one if there are several, the first if
// there is none. Some points, evenly spread, speak for all.
std::optional<SupportSurface> OwnSupport(const std::vector<Support>& supports,
                                         const std::vector<Eigen::Vector3f>& positions) {
  constexpr std::size_t kSpeakers = 500;
  if (supports.size() == 1) return supports.front().surface;
  const std::size_t step = 1 + positions.size() / kSpeakers;
  const auto is_below = [&](const Support& support) {
    std::size_t above = 0, asked = 0;
    for (std::size_t i = 0; i < positions.size(); i += step, ++asked) {
      const Eigen::Vector3f& p = positions[i];
      above += support.surface.HeightOf(p) > 0 && support.footprint.Covers(p) ? 1 : 0;
    }
    return 2 * above > asked;
  };
  std::optional<SupportSurface> highest;
  for (const Support& support : supports) {
    if (!is_below(support)) continue;
    const float height = support.surface.HeightOf(positions.front());
    if (!highest || height < highest->HeightOf(positions.front())) highest = support.surface;
  }
  if (!highest && !supports.empty()) return supports.front().surface;
  return highest;
}

bool IsMostlyWithoutDepth(const cv::Mat& depth_m, const PixelRuns& pixels) {
  std::ptrdiff_t surplus = 0;  // of pixels without
  for (const PixelRun& run : pixels) {
    const float* depth = depth_m.ptr<float>(run.row);
    const auto missing =
        std::count_if(depth + run.first, depth + run.end, [](float d) { return std::isnan(d); });
    surplus += 2 * missing - (run.end - run.first);
  }
  return surplus > 0;
}

// Of what is not measured only the front is assumed; bottles and glasses are as deep as they are
// wide.
void DeepenBehind(OrientedBox& box) {
  Eigen::Vector3f away = box.rotation.col(1);
  if (box.center.dot(away) < 0) away = -away;
  box.center += away * (box.size_m.x() - box.size_m.y()) / 2;
  box.size_m.y() = box.size_m.x();
}

struct DescribedObject {
  DetectedObject object;
  std::optional<SupportSurface> support;
};

DescribedObject Describe(const RgbdFrame& frame, const PixelPoints& points,
                         const Candidate& candidate, const std::vector<Support>& supports,
                         const Eigen::Vector3f& gravity, const ObjectOptions& options) {
  const PixelRuns& pixels = candidate.pixels;
  DetectedObject object;
  object.confidence = candidate.confidence;
  object.saliency = candidate.saliency;
  object.bounds_px = BoundsOf(pixels);
  object.num_pixels = candidate.num_pixels;
  InterruptionPoint();
  object.truncated = candidate.truncated;
  SetColoredCloud(frame, points, pixels, object);

  object.colors = ColorPartsOf(object.cloud);

  std::vector<Eigen::Vector3f> positions(object.cloud.size());
  std::transform(object.cloud.begin(), object.cloud.end(), positions.begin(),
                 [](const ColoredPoint& p) { return Eigen::Vector3f(p.x, p.y, p.z); });
  InterruptionPoint();
  const std::optional<SupportSurface> support = OwnSupport(supports, positions);
  object.visible_box =
      FitOrientedBox(positions, support ? support->normal : -gravity, support, options.box);
  object.depth_missing = IsMostlyWithoutDepth(frame.depth_m, pixels);
  object.box = object.visible_box;
  if (object.depth_missing) DeepenBehind(object.box);
  if (support) object.height_above_support_m = LowestHeight(positions, *support);
  return {std::move(object), support};
}

}  // namespace

void DescribeObjects(const RgbdFrame& frame, const PixelPoints& points, const BlockImage& saliency,
                     const LabelFacts& facts, const std::vector<Support>& supports,
                     const ObjectOptions& options, Detections& detections) {
  const Selection selection =
      SelectObjects(detections.labels, facts, saliency, SeenArea(points.Depth_m(), frame.unseen),
                    options.selection);
  detections.diagnostics.segments_too_small = selection.num_too_small;
  detections.diagnostics.objects_less_salient = selection.num_less_salient;
  detections.labels = cv::Mat::zeros(frame.depth_m.size(), CV_16UC1);
  const std::vector<Candidate>& candidates = selection.candidates;
  std::vector<std::optional<SupportSurface>> supports_of_objects(candidates.size());
  detections.objects.resize(candidates.size());
  ForEachTogether(candidates.size(), [&](std::size_t i) {
    auto [object, support] =
        Describe(frame, points, candidates[i], supports, detections.gravity.direction, options);
    object.label = static_cast<int>(i) + 1;
    for (const PixelRun& run : candidates[i].pixels) {
      auto* labels = detections.labels.ptr<std::uint16_t>(run.row);
      std::fill(labels + run.first, labels + run.end, static_cast<std::uint16_t>(object.label));
    }
    supports_of_objects[i] = support;
    detections.objects[i] = std::move(object);
  });
  CompleteObjects(frame, points, supports_of_objects, detections);
}

}  // namespace fovea
