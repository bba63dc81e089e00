#include "core/relations/support_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/depth/back_projection.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

constexpr float kNearM = 0.015F;  // single points this close to a support may be its noise

// Looks at one pixel after another.
class SupportViewer {
 public:
  SupportViewer(const Support& support, const LevelAxes& axes, float height_m,
                const SupportOptions& options, SupportView& view)
      : support_(support), axes_(axes), height_m_(height_m), options_(options), view_(view) {
    view.begin.setConstant(std::numeric_limits<float>::max());
    view.end = -view.begin;
  }

  // `of_thing`: of an object that stands in the way.
  Sight Point(const Eigen::Vector3f& point, bool is_measured, bool of_thing) {
    const float height = support_.surface.HeightOf(point);
    if (height >= height_m_) return Sight::kNotSeen;
    if (height < -kNearM) return Beside(point);
    if (height > kNearM || of_thing) {
      view_.in_the_way.push_back(point);
      return Sight::kNotSeen;
    }
    if (!is_measured) return Sight::kNotSeen;
    if (height > support_.tolerance_share * SupportTolerance(point.z(), options_)) {
      view_.low.push_back(point);
      return Sight::kNothing;
    }
    return On(point);
  }

  // What was measured but is no surface.
  Sight Beside(const Eigen::Vector3f& point) const {
    const float noise = support_.LargestShare() * SupportTolerance(point.z(), options_);
    return std::abs(support_.surface.HeightOf(point)) <= std::max(kNearM, noise) ? Sight::kNothing
                                                                                 : Sight::kNotSeen;
  }

 private:
  Sight On(const Eigen::Vector3f& point) {
    if (!support_.footprint.Covers(point)) return Sight::kNothing;
    const Eigen::Vector2f place = axes_ * point;
    view_.begin = view_.begin.cwiseMin(place);
    view_.end = view_.end.cwiseMax(place);
    return Sight::kSeen;
  }

  const Support& support_;
  const LevelAxes& axes_;
  const float height_m_;
  const SupportOptions& options_;
  SupportView& view_;
};

}  // namespace

std::vector<char> StandInTheWay(const SupportSurface& surface,
                                const std::vector<DetectedObject>& objects, float height_m) {
  std::vector<char> stand_in_the_way;
  stand_in_the_way.reserve(objects.size());
  for (const DetectedObject& object : objects) {
    const float bottom = surface.HeightOf(object.box.center) - object.box.size_m.z() / 2;
    const bool ends_above = bottom + object.box.size_m.z() > kNearM;
    stand_in_the_way.push_back(
        static_cast<char>(bottom < height_m && (ends_above || bottom > -kNearM)));
  }
  return stand_in_the_way;
}

SupportView LookAt(const ViewedScene& scene, const Support& support, const LevelAxes& axes,
                   const std::vector<char>& stand_in_the_way, float height_m,
                   const SupportOptions& options) {
  SupportView view;
  view.sights.create(scene.points.size(), CV_8UC1);
  SupportViewer viewer(support, axes, height_m, options, view);
  const PixelPoints measured(scene.frame.depth_m, scene.frame.intrinsics);
  for (int row = 0; row < view.sights.rows; ++row) {
    InterruptionPoint();
    const auto* points = scene.points.ptr<cv::Vec3f>(row);
    const auto* labels = scene.labels.ptr<std::uint16_t>(row);
    const auto* depth = scene.frame.depth_m.ptr<float>(row);
    auto* sights = view.sights.ptr<Sight>(row);
    for (int col = 0; col < view.sights.cols; ++col) {
      const cv::Vec3f& p = points[col];
      const bool is_measured = !std::isnan(depth[col]);
      if (!std::isnan(p[2])) {
        const bool of_thing = labels[col] != 0 && stand_in_the_way[labels[col] - 1U] != 0;
        sights[col] = viewer.Point({p[0], p[1], p[2]}, is_measured, of_thing);
      } else {
        sights[col] = is_measured ? viewer.Beside(measured.At(row, col)) : Sight::kNotSeen;
      }
    }
  }
  if (view.begin.x() > view.end.x()) view.begin = view.end = Eigen::Vector2f::Zero();
  return view;
}

}  // namespace fovea
