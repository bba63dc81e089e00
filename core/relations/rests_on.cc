#include "core/relations/rests_on.h"

#include <algorithm>
#include <cstddef>

namespace fovea {

bool RestsOn(const std::vector<DetectedObject>& objects, int label, int on) {
  std::vector<int> found;  // what it rests on, each once: few, mostly none
  const auto look_below = [&](int above) {
    const DetectedObject& object = objects[static_cast<std::size_t>(above) - 1];
    for (const std::vector<int>* below : {&object.stands_on, &object.leans_on}) {
      for (const int next : *below) {
        const bool is_support = next == 0;  // which rests on nothing
        if (is_support || std::find(found.begin(), found.end(), next) != found.end()) continue;
        found.push_back(next);
      }
    }
  };
  look_below(label);
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i] == on) return true;
    look_below(found[i]);
  }
  return false;
}

}  // namespace fovea
