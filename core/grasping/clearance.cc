#include "core/grasping/clearance.h"

#include <algorithm>
#include <cmath>

#include "core/grasping/sight.h"
#include "core/grasping/solid_line.h"
#include "core/grasping/swept_hand.h"
#include "core/types/interruption.h"
#include "core/types/projection.h"

namespace fovea {
namespace {

constexpr float kFarthestSquared = kFarthestClearance_m * kFarthestClearance_m;

// The part of the image in which what is near to the hand is seen.
cv::Rect PartAround(const GraspScene& scene, const SweptHand& hand) {
  const cv::Rect image({}, scene.points.size());
  const Eigen::Vector3f margin = Eigen::Vector3f::Constant(kFarthestClearance_m);
  const Eigen::Vector3f low = hand.Low() - margin, high = hand.High() + margin;
  cv::Rect2d part;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3f at = hand.ToCamera({(corner & 1) != 0 ? high.x() : low.x(),
                                              (corner & 2) != 0 ? high.y() : low.y(),
                                              (corner & 4) != 0 ? high.z() : low.z()});
    if (at.z() < 0.05F) return image;
    const cv::Rect2d pixel(Project(at, scene.intrinsics), cv::Size2d(1, 1));
    part = part.empty() ? pixel : part | pixel;
  }
  part &= cv::Rect2d(image);
  return image & cv::Rect(cvFloor(part.x), cvFloor(part.y), cvCeil(part.width) + 1,
                          cvCeil(part.height) + 1);
}

// The plane that an object stands on: the bottom of its box.
struct OwnFloor {
  explicit OwnFloor(const OrientedBox& box)
      : normal(box.rotation.col(2)), height_m(normal.dot(box.center) - box.size_m.z() / 2) {}

  float HeightOf(const Eigen::Vector3f& p) const { return normal.dot(p) - height_m; }

  Eigen::Vector3f normal;
  float height_m;
};

// Whether the camera sees what lies behind a place.
bool IsSeenThrough(const GraspScene& scene, const Eigen::Vector3f& place) {
  constexpr float kBehind_m = 0.01F, kBehindPer_m = 0.006F;
  if (place.z() < kBehind_m) return false;
  const cv::Point at(Project(place, scene.intrinsics));
  if (!cv::Rect({}, scene.points.size()).contains(at)) return false;
  const float seen_m = scene.points.ptr<cv::Vec3f>(at.y)[at.x][2];
  return seen_m > place.z() + kBehind_m + kBehindPer_m * place.z() * place.z();
}

class Nearest {
 public:
  Nearest(const GraspScene& scene, const std::vector<DetectedObject>& objects, std::size_t target,
          const SweptHand& hand)
      : scene_(scene),
        objects_(objects),
        target_(target),
        hand_(hand),
        floor_(objects[target].box) {}

  // Some of the pixels, then all around those beside which something nearer may be.
  void LookAtPoints() {
    constexpr int kMostPixels = 900;
    constexpr std::size_t kMostPlaces = 12;
    const cv::Rect part = PartAround(scene_, hand_);
    const int step = std::max(1, cvCeil(std::sqrt(part.area() / static_cast<double>(kMostPixels))));
    std::vector<Place> places;
    squared_ = NearestIn(part, step, places);
    if (step == 1) return;
    std::sort(places.begin(), places.end(),
              [](const Place& a, const Place& b) { return a.least_m < b.least_m; });
    places.resize(std::min(places.size(), kMostPlaces));
    std::vector<Place> ignored;
    const int half = step / 2 + 1;
    for (const Place& place : places) {
      if (place.least_m > std::sqrt(squared_)) break;
      const cv::Rect around(place.pixel - cv::Point(half, half),
                            place.pixel + cv::Point(half + 1, half + 1));
      squared_ = std::min(squared_, NearestIn(part & around, 1, ignored));
    }
  }

  // Where it was not seen to be missing.
  void LookAtFloor() {
    for (const Eigen::Vector3f& corner : hand_.Corners()) {
      const Eigen::Vector3f at = hand_.ToCamera(corner);
      const float height_m = std::max(0.0F, floor_.HeightOf(at));
      if (height_m * height_m >= squared_) continue;
      if (!IsSeenThrough(scene_, at - height_m * floor_.normal)) squared_ = height_m * height_m;
    }
  }

  void LookAtOthers() {
    const float reach = (hand_.High() - hand_.Low()).norm() / 2 + kFarthestClearance_m;
    const Eigen::Vector3f middle = hand_.ToCamera((hand_.High() + hand_.Low()) / 2);
    for (std::size_t i = 0; i < objects_.size(); ++i) {
      const DetectedObject& other = objects_[i];
      if (i == target_ || other.shape.hollow) continue;
      if ((other.box.center - middle).norm() > reach + other.box.size_m.norm() / 2) continue;
      LookAtSolid(other);
    }
  }

  float Distance() const { return std::min(kFarthestClearance_m, std::sqrt(squared_)); }

 private:
  // Squared distances, no farther than what is told.
  struct TwoNearest {
    float first = kFarthestSquared, second = kFarthestSquared;
  };

  // A pixel, and how near to the hand what is seen around it may be.
  struct Place {
    float least_m = 0;
    cv::Point pixel;
  };

  // The second smallest squared distance: the smallest may be noise. Appends to `places` the pixels
  // between which something may be that is near enough to be told of.
  float NearestIn(const cv::Rect& part, int step, std::vector<Place>& places) const {
    TwoNearest nearest;
    for (int row = part.y; row < part.br().y; row += step) {
      for (int first = part.x; first < part.br().x; first += step * SweptHand::kTogether) {
        LookAtSome({first, row}, part.br().x, step, nearest, places);
      }
    }
    return nearest.second;
  }

  // Pixels of a row from the first on.
  void LookAtSome(const cv::Point& first, int end, int step, TwoNearest& nearest,
                  std::vector<Place>& places) const {
    constexpr float kSlanted = 1.5F;  // farther apart than on what faces the camera
    const auto* points = scene_.points.ptr<Eigen::Vector3f>(first.y) + first.x;
    SweptHand::Each x, y, z;
    const int num = std::min(SweptHand::kTogether, (end - first.x + step - 1) / step);
    for (int i = 0; i < SweptHand::kTogether; ++i) {  // the last fills up what is left
      const Eigen::Vector3f& point = points[std::min(i, num - 1) * step];
      x[i] = point.x(), y[i] = point.y(), z[i] = point.z();
    }
    const SweptHand::Each squared = hand_.SquaredDistances(x, y, z);
    const float apart = kSlanted * static_cast<float>((step - 1) / scene_.intrinsics.fx_px);
    for (int i = 0; i < num; ++i) {
      const float within = kFarthestClearance_m + apart * z[i];
      const cv::Point pixel(first.x + i * step, first.y);
      if (!(squared[i] < within * within) || !Counts(pixel.y, pixel.x)) continue;
      if (step > 1) places.push_back({std::sqrt(squared[i]) - apart * z[i], pixel});
      nearest.second = std::min(nearest.second, std::max(nearest.first, squared[i]));
      nearest.first = std::min(nearest.first, squared[i]);
    }
  }

  // Not of the object, nor unlabelled at its edge, which may be of it, nor of its floor.
  bool Counts(int row, int column) const {
    constexpr float kOnFloor_m = 0.008F, kNoisePer_m = 0.003F;  // as placed_points.cc has it
    const int label = scene_.labels.ptr<std::uint16_t>(row)[column];
    if (label == objects_[target_].label) return false;
    if (label != 0) return true;
    if (IsAtMask(scene_, row, column, objects_[target_].label)) return false;
    const Eigen::Vector3f& p = scene_.points.ptr<Eigen::Vector3f>(row)[column];
    return std::abs(floor_.HeightOf(p)) > kOnFloor_m + kNoisePer_m * p.z() * p.z();
  }

  // By columns along the way in.
  void LookAtSolid(const DetectedObject& other) {
    constexpr float kStep_m = 0.005F;
    LevelFrame frame;  // of the hand, turned about the way it closes
    frame.rotation << hand_.Axis(0), -hand_.Axis(1), -hand_.Axis(2);
    frame.origin = hand_.ToCamera(Eigen::Vector3f::Zero());
    const CompletedSolid solid(other, frame);
    if (!solid.IsKnown()) return;
    const Eigen::Vector3f margin = Eigen::Vector3f::Constant(kFarthestClearance_m);
    const Eigen::Vector3f half = solid.HalfExtents(), center = solid.Center();
    const Eigen::Vector3f low = (hand_.Low() - margin).cwiseMax(center - half);
    const Eigen::Vector3f high = (hand_.High() + margin).cwiseMin(center + half);
    Lines lines;
    for (float y = low.y() + kStep_m / 2; y < high.y(); y += kStep_m) {
      for (float x = low.x() + kStep_m / 2; x < high.x(); x += kStep_m) {
        lines.Add({x, y, 0}, Eigen::Vector3f::UnitZ());
      }
    }
    std::vector<Span> spans;
    solid.Along(lines, spans);
    for (std::size_t i = 0; i < lines.Size(); ++i) {
      if (spans[i].IsEmpty()) continue;
      const float height = std::max(spans[i].low, std::min(spans[i].high, hand_.Back()));
      const Eigen::Vector3f at(lines.Origins(0)[i], -lines.Origins(1)[i], -height);
      const float squared = hand_.SquaredDistance(at.x(), at.y(), at.z());
      if (squared < squared_ && IsNotSeen(hand_.ToCamera(at))) squared_ = squared;
    }
  }

  bool IsNotSeen(const Eigen::Vector3f& place) const {
    const Sight sight = SightOf(scene_, objects_[target_].label, place);
    return sight != Sight::kFree && sight != Sight::kOnTarget;
  }

  const GraspScene& scene_;
  const std::vector<DetectedObject>& objects_;
  const std::size_t target_;
  const SweptHand& hand_;
  const OwnFloor floor_;
  float squared_ = kFarthestSquared;
};

}  // namespace

float ClearanceOf(const GraspScene& scene, const std::vector<DetectedObject>& objects,
                  std::size_t target, const JawGripper& jaw, const Grasp& grasp) {
  InterruptionPoint();
  const SweptHand hand(jaw, grasp);
  Nearest nearest(scene, objects, target, hand);
  nearest.LookAtPoints();
  nearest.LookAtFloor();
  nearest.LookAtOthers();
  return nearest.Distance();
}

}  // namespace fovea
