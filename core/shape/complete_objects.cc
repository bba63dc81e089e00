#include "core/shape/complete_objects.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/shape/carriers.h"
#include "core/shape/completed.h"
#include "core/shape/outline.h"
#include "core/shape/shape_fit.h"
#include "core/types/helpers.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

// Of an explanation against which something is seen.
constexpr float kCostOfFloating = 0.05F;
// How much more what nothing holds may cost on its support than in the air, floating included.
constexpr float kCostOfStanding = 0.1F;

std::vector<std::vector<OutlinePoint>> OutlinesOf(const RgbdFrame& frame, const PixelPoints& points,
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

// Those that end lowest first: what stands on something is higher, though its lowest points, as
// measured, may not be, as on a book.
std::vector<std::size_t> LowestFirst(const Detections& detections) {
  const std::vector<DetectedObject>& objects = detections.objects;
  const Eigen::Vector3f up = -detections.gravity.direction;
  std::vector<std::size_t> order(objects.size());
  std::iota(order.begin(), order.end(), 0);
  const auto top = [&](std::size_t i) { return HeightAlong(up, objects[i].visible_box, 1); };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return top(a) < top(b); });
  return order;
}

struct Explanation {
  FittedShape shape;
  LevelFrame frame;
  std::optional<int> carrier;  // 0: a support
};

// The solid that stands this far below where the object's points end.
Explanation StandingAt(float drop_m, std::optional<int> carrier, const DetectedObject& object,
                       const std::vector<OutlinePoint>& outline,
                       const CameraIntrinsics& intrinsics) {
  LevelFrame under = FrameUnder(object.visible_box);
  under.origin -= under.rotation.col(2) * drop_m;
  return {FitShape(object, outline, intrinsics, under), under, carrier};
}

// The solid that stands where the object's points end, or that reaches down to a carrier, whichever
// explains more.
Explanation Explain(const DetectedObject& object, const std::vector<OutlinePoint>& outline,
                    const CameraIntrinsics& intrinsics, const Touch& touching,
                    const std::vector<Carrier>& carriers) {
  std::optional<Explanation> best;
  const auto consider = [&](float drop_m, std::optional<int> carrier, float extra_cost) {
    Explanation explained = StandingAt(drop_m, carrier, object, outline, intrinsics);
    explained.shape.cost += extra_cost;
    if (best && best->shape.cost <= explained.shape.cost) return;
    best = std::move(explained);
  };
  const float nearest = carriers.empty() ? 1 : carriers.front().drop_m;
  if (nearest < kContact_m) {
    consider(nearest, carriers.front().label, 0);
  } else {
    consider(0, touching.carrier, touching.is_seen ? 0 : kCostOfFloating);
    for (const Carrier& below : carriers) {
      consider(below.drop_m, below.label, touching.carrier ? kCostOfFloating : 0);
    }
  }
  return *best;
}

// Its box is a guess already. It was found as a hole in what it stands on, and nobody saw its
// surface.
void DescribeUnmeasured(const std::optional<SupportSurface>& support, DetectedObject& object) {
  object.unseen_share = 1;
  if (support) object.stands_on.push_back(0);
}

}  // namespace

void CompleteObjects(const RgbdFrame& frame, const PixelPoints& points,
                     const std::vector<std::optional<SupportSurface>>& supports,
                     Detections& detections) {
  std::vector<DetectedObject>& objects = detections.objects;
  const std::vector<std::vector<OutlinePoint>> outlines = OutlinesOf(frame, points, detections);
  std::vector<std::size_t> done;
  for (const std::size_t i : LowestFirst(detections)) {
    InterruptionPoint();
    DetectedObject& object = objects[i];
    if (object.depth_missing) {
      DescribeUnmeasured(supports[i], object);
      done.push_back(i);
      continue;
    }
    const Touch touching = Touching(object, objects, outlines[i], supports[i]);
    Explanation explained = Explain(object, outlines[i], frame.intrinsics, touching,
                                    CarriersOf(object, objects, done, supports[i]));
    SetShape(explained.shape, explained.frame, object);
    if (!explained.carrier) explained.carrier = HeldBy(object, objects, done, supports[i]);
    if (!explained.carrier && !touching.is_seen && supports[i]) {
      const float drop_m = HeightAboveSupport(object, *supports[i]);
      Explanation standing = StandingAt(drop_m, 0, object, outlines[i], frame.intrinsics);
      if (standing.shape.cost < explained.shape.cost + kCostOfStanding) {
        explained = std::move(standing);
        SetShape(explained.shape, explained.frame, object);
      }
    }
    // Where no support was found, what it ends on is none.
    const bool is_found = explained.carrier && (*explained.carrier != 0 || supports[i]);
    if (is_found) object.stands_on.push_back(*explained.carrier);
    SetUnseenShare(detections.labels, frame.intrinsics, explained.shape, explained.frame, object);
    done.push_back(i);
  }
}

}  // namespace fovea
