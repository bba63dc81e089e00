// The whole method: one RGB-D frame in, the unknown objects in it out.
#pragma once

#include <functional>

#include "core/options.h"
#include "core/trace.h"
#include "core/types/cancelled.h"
#include "core/types/detections.h"
#include "core/types/rgbd_frame.h"

namespace fovea {

// Detects the objects of a frame (Bao et al. 2015, sections 3.1 to 3.3).
//
// The same frame and options give the same answer bit for bit, on any run and thread, with or
// without helpers (core/types/helpers.h), with or without what newer processors add: the C
// library's exp and log of doubles differ there in their last bit, and no answer was seen to depend
// on it (tests/core/same_answer_test.cc). There is no shared state, so any number of calls may run
// at once. Nothing found is an answer whose diagnostics say why. `trace`, if given, receives the
// intermediate results; `should_stop`, if given, is asked on this thread after each stage and in
// the midst of them, every few ms (13 at most as measured on images of 1920x1080, some 40 on such
// of noise in every pixel; the first call of a process takes some 100 for OpenCV's tables of
// colours).
//
// Throws std::invalid_argument for a frame or options that do not validate, TooComplex
// (core/types/too_complex.h) for one with more segments or hypotheses than the method holds, and
// Cancelled, which names the stage and what those took so far, when stopped. Cost: see
// docs/performance.md.
Detections Detect(const RgbdFrame& frame, const DetectorOptions& options, Trace* trace = nullptr,
                  const std::function<bool()>& should_stop = {});

}  // namespace fovea
