// How sure a detection is.
#pragma once

namespace fovea {

// The probability that a segment of `default` is an object with the right box (IoU above 0.5),
// from its visible area and its distance: what shows little of itself is a fragment more often,
// and what is far away is blurred by noise. Logistic regression over generated scenes of both
// sensors; docs/quality.md has the reliability on others. 0 … 1.
float Confidence(double visible_area_m2, double distance_m);

}  // namespace fovea
