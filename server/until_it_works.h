#pragma once

#include <chrono>
#include <thread>

#include "server/log_exception.h"

namespace fovea::server {

// Calls `step` until it throws nothing: memory that is short at the moment may soon be there again.
template <typename Step>
void UntilItWorks(Step&& step) noexcept {
  while (true) {
    try {
      return step();
    } catch (...) {
      LogCurrentException("trying again");
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }
}

}  // namespace fovea::server
