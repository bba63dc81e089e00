#include "tests/evaluation/real_frames/box_scores.h"

#include <algorithm>
#include <opencv2/core.hpp>
#include <tuple>

#include "tests/evaluation/regions.h"

namespace fovea::evaluation {
namespace {

constexpr double kMostOf = 0.7;       // a share of a box that counts as all of it
constexpr double kHalf = 0.5;         // IoU of what is right; a share that counts as holding it
constexpr double kHardly = 0.1;       // IoU of what does not meet
constexpr double kFewMeasured = 0.3;  // share of the pixels with depth

double Common(const cv::Rect& a, const cv::Rect& b) { return (a & b).area(); }
double ShareIn(const cv::Rect& a, const cv::Rect& b) { return Common(a, b) / a.area(); }
double Iou(const cv::Rect& a, const cv::Rect& b) {
  return Common(a, b) / (a.area() + b.area() - Common(a, b));
}

using Boxes = std::vector<cv::Rect>;

// For each box of `truth` that `wanted` names, the most alike of those `predicted` that are free.
void MatchGreedily(const Boxes& truth, const std::vector<char>& wanted, const Boxes& predicted,
                   std::vector<int>& match_of_truth, std::vector<int>& match_of_prediction) {
  std::vector<std::tuple<double, int, int>> pairs;  // −IoU, true, predicted
  for (int t = 0; t < static_cast<int>(truth.size()); ++t) {
    for (int p = 0; p < static_cast<int>(predicted.size()); ++p) {
      const double iou = Iou(truth[t], predicted[p]);
      if (wanted[t] && iou > kHalf) pairs.emplace_back(-iou, t, p);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  for (const auto& [less, t, p] : pairs) {
    if (match_of_truth[t] >= 0 || match_of_prediction[p] >= 0) continue;
    match_of_truth[t] = p;
    match_of_prediction[p] = t;
  }
}

int NumHeldBy(const cv::Rect& holder, const Boxes& boxes) {
  return static_cast<int>(std::count_if(
      boxes.begin(), boxes.end(), [&](const auto& box) { return ShareIn(box, holder) > kHalf; }));
}

Failure WhyMissed(const cv::Rect& box, const Boxes& truth, const Boxes& predicted,
                  const cv::Mat& depth_m) {
  cv::Rect inside;
  int num_inside = 0;
  bool is_held = false, met = false;
  for (const cv::Rect& p : predicted) {
    if (ShareIn(box, p) > kHalf && NumHeldBy(p, truth) > 1) return Failure::kMerged;
    is_held |= ShareIn(box, p) > kMostOf;
    met |= Iou(box, p) > kHardly;
    if (ShareIn(p, box) <= kMostOf) continue;
    inside |= p;
    ++num_inside;
  }
  if (num_inside > 1 && Iou(inside, box) > kHalf) return Failure::kSplit;
  if (is_held) return Failure::kWithBackground;
  if (num_inside > 0) return Failure::kPart;
  if (met) return Failure::kWrongExtent;
  const cv::Mat seen = depth_m(box & cv::Rect({}, depth_m.size()));
  const bool measured = cv::countNonZero(seen > 0) > kFewMeasured * box.area();
  return measured ? Failure::kNothing : Failure::kNoDepth;
}

Failure WhatItIs(const cv::Rect& prediction, const Boxes& truth) {
  const int num_held = NumHeldBy(prediction, truth);
  if (num_held > 1) return Failure::kMerged;
  bool met = false;
  for (const cv::Rect& box : truth) {
    if (ShareIn(prediction, box) > kMostOf) return Failure::kPart;
    met |= Iou(prediction, box) > kHardly;
  }
  if (num_held == 1) return Failure::kWithBackground;
  return met ? Failure::kWrongExtent : Failure::kNothing;
}

}  // namespace

std::string NameOf(Failure failure) {
  switch (failure) {
    case Failure::kMerged:
      return "merged";
    case Failure::kSplit:
      return "split";
    case Failure::kPart:
      return "part";
    case Failure::kWithBackground:
      return "with background";
    case Failure::kNoDepth:
      return "no depth";
    case Failure::kNothing:
      return "nothing";
    case Failure::kWrongExtent:
      return "wrong extent";
  }
  return "";
}

void BoxScores::Add(const BoxScores& other) {
  required += other.required;
  found += other.found;
  wrong += other.wrong;
  for (const auto& [failure, count] : other.missed) missed[failure] += count;
  for (const auto& [failure, count] : other.wrong_by) wrong_by[failure] += count;
}

Score BoxScores::Boxes() const {
  const Score score = MakeScore(found, found + wrong, found, required);
  // Nothing to find, and nothing found.
  return required == 0 && wrong > 0 ? Score{} : score;
}

BoxScores ScoreBoxes(const BoxedFrame& truth, const cv::Mat& labels) {
  Boxes boxes, predicted;
  std::vector<char> required, optional;
  for (const BoxedObject& object : truth.objects) {
    boxes.push_back(object.box);
    required.push_back(object.optional ? 0 : 1);
    optional.push_back(object.optional ? 1 : 0);
  }
  const std::vector<Region> regions = Regions(labels);
  for (const Region& region : regions) predicted.push_back(region.bounds);
  std::vector<int> match_of_truth(boxes.size(), -1), match_of_prediction(predicted.size(), -1);
  MatchGreedily(boxes, required, predicted, match_of_truth, match_of_prediction);
  MatchGreedily(boxes, optional, predicted, match_of_truth, match_of_prediction);

  BoxScores scores;
  for (std::size_t t = 0; t < boxes.size(); ++t) {
    if (!required[t]) continue;
    ++scores.required;
    if (match_of_truth[t] >= 0) {
      ++scores.found;
      scores.judged[regions[match_of_truth[t]].label] = true;
    } else {
      ++scores.missed[WhyMissed(boxes[t], boxes, predicted, truth.frame.depth_m)];
    }
  }
  for (std::size_t p = 0; p < predicted.size(); ++p) {
    if (match_of_prediction[p] >= 0) continue;
    ++scores.wrong;
    ++scores.wrong_by[WhatItIs(predicted[p], boxes)];
    scores.judged[regions[p].label] = false;
  }
  return scores;
}

}  // namespace fovea::evaluation
