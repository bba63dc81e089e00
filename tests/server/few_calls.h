#pragma once

#include "tests/server/frames.h"
#include "tests/server/loopback.h"

namespace fovea::testing {

inline void DetectTwiceOnceBadly(const Loopback& loopback) {
  loopback.client.Detect(TestRequest());
  StatusOf([&] { loopback.client.Detect({}); });
}

}  // namespace fovea::testing
