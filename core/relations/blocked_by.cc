#include "core/relations/blocked_by.h"

namespace fovea {
namespace {

// Adds what rests on the object with this label, directly or not, each after all that rests on it.
void AddAbove(const std::vector<std::vector<int>>& carried, int label, std::vector<bool>& is_known,
              std::vector<int>& above) {
  for (const int other : carried[static_cast<std::size_t>(label)]) {
    if (is_known[static_cast<std::size_t>(other)]) continue;
    is_known[static_cast<std::size_t>(other)] = true;
    AddAbove(carried, other, is_known, above);
    above.push_back(other);
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
  std::vector<bool> is_known;
  for (DetectedObject& object : objects) {
    object.blocked_by.clear();
    is_known.assign(objects.size() + 1, false);
    is_known[static_cast<std::size_t>(object.label)] = true;
    AddAbove(carried, object.label, is_known, object.blocked_by);
  }
}

}  // namespace fovea
