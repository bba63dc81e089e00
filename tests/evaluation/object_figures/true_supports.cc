#include "tests/evaluation/object_figures/true_supports.h"

namespace fovea::evaluation {
namespace {

// Whether `body`, moved down by 2 mm, enters what it was clear of.
bool RestsOn(const scenes::Body& body, const scenes::Body& other) {
  constexpr double kContact_m = 0.002;
  if (Overlap(body, other)) return false;
  scenes::Body lowered = body;
  lowered.world_from_body.translation().z() -= kContact_m;
  return Overlap(lowered, other);
}

}  // namespace

std::vector<std::vector<int>> TrueSupports(const scenes::Scene& scene) {
  const std::vector<const scenes::Body*> objects = ObjectsOf(scene);
  std::vector<std::vector<int>> supports(objects.size());
  for (std::size_t i = 0; i < objects.size(); ++i) {
    for (std::size_t j = 0; j < objects.size(); ++j) {
      if (i != j && RestsOn(*objects[i], *objects[j])) {
        supports[i].push_back(static_cast<int>(j) + 1);
      }
    }
  }
  return supports;
}

}  // namespace fovea::evaluation
