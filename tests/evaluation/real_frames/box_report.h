// Scores of boxed frames by source, as tables, JSON and pictures.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <opencv2/core/mat.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "tests/evaluation/real_frames/box_scores.h"
#include "tests/evaluation/reliability.h"

namespace fovea::evaluation {

struct BoxedFrameResult {
  std::string source;
  std::string name;
  BoxScores scores;
  double total_ms = 0;                  // wall time of detecting
  std::vector<Prediction> predictions;  // right or wrong ones; none of peers
};

struct BoxSummary {
  std::map<std::string, BoxScores> sources;
  // Each of sources that there are some of; what nothing was asked of has no score.
  bool has_all = false, has_clear = false;
  BoxScores all;       // of all sources but those of clear glass
  double mean_f1 = 0;  // of these sources
  BoxScores clear;     // of the sources of clear glass, whose names end with _transparent
  double median_ms = 0;
};
BoxSummary Summarize(const std::vector<BoxedFrameResult>& results);

// A row per source, all of them, and how required objects are missed and predictions wrong.
void PrintBoxSummary(std::ostream& out, const std::string& title, const BoxSummary& summary);

// F1 of each source, a column per method.
void PrintSideBySide(std::ostream& out, const std::vector<std::string>& methods,
                     const std::vector<BoxSummary>& summaries);

nlohmann::json ToJson(const BoxSummary& summary);
nlohmann::json ToJson(const std::vector<BoxedFrameResult>& results);

// The colour image (BGR) with every prediction tinted and boxed, required objects boxed in white
// and optional ones in grey.
cv::Mat DrawBoxes(const BoxedFrame& frame, const cv::Mat& labels);

}  // namespace fovea::evaluation
