// Holes in the masks of objects. Goes beyond the paper.
#pragma once

#include <opencv2/core/mat.hpp>

namespace fovea {

// The middle of a plate is as high as the table, and is held for the table. What one object
// encloses and has no label is of that object where it is noticeably nearer to its colour than to
// the colour of what has no label around it; so the eye of a mug's handle stays what is seen
// through it. Of objects within objects the smaller ones are asked first.
//
// `lab`: CV_8UC3, as of LabOf; `labels`: CV_16UC1 of the same size, 0 = none. Cost: proportional to
// the bounds of all objects.
void FillMaskHoles(const cv::Mat& lab, cv::Mat& labels);

}  // namespace fovea
