// How well the predicted objects of one scene agree with the true ones.
#pragma once

#include <map>
#include <opencv2/core/mat.hpp>

namespace fovea::evaluation {

struct Score {
  double precision = 0;
  double recall = 0;
  double f = 0;  // harmonic mean of the two
};

// P = hits_of_predicted / predicted, R = hits_of_truth / truth. Nothing predicted: P 1, R 0;
// nothing to find: P 0, R 1; neither: both 1.
Score MakeScore(double hits_of_predicted, double predicted, double hits_of_truth, double truth);

// Counts, to be added up over the scenes of a data set.
struct ObjectCounts {
  int truth = 0;
  int predicted = 0;
  int matched_boxes = 0;  // pairs of boxes with IoU > 0.5, the most there can be, one to one
  int matched_75 = 0;     // true objects whose assigned prediction has a pixel F > 0.75
};

struct SceneScores {
  ObjectCounts counts;
  Score overlap;   // pixels of assigned pairs among all object pixels (Xie et al. 2021)
  Score boundary;  // the same for the pixels of the object boundaries
  std::map<int, bool> box_matched;  // of each predicted label: whether matched_boxes counts it
};

// Scores one scene. `truth` and `prediction`: CV_16UC1 of one size, 0 = no object, k = object k,
// in any order and with gaps. `valid`: CV_8UC1, 0 where the ground truth has no depth; such
// pixels are no object on both sides.
//
// Boxes are the upright rectangles around the masks. Predictions are assigned to objects so that
// the sum of their pixel F is largest. A boundary pixel of a mask differs from its right, lower
// or lower right neighbour; it is hit if the assigned mask has a boundary pixel within
// ceil(0.003 · image diagonal) pixels.
SceneScores ScoreScene(const cv::Mat& truth, const cv::Mat& prediction, const cv::Mat& valid);

}  // namespace fovea::evaluation
