#include "core/relations/blocked_by.h"

#include <algorithm>

namespace fovea {
namespace {

// Adds what stands on the object with this label, directly or not, the farthest away last.
void AddAbove(const std::vector<std::vector<int>>& carried, int label, int lifted,
              std::vector<int>& above) {
  for (const int other : carried[static_cast<std::size_t>(label)]) {
    const bool is_known = std::find(above.begin(), above.end(), other) != above.end();
    if (is_known || other == lifted) continue;
    above.push_back(other);
    AddAbove(carried, other, lifted, above);
  }
}

}  // namespace

void BlockByWhatStandsOn(std::vector<DetectedObject>& objects) {
  std::vector<std::vector<int>> carried(objects.size() + 1);  // by label
  for (const DetectedObject& object : objects) {
    for (const std::vector<int>* below : {&object.stands_on, &object.leans_on}) {
      for (const int label : *below) {
        carried[static_cast<std::size_t>(label)].push_back(object.label);
      }
    }
  }
  for (DetectedObject& object : objects) {
    object.blocked_by.clear();
    AddAbove(carried, object.label, object.label, object.blocked_by);
    std::reverse(object.blocked_by.begin(), object.blocked_by.end());
  }
}

}  // namespace fovea
