#include "tests/evaluation/reliability.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fovea::evaluation {

Reliability MeasureReliability(const std::vector<Prediction>& predictions, int num_bins) {
  constexpr double kConfident = 0.8;
  Reliability result;
  for (int k = 0; k < num_bins; ++k) {
    result.bins.push_back({double(k) / num_bins, double(k + 1) / num_bins});
  }
  for (const Prediction& prediction : predictions) {
    const int index = std::min(static_cast<int>(prediction.confidence * num_bins), num_bins - 1);
    ReliabilityBin& bin = result.bins[index];
    ++bin.count;
    bin.mean_confidence += prediction.confidence;  // sums, until divided below
    bin.share_correct += prediction.correct;
    if (prediction.confidence < kConfident) continue;
    ++result.confident;
    result.share_of_confident += prediction.correct;
  }
  for (ReliabilityBin& bin : result.bins) {
    if (bin.count == 0) continue;
    result.calibration_error += std::abs(bin.mean_confidence - bin.share_correct);
    bin.mean_confidence /= bin.count;
    bin.share_correct /= bin.count;
  }
  if (!predictions.empty()) result.calibration_error /= static_cast<double>(predictions.size());
  if (result.confident > 0) result.share_of_confident /= result.confident;
  return result;
}

double Calibration::Of(double confidence) const {
  if (from.empty()) return 0;
  const auto next = std::upper_bound(from.begin() + 1, from.end(), confidence);
  return share[static_cast<std::size_t>(next - from.begin() - 1)];
}

Calibration FitCalibration(std::vector<Prediction> predictions) {
  std::sort(predictions.begin(), predictions.end(),
            [](const auto& a, const auto& b) { return a.confidence < b.confidence; });
  struct Step {
    double from, last, correct, count;
    double Share() const { return correct / count; }
  };
  std::vector<Step> steps;
  const auto belong_together = [&] {  // the last two
    if (steps.size() < 2) return false;
    const Step &before = steps[steps.size() - 2], &after = steps.back();
    return before.last == after.from || before.Share() >= after.Share();
  };
  for (const Prediction& prediction : predictions) {
    const double at = prediction.confidence;
    steps.push_back({at, at, prediction.correct ? 1.0 : 0.0, 1.0});
    while (belong_together()) {
      const Step after = steps.back();
      steps.pop_back();
      Step& joined = steps.back();
      joined.last = after.last;
      joined.correct += after.correct;
      joined.count += after.count;
    }
  }
  Calibration calibration;
  for (const Step& step : steps) {
    calibration.from.push_back(step.from);
    calibration.share.push_back(step.Share());
  }
  return calibration;
}

std::vector<Prediction> CalibrateHeldOut(const std::vector<std::vector<Prediction>>& groups) {
  std::vector<Prediction> calibrated;
  for (std::size_t held_out = 0; held_out < groups.size(); ++held_out) {
    std::vector<Prediction> others;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      if (g != held_out) others.insert(others.end(), groups[g].begin(), groups[g].end());
    }
    const Calibration calibration = FitCalibration(std::move(others));
    for (const Prediction& prediction : groups[held_out]) {
      calibrated.push_back({calibration.Of(prediction.confidence), prediction.correct});
    }
  }
  return calibrated;
}

}  // namespace fovea::evaluation
