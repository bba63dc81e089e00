#include "core/grasping/unseen_way.h"

#include <algorithm>
#include <opencv2/core/fast_math.hpp>

#include "core/grasping/sight.h"

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

  void Add(Sight sight) {
    ++all;
    unseen += sight != Sight::kFree && sight != Sight::kOnTarget ? 1 : 0;
    hidden += sight == Sight::kBehindOther ? 1 : 0;
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
        counts.Add(MeasuredSightOf(scene, label, middle + along * x + across * y));
      }
    }
    const auto share = [&](int count) { return static_cast<float>(count) / counts.all; };
    way.unseen = std::max(way.unseen, share(counts.unseen));
    way.hidden = std::max(way.hidden, share(counts.hidden));
  }
  return way;
}

}  // namespace fovea
