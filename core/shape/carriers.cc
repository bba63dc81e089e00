#include "core/shape/carriers.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/relations/rests_on.h"

namespace fovea {
namespace {

constexpr float kMaxGap_m = 0.04F;  // where masks reach beyond their things or end before
// Of an object's points that are above what it stands on; the least of what holds it if nothing
// else does.
constexpr float kMinOverlap = 0.3F, kLeastOverlap = 0.1F;

// Of the lowest point that was seen.
float HeightAboveSupport(const DetectedObject& object, const SupportSurface& support) {
  const OrientedBox& box = object.visible_box;
  return support.HeightOf(box.center - box.rotation.col(2) * (box.size_m.z() / 2));
}

// Share of the points that are above the box.
float ShareAbove(const std::vector<ColoredPoint>& cloud, const OrientedBox& box) {
  std::size_t above = 0;
  for (const ColoredPoint& p : cloud) {
    const Eigen::Vector3f at =
        box.rotation.transpose() * (Eigen::Vector3f(p.x, p.y, p.z) - box.center);
    above += 2 * std::abs(at.x()) <= box.size_m.x() && 2 * std::abs(at.y()) <= box.size_m.y() &&
                     at.z() >= box.size_m.z() / 2 - kContact_m
                 ? 1
                 : 0;
  }
  return static_cast<float>(above) / static_cast<float>(std::max<std::size_t>(cloud.size(), 1));
}

}  // namespace

float HeightAlong(const Eigen::Vector3f& up, const OrientedBox& box, float share) {
  return up.dot(box.center) + (share - 0.5F) * box.size_m.z();
}

Touch Touching(const DetectedObject& object, const std::vector<DetectedObject>& others,
               const std::vector<OutlinePoint>& outline,
               const std::optional<SupportSurface>& support) {
  constexpr float kMinShare = 0.12F;  // of the outline where it ends
  constexpr int kNothing = -1;
  const Eigen::Vector3f up = object.visible_box.rotation.col(2);
  const float bottom = HeightAlong(up, object.visible_box, 0);
  // What rises higher stands beside it.
  const auto may_carry = [&](int label) {
    if (label == 0) return false;
    const OrientedBox& seen = others[static_cast<std::size_t>(label) - 1].visible_box;
    return HeightAlong(up, seen, 1) < bottom + kContact_m && !RestsOn(others, label, object.label);
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
    if (drop < -kMaxGap_m || RestsOn(others, other.label, object.label)) continue;
    if (ShareAbove(object.cloud, other.box) < kMinOverlap) continue;
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
  const Eigen::Vector3f up = object.visible_box.rotation.col(2);
  const float bottom = HeightAlong(up, object.visible_box, 0);
  if (!support || HeightAboveSupport(object, *support) <= kContact_m) return std::nullopt;
  float most = kLeastOverlap;
  std::optional<int> held_by;
  for (const std::size_t i : lower) {
    const DetectedObject& other = others[i];
    if (std::abs(bottom - HeightAlong(up, other.box, 1)) > kMaxGap_m) continue;
    if (RestsOn(others, other.label, object.label)) continue;
    const float share = ShareAbove(object.cloud, other.box);
    if (share <= most) continue;
    most = share;
    held_by = other.label;
  }
  return held_by;
}

}  // namespace fovea
