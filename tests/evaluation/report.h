// Detection results as tables, JSON and pictures.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <opencv2/core/mat.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "tests/evaluation/detection_run.h"

namespace fovea::evaluation {

// One line per scene: objects, predictions, matches, scores in percent, time.
void PrintScenes(std::ostream& out, const std::vector<SceneResult>& results);

// The column names that PrintSummaryRow fills, and one row of scores under them.
void PrintSummaryHeader(std::ostream& out);
void PrintSummaryRow(std::ostream& out, const std::string& title, const Summary& summary);

// Median milliseconds of each stage, in the order of the pipeline, and of the two parts of the
// paper's Table 5.
// A row under that of PrintSummaryRow: Summary::boxes_by_image.
void PrintMeanOverImages(std::ostream& out, const Summary& summary);

void PrintStages(std::ostream& out, const Summary& summary);

nlohmann::json ToJson(const Summary& summary);
nlohmann::json ToJson(const std::vector<SceneResult>& results);

// The colour image (BGR) with every predicted object tinted and outlined, and the true objects
// outlined in white.
cv::Mat DrawOverlay(const Scene& scene, const cv::Mat& labels);

}  // namespace fovea::evaluation
