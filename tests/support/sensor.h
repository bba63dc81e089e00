// What a real RGB-D sensor would measure of an ideal picture.
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>

#include "tests/support/render.h"

namespace fovea::scenes {

enum class SensorKind {
  kIdeal,       // every depth exact; no noise in colour either
  kKinect,      // structured light, first Kinect
  kRealSense,   // active stereo, D400 series, at its best
  kHaloStereo,  // the same as robots get it: edges run out over the table
};

// How far to the right of the camera the projector or the second eye is; 0 for the ideal sensor.
double BaselineOf(SensorKind sensor);

// The standard deviation of measured depth on a surface at `depth_m` that faces the sensor.
//
// kKinect: depth comes from disparity in steps of 1/8 px, z = 348 m / step with 348 = 8 · 580 px ·
//   0.075 m, and a noise of half a step (Khoshelham & Elberink 2012); with the rounding this is
//   1.66 mm · z², within 15 % of the 1.2 mm + 1.9 mm (z − 0.4)² of Nguyen et al. 2012 up to 3 m.
// kRealSense: z² · 0.08 px / (focal length · 0.05 m), Intel's rule for tuning the D400.
double DepthNoise_m(SensorKind sensor, double depth_m, double focal_length_px);

// Depth as the sensor reports it: CV_32FC1, whole millimetres (but for the ideal sensor), NaN =
// none. `rendering` must come from Render with BaselineOf(sensor). Same seed, same bytes.
//
// kKinect: lateral noise of half a pixel, disparity noise over neighbouring pixels as its 9×9
//   correlation window gives it, quantisation (after Handa et al. 2014); no depth where the
//   projector does not reach (a shadow to the left of objects), in a band of 3 to 8 px along
//   upright depth edges (level ones: up to 3 px), beyond 80° of incidence, and outside 0.5 … 8 m.
// kRealSense: smooth noise over some 10 px, foreground fattened by 2 px at depth edges; holes
//   where the other eye does not see, on dark surfaces, here and there on plain ones, and outside
//   0.3 … 6 m.
// kHaloStereo: as kRealSense, but what is nearer reaches some 8 px beyond its edges and slopes down
//   to what is less than about 8 px of disparity behind it.
cv::Mat MeasureDepth(const Rendering& rendering, SensorKind sensor, double focal_length_px,
                     std::uint64_t seed);

// 8-bit sRGB-like colour, CV_8UC3: slight lens blur, gamma 2.2 and, unless ideal, noise of 2.5
// grey levels.
cv::Mat MeasureColor(const Rendering& rendering, SensorKind sensor, std::uint64_t seed);

}  // namespace fovea::scenes
