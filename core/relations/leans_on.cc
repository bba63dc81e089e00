#include "core/relations/leans_on.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/relations/rests_on.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

constexpr std::size_t kMaxPoints = 400;

using Points = std::vector<Eigen::Vector3f>;

Points SomePoints(const std::vector<ColoredPoint>& cloud) {
  const std::size_t count = std::min(cloud.size(), kMaxPoints);
  Points points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const ColoredPoint& p = cloud[i * cloud.size() / count];
    points.emplace_back(p.x, p.y, p.z);
  }
  return points;
}

struct Face {
  Eigen::Vector3f middle, normal;  // towards the camera
  float scatter_m = 0;             // standard deviation across it
  float breadth_m = 0;             // the smaller one along it
};

Face FitFace(const Points& points) {
  Face face;
  face.middle.setZero();
  for (const Eigen::Vector3f& p : points) face.middle += p / static_cast<float>(points.size());
  Eigen::Matrix3f spread = Eigen::Matrix3f::Zero();
  for (const Eigen::Vector3f& p : points) {
    const Eigen::Vector3f off = p - face.middle;
    spread += off * off.transpose() / static_cast<float>(points.size());
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver(spread);
  face.normal = solver.eigenvectors().col(0);
  if (face.normal.dot(face.middle) > 0) face.normal = -face.normal;
  const Eigen::Vector3f deviations = solver.eigenvalues().cwiseMax(0).cwiseSqrt();
  face.scatter_m = deviations[0];
  face.breadth_m = deviations[1];
  return face;
}

// The one flat face that nearly all points lie on.
std::optional<Face> OnlyFace(const Points& points) {
  constexpr std::size_t kFewest = 60;
  constexpr float kMinShare = 0.85F, kFlatter = 5;
  if (points.size() < kFewest) return std::nullopt;
  const float z = points[points.size() / 2].z();
  const float noise_m = 0.003F + 0.003F * z * z;
  Face face = FitFace(points);
  Points inliers;
  inliers.reserve(points.size());
  for (int round = 0; round < 2; ++round) {
    inliers.clear();
    const float reach_m = std::max(2 * noise_m, round == 0 ? 1.5F * face.scatter_m : 0.0F);
    std::copy_if(points.begin(), points.end(), std::back_inserter(inliers),
                 [&](const Eigen::Vector3f& p) {
                   return std::abs(face.normal.dot(p - face.middle)) <= reach_m;
                 });
    if (inliers.size() < kFewest) return std::nullopt;
    face = FitFace(inliers);
  }
  const bool is_all =
      static_cast<float>(inliers.size()) >= kMinShare * static_cast<float>(points.size());
  const bool is_flat = face.scatter_m <= noise_m && face.breadth_m >= kFlatter * face.scatter_m;
  if (!is_all || !is_flat) return std::nullopt;
  return face;
}

bool IsTilted(const Face& face, const Eigen::Vector3f& up) {
  constexpr float kLeast = 0.156F, kMost = 0.866F;  // sines of 9 and 60 degrees
  const float sine = face.normal.dot(up);
  return sine >= kLeast && sine <= kMost;
}

constexpr float kGrown_m = 0.01F;  // of what holds, on each side
constexpr int kStepsBehind = 6;    // looked at behind a point
constexpr float kStepBehind_m = 0.01F;

bool IsInside(const OrientedBox& box, const Eigen::Vector3f& point) {
  const Eigen::Vector3f p = box.rotation.transpose() * (point - box.center);
  return ((p.cwiseAbs() - box.size_m / 2).array() <= kGrown_m).all();
}

// Share of the points that have the box behind them.
float ShareHeld(const Points& points, const Face& face, const OrientedBox& box) {
  const auto has_it_behind = [&](const Eigen::Vector3f& p) {
    for (int step = 0; step <= kStepsBehind; ++step) {
      if (IsInside(box, p - static_cast<float>(step) * kStepBehind_m * face.normal)) return true;
    }
    return false;
  };
  const auto held = std::count_if(points.begin(), points.end(), has_it_behind);
  return static_cast<float>(held) / static_cast<float>(std::max<std::size_t>(1, points.size()));
}

// Whether any point of what is around `middle` may have the box behind it.
bool IsWithinReach(const Eigen::Vector3f& middle, float radius_m, const OrientedBox& box) {
  const float reach_m =
      radius_m + box.size_m.norm() / 2 + 2 * kGrown_m + kStepsBehind * kStepBehind_m;
  return (box.center - middle).squaredNorm() <= reach_m * reach_m;
}

float RadiusAround(const Eigen::Vector3f& middle, const Points& points) {
  float squared = 0;
  for (const Eigen::Vector3f& p : points) squared = std::max(squared, (p - middle).squaredNorm());
  return std::sqrt(squared);
}

bool Contains(const std::vector<int>& labels, int label) {
  return std::find(labels.begin(), labels.end(), label) != labels.end();
}

// The half of the points that is higher.
Points UpperHalf(Points points, const Eigen::Vector3f& up) {
  std::sort(points.begin(), points.end(), [&](const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
    return up.dot(a) < up.dot(b);
  });
  points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(points.size() / 2));
  return points;
}

struct Leaning {
  int label, on;
  float held;
};

// All that hold the object up well enough at its side.
void AddWhatHolds(const DetectedObject& object, const Eigen::Vector3f& up,
                  const std::vector<DetectedObject>& others, std::vector<Leaning>& leanings) {
  constexpr float kMinHeld = 0.2F, kBelow_m = 0.03F;
  const Points points = SomePoints(object.cloud);
  const std::optional<Face> face = OnlyFace(points);
  if (!face || !IsTilted(*face, up)) return;
  const Points upper = UpperHalf(points, up);
  const OrientedBox& seen = object.visible_box;
  const float bottom = up.dot(seen.center) - seen.size_m.z() / 2;
  const float radius_m = RadiusAround(face->middle, upper);
  for (const DetectedObject& other : others) {
    const float top = up.dot(other.box.center) + other.box.size_m.z() / 2;
    if (other.label == object.label || Contains(object.stands_on, other.label)) continue;
    if (bottom > top - kBelow_m) continue;
    if (!IsWithinReach(face->middle, radius_m, other.box)) continue;
    InterruptionPoint();
    const float held = ShareHeld(upper, *face, other.box);
    if (held > kMinHeld) leanings.push_back({object.label, other.label, held});
  }
}

}  // namespace

void FindWhatLeans(const Eigen::Vector3f& up, std::vector<DetectedObject>& objects) {
  std::vector<Leaning> leanings;
  for (const DetectedObject& object : objects) {
    InterruptionPoint();
    if (!object.depth_missing) AddWhatHolds(object, up, objects, leanings);
  }
  std::stable_sort(leanings.begin(), leanings.end(),
                   [](const Leaning& a, const Leaning& b) { return a.held > b.held; });
  for (const Leaning& leaning : leanings) {
    DetectedObject& object = objects[static_cast<std::size_t>(leaning.label) - 1];
    if (!object.leans_on.empty() || RestsOn(objects, leaning.on, leaning.label)) continue;
    object.leans_on = {leaning.on};
  }
}

}  // namespace fovea
