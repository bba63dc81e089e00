#include "core/grasping/unseen_way.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/grasping/sight.h"
#include "core/types/projection.h"

namespace fovea {
namespace {

// A box, from `first_m` to `last_m` back from the tool centre point.
struct Passage {
  float half_x_m, half_y_m, first_m, last_m;
};

Passage PassageOf(const JawGripper& jaw, float way_m) {
  const Eigen::Vector3f palm = PalmOf(jaw);
  return {palm.x() / 2, palm.y() / 2, jaw.finger_length_m, jaw.finger_length_m + palm.z() + way_m};
}

Passage PassageOf(const SuctionGripper& cup, float way_m) {
  constexpr float kBesideObject_m = 0.04F;  // where the edge of its depth says nothing
  return {cup.diameter_m / 2, cup.diameter_m / 2, kBesideObject_m, way_m};
}

struct Counts {
  int all = 0, unseen = 0, hidden = 0;

  void Add(const GraspScene& scene, int label, const Eigen::Vector3f& place) {
    constexpr float kNearest_m = 0.01F;
    ++all;
    ++unseen;
    if (place.z() < kNearest_m) return;
    const cv::Point2d at = Project(place, scene.intrinsics);
    if (!(at.x > -0.5 && at.y > -0.5 && at.x < scene.points.cols - 0.5 &&
          at.y < scene.points.rows - 0.5)) {
      return;
    }
    const int row = cvRound(at.y), column = cvRound(at.x);
    const float seen_m = scene.measured_m.empty() ? scene.points.ptr<cv::Vec3f>(row)[column][2]
                                                  : scene.measured_m.ptr<float>(row)[column];
    if (std::isnan(seen_m)) return;
    if (seen_m >= place.z() - SightTolerance(place.z())) {
      --unseen;
    } else {
      hidden += scene.labels.ptr<std::uint16_t>(row)[column] != label ? 1 : 0;
    }
  }
};

}  // namespace

UnseenWay LookAtWay(const GraspScene& scene, int label, const Gripper& gripper,
                    const Grasp& grasp) {
  constexpr float kStep_m = 0.01F;
  const float way_m = std::max(kLeastWay_m, grasp.pre_grasp_distance_m);
  const Passage passage =
      std::visit([&](const auto& hand) { return PassageOf(hand, way_m); }, gripper.hand);
  const Eigen::Vector3f x = passage.half_x_m * grasp.closing;
  const Eigen::Vector3f y = passage.half_y_m * grasp.approach.cross(grasp.closing);
  UnseenWay way;
  const int num_sections = cvCeil((passage.last_m - passage.first_m) / kStep_m);
  for (int section = 0; section < num_sections; ++section) {
    const float back_m = passage.first_m + static_cast<float>(section) * kStep_m;
    const Eigen::Vector3f middle = grasp.tool_center_point - back_m * grasp.approach;
    Counts counts;
    for (const float along : {-1.0F, -0.5F, 0.0F, 0.5F, 1.0F}) {
      for (const float across : {-1.0F, -0.5F, 0.0F, 0.5F, 1.0F}) {
        counts.Add(scene, label, middle + along * x + across * y);
      }
    }
    const auto share = [&](int count) { return static_cast<float>(count) / counts.all; };
    way.unseen = std::max(way.unseen, share(counts.unseen));
    way.hidden = std::max(way.hidden, share(counts.hidden));
  }
  return way;
}

}  // namespace fovea
