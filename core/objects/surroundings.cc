#include "core/objects/surroundings.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>

#include "core/depth/depth_gap.h"
#include "core/depth/seen_area.h"
#include "core/scene/image_direction.h"
#include "core/segmentation/labels.h"
#include "core/types/interruption.h"
#include "core/types/pixels.h"

namespace fovea {
namespace {

// In an image 640 wide:
constexpr double kEdgePx = 6;    // what sensors mix at an edge
constexpr double kInsidePx = 3;  // from a border to the colour of its own side
constexpr double kReachPx = 40;  // how far to look for depth: wider than most shadows
constexpr int kBlurPx = 5;
constexpr float kSteep = 0.5F;  // sine from which a side is above
constexpr float kRisePerM = 0.004F;

Eigen::Vector3f PointAt(const cv::Mat& points, const cv::Point& pixel) {
  const cv::Vec3f& p = points.at<cv::Vec3f>(pixel);
  return {p[0], p[1], p[2]};
}

struct Found {
  Beyond beyond;
  int segment = 0;
  cv::Point pixel;
};

class Search {
 public:
  Search(const LabelledScene& scene, const cv::Mat& labels)
      : scene_(scene),
        labels_(labels),
        points_(scene.points),
        edge_px_(ScaledPx(kEdgePx, labels.cols, 1)),
        reach_px_(ScaledPx(kReachPx, labels.cols, 4)),
        image_({}, labels.size()),
        seen_(scene.points, scene.unseen) {}

  // None where the pixel's own segment goes on.
  std::optional<Found> LookFrom(const cv::Point& pixel, const cv::Point& side) const {
    const std::uint16_t own = labels_.at<std::uint16_t>(pixel);
    const cv::Point next = pixel + side;
    if (image_.contains(next) && labels_.at<std::uint16_t>(next) == own) return std::nullopt;
    if (!seen_.Contains(pixel + edge_px_ * side)) return Found{Beyond::kEnd, 0, {}};
    for (int step = 1; step <= reach_px_; ++step) {
      const cv::Point beyond = pixel + step * side;
      if (!image_.contains(beyond)) break;
      const std::uint16_t other = labels_.at<std::uint16_t>(beyond);
      if (other == own) return std::nullopt;  // a gap in it
      const bool may_be_mixed = other == 0 && step < edge_px_;
      if (may_be_mixed || std::isnan(points_.at<cv::Vec3f>(beyond)[2])) continue;
      return Found{Compare(pixel, beyond, other), other, beyond};
    }
    return Found{Beyond::kUnmeasured, 0, {}};
  }

 private:
  Beyond Compare(const cv::Point& pixel, const cv::Point& beyond_px, int other) const {
    const Eigen::Vector3f own = PointAt(points_, pixel);
    const Eigen::Vector3f beyond = PointAt(points_, beyond_px);
    const float step_m = beyond.z() - own.z();
    const float gap_m = DepthGap_m(own.z());
    if (step_m > gap_m) return Beyond::kFarther;
    if (step_m < -gap_m) return other != 0 ? Beyond::kNearerSegment : Beyond::kNearer;
    if (other != 0) return Beyond::kLevelSegment;
    if (scene_.up.dot(beyond - own) <= kRisePerM * own.z()) return Beyond::kLevel;
    return IsOnWall(beyond_px) ? Beyond::kWall : Beyond::kRising;
  }

  bool IsOnWall(const cv::Point& pixel) const {
    const int voxel = scene_.grid.voxel_of_pixel.at<int>(pixel);
    return voxel >= 0 && scene_.on_wall[voxel] != 0;
  }

  const LabelledScene& scene_;
  const cv::Mat& labels_;
  const cv::Mat& points_;
  const int edge_px_;
  const int reach_px_;
  const cv::Rect image_;
  const SeenArea seen_;
};

bool IsLevelBackground(Beyond beyond) {
  return beyond == Beyond::kLevel || beyond == Beyond::kRising || beyond == Beyond::kWall;
}

bool IsGrey(const LabelledScene& scene) {
  return !scene.colors.empty() && scene.colors.front().is_grey;
}

// Differences of colour across borders, which themselves are blurred.
class Contrast {
 public:
  Contrast(const LabelledScene& scene, const cv::Mat& labels)
      : lab_(scene.lab),
        labels_(labels),
        inside_px_(ScaledPx(kInsidePx, labels.cols, 1)),
        unseen_(IsGrey(scene) ? kUsualContrast : 0) {}

  // From a little inside of the border at `pixel`, which faces `side`, to a pixel beyond it; units
  // of 8-bit CIELAB.
  double Between(const cv::Point& pixel, const cv::Point& side, const cv::Point& beyond) const {
    cv::Point inside = pixel - inside_px_ * side;
    const bool is_own = cv::Rect({}, labels_.size()).contains(inside) &&
                        labels_.at<std::uint16_t>(inside) == labels_.at<std::uint16_t>(pixel);
    if (!is_own) inside = pixel;
    return std::hypot(cv::norm(ColorAround(inside) - ColorAround(beyond)), unseen_);
  }

 private:
  // As cv::blur has it, which would do so for all pixels.
  cv::Vec3i ColorAround(const cv::Point& pixel) const {
    constexpr int kReach = kBlurPx / 2, kCount = kBlurPx * kBlurPx;
    std::array<int, kBlurPx> cols{};
    for (int i = 0; i < kBlurPx; ++i) {
      cols[i] = cv::borderInterpolate(pixel.x - kReach + i, lab_.cols, cv::BORDER_REFLECT_101);
    }
    cv::Vec3i sum(0, 0, 0);
    for (int i = 0; i < kBlurPx; ++i) {
      const int row =
          cv::borderInterpolate(pixel.y - kReach + i, lab_.rows, cv::BORDER_REFLECT_101);
      const auto* of_row = lab_.ptr<cv::Vec3b>(row);
      for (const int col : cols) sum += of_row[col];
    }
    for (int& channel : sum.val) channel = (channel + kCount / 2) / kCount;
    return sum;
  }

  const cv::Mat& lab_;  // CV_8UC3
  const cv::Mat& labels_;
  int inside_px_;
  double unseen_;
};

BorderSide SideOf(const cv::Point& side, const std::optional<cv::Point2f>& up_px) {
  if (!up_px) return BorderSide::kElsewhere;
  const auto rise = static_cast<float>(up_px->dot(cv::Point2f(side)));
  return rise > kSteep ? BorderSide::kAbove : BorderSide::kElsewhere;
}

}  // namespace

void BorderCounts::Add(const BorderCounts& other, double sign) {
  contrast += sign * other.contrast;
  for (std::size_t s = 0; s < kNumBorderSides; ++s) {
    for (std::size_t b = 0; b < kNumBeyond; ++b) sides[s][b] += sign * other.sides[s][b];
  }
}

double BorderCounts::Of(Beyond beyond) const {
  double sum = 0;
  for (const auto& side : sides) sum += side[static_cast<std::size_t>(beyond)];
  return sum;
}

double BorderCounts::Of(BorderSide side) const {
  double sum = 0;
  for (const double count : sides[static_cast<std::size_t>(side)]) sum += count;
  return sum;
}

double BorderCounts::Total() const { return Of(BorderSide::kAbove) + Of(BorderSide::kElsewhere); }

Surroundings FindSurroundings(const LabelledScene& scene, const cv::Mat& labels) {
  constexpr int kUsualFacings = 8;  // of a row, or fewer
  Surroundings surroundings{std::vector<BorderCounts>(1), {}};
  std::vector<BorderCounts>& counts = surroundings.counts;
  surroundings.facings.reserve(kUsualFacings * static_cast<std::size_t>(labels.rows));
  const Search search(scene, labels);
  const Contrast contrast(scene, labels);
  for (int row = 0; row < labels.rows; ++row) {
    InterruptionPoint();
    const auto* label = labels.ptr<std::uint16_t>(row);
    for (int col = 0; col < labels.cols; ++col) {
      if (label[col] == 0) continue;
      if (label[col] >= counts.size()) counts.resize(label[col] + std::size_t{1});
      if (IsInterior(labels, row, col)) continue;
      const cv::Point pixel(col, row);
      const auto up_px = UpInImage(PointAt(scene.points, pixel), scene.intrinsics, scene.up);
      for (const cv::Point& side :
           {cv::Point(1, 0), cv::Point(-1, 0), cv::Point(0, 1), cv::Point(0, -1)}) {
        const std::optional<Found> found = search.LookFrom(pixel, side);
        if (!found) continue;
        const BorderSide border = SideOf(side, up_px);
        counts[label[col]].Count(border, found->beyond);
        if (found->segment != 0) {
          surroundings.facings.push_back({label[col], found->segment, border, found->beyond});
        }
        if (IsLevelBackground(found->beyond)) {
          counts[label[col]].contrast += contrast.Between(pixel, side, found->pixel);
        }
      }
    }
  }
  return surroundings;
}

}  // namespace fovea
