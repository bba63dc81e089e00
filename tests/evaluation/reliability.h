// Whether confidence means what it says.
#pragma once

#include <vector>

namespace fovea::evaluation {

// One detected object.
struct Prediction {
  double confidence = 0;
  bool correct = false;  // its box is matched to an object's with IoU > 0.5
};

struct ReliabilityBin {
  double low = 0, high = 0;  // of confidence; the last bin includes 1
  int count = 0;
  double mean_confidence = 0;
  double share_correct = 0;
};

struct Reliability {
  std::vector<ReliabilityBin> bins;  // of equal width, by rising confidence
  double calibration_error = 0;      // mean of |confidence − share correct|, weighted by count
  int confident = 0;                 // predictions with a confidence ≥ 0.8
  double share_of_confident = 0;     // of them that are correct
};

// Confidences lie in [0, 1].
Reliability MeasureReliability(const std::vector<Prediction>& predictions, int num_bins = 10);

// A rising step function from confidence to the share correct.
struct Calibration {
  std::vector<double> from;            // rising: where each step begins
  std::vector<double> share;           // rising
  double Of(double confidence) const;  // below the first step: the first; 0 without steps
};

// Isotonic regression: the rising function with the least squared error (pool adjacent violators).
Calibration FitCalibration(std::vector<Prediction> predictions);

// Every group with the confidences that the other groups' calibration gives it, in one list: what
// a calibration is worth on data it has not seen.
std::vector<Prediction> CalibrateHeldOut(const std::vector<std::vector<Prediction>>& groups);

}  // namespace fovea::evaluation
