// Work on many images at a time.
#pragma once

#include <cstddef>
#include <functional>

namespace fovea::evaluation {

// Calls run(i) for each i below `count`, `num_threads` at a time, in no particular order. After a
// failure no more are started; one of the failures is thrown again.
void ForEachIndex(std::size_t count, int num_threads, const std::function<void(std::size_t)>& run);

}  // namespace fovea::evaluation
