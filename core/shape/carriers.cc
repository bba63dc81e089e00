#include "core/shape/carriers.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "core/relations/rests_on.h"

namespace fovea {
namespace {

// How much lower than a carrier's top: masks reach beyond their things or end before; what is
// neither balanced on it nor across it is beside it if it is much lower.
constexpr float kMaxSunk_m = 0.04F, kMaxSunkBeside_m = 0.01F;

// Whether a point is above the object's footprint, or beside it by no more than a margin.
bool IsAbove(const DetectedObject& object, const Eigen::Vector3f& p, float margin_m) {
  const OrientedBox& box = object.box;
  const Eigen::Array2f beside =
      (box.rotation.transpose() * (p - box.center)).head<2>().array().abs();
  const Eigen::Array2f half = box.size_m.head<2>().array() / 2 + margin_m;
  return object.yaw_is_arbitrary ? beside.matrix().norm() <= half.x() : (beside <= half).all();
}

// Whether the object's middle, as far as it is seen, is above the other's footprint, so that it
// does not topple off.
bool IsBalancedOn(const DetectedObject& object, const DetectedObject& other) {
  constexpr float kMargin_m = 0.015F;
  return IsAbove(other, object.visible_box.center, kMargin_m);
}

// Share of the object's points that are above the other.
float ShareAbove(const DetectedObject& object, const DetectedObject& other) {
  const auto above =
      std::count_if(object.cloud.begin(), object.cloud.end(), [&](const ColoredPoint& p) {
        return IsAbove(other, {p.x, p.y, p.z}, 0);
      });
  return static_cast<float>(above) /
         static_cast<float>(std::max<std::size_t>(object.cloud.size(), 1));
}

// Whether enough of it is above the other that it may lie across that and something else.
bool LiesAcross(const DetectedObject& object, const DetectedObject& other) {
  constexpr float kMinShare = 0.3F;
  return ShareAbove(object, other) >= kMinShare;
}

// Share of the smaller footprint that both have in common.
float FootprintOverlap(const OrientedBox& a, const OrientedBox& b) {
  const float smaller = std::min(a.size_m.x() * a.size_m.y(), b.size_m.x() * b.size_m.y());
  if (smaller <= 0) return 0;
  const Eigen::Vector3f at = a.rotation.transpose() * (b.center - a.center);
  const Eigen::Vector3f along = a.rotation.transpose() * b.rotation.col(0);
  const float turn_deg = std::atan2(along.y(), along.x()) * 180 / std::numbers::pi_v<float>;
  std::vector<cv::Point2f> corners;
  cv::rotatedRectangleIntersection({{0, 0}, {a.size_m.x(), a.size_m.y()}, 0},
                                   {{at.x(), at.y()}, {b.size_m.x(), b.size_m.y()}, turn_deg},
                                   corners);
  if (corners.empty()) return 0;
  std::vector<cv::Point2f> outline;
  cv::convexHull(corners, outline);
  return static_cast<float>(cv::contourArea(outline)) / smaller;
}

}  // namespace

float HeightAlong(const Eigen::Vector3f& up, const OrientedBox& box, float share) {
  return up.dot(box.center) + (share - 0.5F) * box.size_m.z();
}

float HeightAboveSupport(const DetectedObject& object, const SupportSurface& support) {
  const OrientedBox& box = object.visible_box;
  return support.HeightOf(box.center - box.rotation.col(2) * (box.size_m.z() / 2));
}

Touch Touching(const DetectedObject& object, const std::vector<DetectedObject>& others,
               const std::vector<OutlinePoint>& outline,
               const std::optional<SupportSurface>& support) {
  constexpr float kMinShare = 0.12F;  // of the outline where it ends
  constexpr int kNothing = -1;
  const Eigen::Vector3f up = object.visible_box.rotation.col(2);
  const float bottom = HeightAlong(up, object.visible_box, 0);
  // What rises higher stands beside it.
  const auto can_carry = [&](int label) {
    if (label == 0 || label == object.label) return false;
    const DetectedObject& other = others[static_cast<std::size_t>(label) - 1];
    return HeightAlong(up, other.visible_box, 1) < bottom + kContact_m &&
           !RestsOn(others, label, object.label) &&
           (IsBalancedOn(object, other) || LiesAcross(object, other));
  };
  std::map<int, bool> known;  // each label is looked at once
  const auto may_carry = [&](int label) {
    const auto [entry, is_new] = known.try_emplace(label, false);
    if (is_new) entry->second = can_carry(label);
    return entry->second;
  };
  std::map<int, int> touches;
  int ends = 0, touching = 0;
  for (const OutlinePoint& point : outline) {
    if (!point.is_own_end || std::isnan(point.beyond.z())) continue;
    ++ends;
    if (std::abs(up.dot(point.beyond) - bottom) > kContact_m) continue;
    ++touching;
    const bool is_on_support = !support || std::abs(support->HeightOf(point.beyond)) <= kContact_m;
    ++touches[may_carry(point.label_beyond) ? point.label_beyond : is_on_support ? 0 : kNothing];
  }
  if (touching == 0 || static_cast<float>(touching) < kMinShare * static_cast<float>(ends)) {
    return {};
  }
  const int most =
      std::max_element(touches.begin(), touches.end(), [](const auto& a, const auto& b) {
        return a.second < b.second;
      })->first;
  return {true, most == kNothing ? std::nullopt : std::optional(most)};
}

std::vector<Carrier> CarriersOf(const DetectedObject& object,
                                const std::vector<DetectedObject>& others,
                                const std::vector<std::size_t>& lower,
                                const std::optional<SupportSurface>& support) {
  const Eigen::Vector3f up = object.box.rotation.col(2);
  const float bottom = HeightAlong(up, object.visible_box, 0);
  std::vector<Carrier> carriers;
  for (const std::size_t i : lower) {
    const DetectedObject& other = others[i];
    const float drop = bottom - HeightAlong(up, other.box, 1);
    const bool is_balanced = IsBalancedOn(object, other);
    if (drop < -(is_balanced ? kMaxSunk_m : kMaxSunkBeside_m)) continue;
    if (!is_balanced && !LiesAcross(object, other)) continue;
    if (RestsOn(others, other.label, object.label)) continue;
    carriers.push_back({other.label, drop});
  }
  std::stable_sort(carriers.begin(), carriers.end(),
                   [](const Carrier& a, const Carrier& b) { return a.drop_m < b.drop_m; });
  if (carriers.size() > 1) carriers.resize(1);
  if (support) carriers.push_back({0, HeightAboveSupport(object, *support)});
  return carriers;
}

std::optional<int> HeldBy(const DetectedObject& object, const std::vector<DetectedObject>& others,
                          const std::vector<std::size_t>& lower,
                          const std::optional<SupportSurface>& support) {
  constexpr float kMaxAir_m = 0.05F;  // below what is seen of it, by the solid that it is taken for
  constexpr float kMinOverlap = 0.05F, kMinShareAbove = 0.1F;
  const Eigen::Vector3f up = object.box.rotation.col(2);
  const float bottom = HeightAlong(up, object.box, 0);
  if (!support || HeightAboveSupport(object, *support) <= kContact_m) return std::nullopt;
  float most = kMinOverlap;
  std::optional<int> held_by;
  for (const std::size_t i : lower) {
    const DetectedObject& other = others[i];
    const float gap = bottom - HeightAlong(up, other.box, 1);
    const bool is_beside =
        !IsBalancedOn(object, other) && ShareAbove(object, other) <= kMinShareAbove;
    if (gap > kMaxAir_m || gap < -(is_beside ? kMaxSunkBeside_m : kMaxSunk_m)) continue;
    if (RestsOn(others, other.label, object.label)) continue;
    const float share = FootprintOverlap(object.box, other.box);
    if (share <= most) continue;
    most = share;
    held_by = other.label;
  }
  return held_by;
}

}  // namespace fovea
