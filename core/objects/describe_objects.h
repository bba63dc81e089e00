// From labelled pixels to described objects.
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/depth/back_projection.h"
#include "core/objects/oriented_box.h"
#include "core/objects/selection.h"
#include "core/scene/support_surface.h"
#include "core/types/detections.h"
#include "core/types/rgbd_frame.h"

namespace fovea {

struct ObjectOptions {
  SelectionOptions selection;
  BoxOptions box;
};

// Drops labels as SelectObjects does, renumbers `detections.labels` in its order and fills
// `detections.objects` and the counts of what was dropped. Takes gravity from `detections`; each
// object stands on the highest of the supports that it is above, or on the first.
//
// `detections.labels`: CV_16UC1, 0 = background; `points`: with one wherever there is a label;
// `saliency`: CV_32FC1 in [0, 1]; `facts`: as SelectObjects takes them.
void DescribeObjects(const RgbdFrame& frame, const PixelPoints& points, const BlockImage& saliency,
                     const LabelFacts& facts, const std::vector<Support>& supports,
                     const ObjectOptions& options, Detections& detections);

}  // namespace fovea
