#include "core/relations/rests_on.h"

namespace fovea {

bool RestsOn(const std::vector<DetectedObject>& objects, int label, int on) {
  std::vector<bool> is_known(objects.size() + 1);  // by label
  is_known[0] = true;                              // a support rests on nothing
  std::vector<int> open = {label};
  while (!open.empty()) {
    const DetectedObject& object = objects[static_cast<std::size_t>(open.back()) - 1];
    open.pop_back();
    for (const std::vector<int>* below : {&object.stands_on, &object.leans_on}) {
      for (const int next : *below) {
        if (next == on) return true;
        if (is_known[static_cast<std::size_t>(next)]) continue;
        is_known[static_cast<std::size_t>(next)] = true;
        open.push_back(next);
      }
    }
  }
  return false;
}

}  // namespace fovea
