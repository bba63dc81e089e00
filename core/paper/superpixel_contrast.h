// The contrast of superpixels in place of that of pixels, as Ju et al. 2014 take it.
#pragma once

#include "core/saliency/line_contrast.h"

namespace fovea::paper {

// For DepthSaliency: the mean nearness of superpixels, `per_diagonal` for each pixel of the image's
// diagonal, against lines from their centroids, given to all their pixels. That of every pixel
// where there would be none, as with 0.
Contrast ContrastOfSuperpixels(double per_diagonal);

}  // namespace fovea::paper
