// From labelled pixels to described objects.
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/objects/oriented_box.h"
#include "core/objects/top_grasp.h"
#include "core/scene/support_surface.h"
#include "core/types/detections.h"
#include "core/types/rgbd_frame.h"

namespace fovea {

struct ObjectOptions {
  // Objects with fewer mask pixels are dropped; at an image of 640×480 (scaled with its area, but
  // never fewer than 20).
  double min_pixels = 300;
  // So are objects with less visible area: pixels · z² / (fx · fy), the area of a facing surface;
  // square metres. Unlike pixels, it asks the same of an object at any distance.
  double min_area_m2 = 0;
  // Only the most salient ones are kept, up to this many; 0: all.
  int max_objects = 0;
  BoxOptions box;
  GraspOptions grasp;
};

// Drops the labels with too few pixels and those less salient than `max_objects` others, orders the
// rest by falling confidence (number of pixels, then old label), renumbers `detections.labels` in
// that order and fills `detections.objects` and the counts of what was dropped. Takes gravity from
// `detections`; each object stands on the highest of the supports that it is above, or on the
// first.
//
// `detections.labels`: CV_16UC1, 0 = background; `points`: CV_32FC3 with a point wherever there is
// a label; `saliency`: CV_32FC1 in [0, 1].
void DescribeObjects(const RgbdFrame& frame, const cv::Mat& points, const cv::Mat& saliency,
                     const std::vector<Support>& supports, const ObjectOptions& options,
                     Detections& detections);

}  // namespace fovea
