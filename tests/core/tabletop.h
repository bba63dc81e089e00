#pragma once

#include "core/types/rgbd_frame.h"
#include "tests/support/labelled_frame.h"
#include "tests/support/random_scene.h"
#include "tests/support/sensor.h"

namespace fovea::scenes {

// A quarter of a usual frame: enough to find objects in.
inline LabelledFrame TabletopTruth(const cv::Size& size_px = {320, 240}) {
  return MakeFrame(RandomScene("tabletop", 1, size_px), SensorKind::kKinect, 1);
}

// Smaller, where it does not matter what is found: builds with sanitizers take their time.
inline RgbdFrame Tabletop() { return TabletopTruth({160, 120}).frame; }

}  // namespace fovea::scenes
