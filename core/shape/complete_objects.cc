#include "core/shape/complete_objects.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "core/shape/completed.h"
#include "core/shape/outline.h"
#include "core/shape/shape_fit.h"
#include "core/types/helpers.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

constexpr float kContact_m = 0.02F;  // between a thing and what it stands on, as measured
// Of an explanation against which something is seen.
constexpr float kCostOfFloating = 0.05F;
constexpr float kMinOverlap = 0.3F;  // of its points that are above what it stands on

float HeightAlong(const Eigen::Vector3f& up, const OrientedBox& box, float share) {
  return up.dot(box.center) + (share - 0.5F) * box.size_m.z();
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

// What touches the object from below: where it ends, something at the height of its lowest points
// is seen beyond. The label that most of it has, 0 = none; nothing where it is seen to end in the
// air.
std::optional<int> Touching(const DetectedObject& object, const std::vector<DetectedObject>& others,
                            const std::vector<OutlinePoint>& outline) {
  constexpr float kMinShare = 0.12F;  // of the outline where it ends
  const Eigen::Vector3f up = object.visible_box.rotation.col(2);
  const float bottom = HeightAlong(up, object.visible_box, 0);
  std::map<int, int> touches;
  int ends = 0, touching = 0;
  for (const OutlinePoint& point : outline) {
    if (!point.is_own_end || std::isnan(point.beyond.z())) continue;
    ++ends;
    if (std::abs(up.dot(point.beyond) - bottom) > kContact_m) continue;
    ++touching;
    // What rises higher stands beside it.
    const int label = point.label_beyond;
    const bool is_below =
        label > 0 && HeightAlong(up, others[static_cast<std::size_t>(label) - 1].visible_box, 1) <
                         bottom + kContact_m;
    ++touches[is_below ? label : 0];
  }
  if (touching == 0 || static_cast<float>(touching) < kMinShare * static_cast<float>(ends)) {
    return std::nullopt;
  }
  return std::max_element(touches.begin(), touches.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

// What an object may stand on, and how far below the lowest point that was seen.
struct Carrier {
  int label = 0;  // 0: a support
  float drop_m = 0;
};

// The highest of the objects below it, then the support.
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
    if (drop < -kContact_m || ShareAbove(object.cloud, other.box) < kMinOverlap) continue;
    carriers.push_back({other.label, drop});
  }
  std::stable_sort(carriers.begin(), carriers.end(),
                   [](const Carrier& a, const Carrier& b) { return a.drop_m < b.drop_m; });
  if (carriers.size() > 1) carriers.resize(1);
  if (support) {
    const Eigen::Vector3f lowest =
        object.visible_box.center - up * (object.visible_box.size_m.z() / 2);
    carriers.push_back({0, support->HeightOf(lowest)});
  }
  return carriers;
}

std::vector<std::vector<OutlinePoint>> OutlinesOf(const RgbdFrame& frame, const cv::Mat& points,
                                                  const Detections& detections) {
  std::vector<std::vector<OutlinePoint>> outlines(detections.objects.size());
  ForEachTogether(outlines.size(), [&](std::size_t i) {
    const DetectedObject& object = detections.objects[i];
    InterruptionPoint();
    if (object.depth_missing) return;  // its box is a guess already
    outlines[i] =
        OutlineAlongColors(frame, points, detections.labels, object.label, object.bounds_px);
  });
  return outlines;
}

}  // namespace

void CompleteObjects(const RgbdFrame& frame, const cv::Mat& points,
                     const std::vector<std::optional<SupportSurface>>& supports,
                     Detections& detections) {
  std::vector<DetectedObject>& objects = detections.objects;
  const Eigen::Vector3f up = -detections.gravity.direction;
  std::vector<std::size_t> order(objects.size());
  std::iota(order.begin(), order.end(), 0);
  const auto bottom = [&](std::size_t i) { return HeightAlong(up, objects[i].visible_box, 0); };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return bottom(a) < bottom(b); });
  const std::vector<std::vector<OutlinePoint>> outlines = OutlinesOf(frame, points, detections);
  std::vector<std::size_t> done;
  for (const std::size_t i : order) {
    InterruptionPoint();
    DetectedObject& object = objects[i];
    if (object.depth_missing) continue;
    const std::vector<OutlinePoint>& outline = outlines[i];
    FittedShape best;
    LevelFrame best_frame;
    std::optional<int> carrier;
    bool any = false;
    const auto consider = [&](float drop_m, std::optional<int> label, float extra_cost) {
      LevelFrame under = FrameUnder(object.visible_box);
      under.origin -= under.rotation.col(2) * drop_m;
      FittedShape shape = FitShape(object, outline, frame.intrinsics, under);
      shape.cost += extra_cost;
      if (any && best.cost <= shape.cost) return;
      any = true;
      best = std::move(shape);
      best_frame = under;
      carrier = label;
    };
    const std::optional<int> touching = Touching(object, objects, outline);
    const std::vector<Carrier> carriers = CarriersOf(object, objects, done, supports[i]);
    const float nearest = carriers.empty() ? 1 : carriers.front().drop_m;
    if (nearest < kContact_m) {
      consider(nearest, carriers.front().label, 0);
    } else {
      consider(0, touching, touching ? 0 : kCostOfFloating);
      for (const Carrier& below : carriers) {
        consider(below.drop_m, below.label, touching ? kCostOfFloating : 0);
      }
    }
    if (carrier) object.stands_on.push_back(*carrier);
    SetShape(best, best_frame, object);
    SetUnseenShare(detections.labels, frame.intrinsics, best, best_frame, object);
    done.push_back(i);
  }
}

}  // namespace fovea
