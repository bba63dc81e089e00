#pragma once

#include <atomic>
#include <memory>
#include <thread>

namespace fovea::observer {

// Of a thread that ends soon after it is told to: tells it, and waits for it when the program ends,
// not now. `has_ended` is set by its last line.
void LeaveToEnd(std::jthread thread, std::shared_ptr<const std::atomic<bool>> has_ended);

}  // namespace fovea::observer
