#include "core/paper/support_reading.h"

#include <cstdint>

#include "core/scene/background.h"
#include "core/types/interruption.h"

namespace fovea::paper {
namespace {

// On the surface, or below it where `below_too`. False for NaN.
bool IsSupport(const SupportSurface& support, const Eigen::Vector3f& point,
               const SupportOptions& options, bool below_too) {
  const float height_m = support.HeightOf(point);
  const float tolerance_m = SupportTolerance(point.z(), options);
  return height_m <= tolerance_m && (below_too || height_m >= -tolerance_m);
}

}  // namespace

std::vector<Seed> SeedsOffSupport(const std::optional<SupportSurface>& support,
                                  const std::vector<Seed>& seeds, const PaperOptions& options,
                                  std::vector<RemovedSeed>& removed) {
  std::vector<Seed> off;
  for (const Seed& seed : seeds) {
    if (support && IsSupport(*support, seed.position, options.support,
                             options.support_reading.removes_seeds_below)) {
      removed.push_back({seed.pixel, seed.source, RemovedSeed::Reason::kOnSupport});
    } else {
      off.push_back(seed);
    }
  }
  return off;
}

cv::Mat PointsOfSupport(const cv::Mat& points, const std::optional<SupportSurface>& support,
                        const PaperOptions& options) {
  if (!support || options.support_reading.hard) return {};
  cv::Mat on_support(points.size(), CV_8UC1);
  for (int row = 0; row < points.rows; ++row) {
    InterruptionPoint();
    const auto* point = points.ptr<cv::Vec3f>(row);
    auto* on = on_support.ptr<std::uint8_t>(row);
    for (int col = 0; col < points.cols; ++col) {
      const Eigen::Vector3f p(point[col][0], point[col][1], point[col][2]);
      const bool is =
          IsSupport(*support, p, options.support, options.support_reading.includes_below);
      on[col] = is ? 255 : 0;
    }
  }
  return on_support;
}

std::vector<char> CertainBackground(const VoxelGrid& grid, const std::vector<Support>& supports,
                                    const CameraIntrinsics& intrinsics,
                                    const PaperOptions& options) {
  const bool hard = options.support_reading.hard;
  return FindBackground(grid, hard ? supports : std::vector<Support>(), options.support, intrinsics,
                        options.region);
}

SalientPositions SeedsAt(const std::vector<cv::Point>& pixels, const cv::Mat& points) {
  SalientPositions positions;
  for (const cv::Point& pixel : pixels) {
    constexpr auto kSource = Seed::Source::kColorSaliency;
    const cv::Vec3f& p = points.at<cv::Vec3f>(pixel);
    if (p[2] == p[2]) {
      positions.seeds.push_back({pixel, {p[0], p[1], p[2]}, kSource});
    } else {
      positions.removed.push_back({pixel, kSource, RemovedSeed::Reason::kWithoutDepth});
    }
  }
  return positions;
}

}  // namespace fovea::paper
