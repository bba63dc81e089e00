// How well predicted boxes agree with boxes that were drawn by hand, and how they fail.
#pragma once

#include <map>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "tests/evaluation/real_frames/boxed_frames.h"
#include "tests/evaluation/scores.h"

namespace fovea::evaluation {

// Why a required object was not found, or what a wrong prediction is.
enum class Failure {
  kMerged,          // a prediction holds this object and another; the prediction holds two
  kSplit,           // several predictions lie in it, together as large as it is
  kPart,            // a prediction holds a part of it; the prediction is a part of an object
  kWithBackground,  // a prediction holds it and much else; the prediction does
  kNoDepth,         // most of it has no depth and nothing is reported there
  kNothing,         // nothing is reported there; the prediction is background
  kWrongExtent,     // none of these, but a prediction overlaps it; the same of the prediction
};
std::string NameOf(Failure failure);

struct BoxScores {
  int required = 0;
  int found = 0;               // of the required ones
  int wrong = 0;               // predictions that match neither a required nor an optional object
  std::map<int, bool> judged;  // of each predicted label that is right or wrong, not neutral
  std::map<Failure, int> missed;    // required objects, by why
  std::map<Failure, int> wrong_by;  // wrong predictions, by what they are

  void Add(const BoxScores& other);  // without `judged`
  Score Boxes() const;
};

// Scores one frame: boxes of predictions are those of their masks; pairs with IoU > 0.5 are matched
// one to one, the most alike first, required objects before optional ones. `labels`: CV_16UC1,
// 0 = no object.
BoxScores ScoreBoxes(const BoxedFrame& truth, const cv::Mat& labels);

}  // namespace fovea::evaluation
