// Detectors whose course the test decides.
#pragma once

#include <functional>
#include <future>
#include <latch>
#include <semaphore>
#include <thread>

#include "core/detector.h"

namespace fovea::testing {

// Finds one object in the frame's middle.
Detections FindOne(const RgbdFrame& frame, const DetectorOptions& options, Trace* trace,
                   const std::function<bool()>& should_stop);

// Computes until it is told to stop, and says when it began.
struct Endless {
  std::promise<void> started;

  Detections operator()(const RgbdFrame&, const DetectorOptions&, Trace*,
                        const std::function<bool()>& should_stop) {
    started.set_value();
    while (!should_stop()) std::this_thread::yield();
    throw Cancelled();
  }
};

// Says when it begins a frame and finishes it when it is let.
class Gate {
 public:
  Detections operator()(const RgbdFrame& frame, const DetectorOptions& options, Trace* trace,
                        const std::function<bool()>& should_stop) {
    begun_.release();
    let_.acquire();
    return FindOne(frame, options, trace, should_stop);
  }

  void WaitUntilBegun() { begun_.acquire(); }
  void Let(int frames = 1) { let_.release(frames); }

 private:
  std::counting_semaphore<> begun_{0}, let_{0};
};

}  // namespace fovea::testing
