#include "tests/evaluation/report.h"

#include <fmt/printf.h>

#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>
#include <set>

#include "tests/support/label_colors.h"

namespace fovea::evaluation {
namespace {

nlohmann::json ToJson(const Score& score) {
  return {{"precision", score.precision}, {"recall", score.recall}, {"f", score.f}};
}

nlohmann::json ToJson(const std::vector<StageTime>& times) {
  nlohmann::json json = nlohmann::json::object();
  for (const StageTime& time : times) json[time.stage] = time.duration_ms;
  return json;
}

cv::Mat Outline(const cv::Mat& labels) {
  cv::Mat smallest, largest;
  cv::erode(labels, smallest, {});
  cv::dilate(labels, largest, {});
  return smallest != largest;
}

}  // namespace

void PrintScenes(std::ostream& out, const std::vector<SceneResult>& results) {
  out << fmt::sprintf("%-24s %5s %5s %5s %5s %9s %9s %8s\n", "scene", "true", "found", "boxes",
                      "obj75", "overlapF", "boundF", "ms");
  for (const SceneResult& result : results) {
    const ObjectCounts& counts = result.scores.counts;
    out << fmt::sprintf("%-24s %5d %5d %5d %5d %9.1f %9.1f %8.1f\n", result.name.c_str(),
                        counts.truth, counts.predicted, counts.matched_boxes, counts.matched_75,
                        100 * result.scores.overlap.f, 100 * result.scores.boundary.f,
                        result.total_ms);
  }
  out << '\n';
}

void PrintSummaryHeader(std::ostream& out) {
  out << fmt::sprintf("%-28s %6s %6s %6s  %6s %6s %6s  %6s  %6s %6s %6s  %8s  %s\n", "", "boxP",
                      "boxR", "boxF1", "overP", "overR", "overF", "obj75", "boundP", "boundR",
                      "boundF", "ms", "F1 folds");
}

void PrintSummaryRow(std::ostream& out, const std::string& title, const Summary& summary) {
  const auto score = [](const Score& s) {
    return fmt::sprintf("%6.1f %6.1f %6.1f", 100 * s.precision, 100 * s.recall, 100 * s.f);
  };
  out << fmt::sprintf("%-28s %s  %s  %6.1f  %s  %8.1f  %.1f±%.1f\n", title.c_str(),
                      score(summary.boxes).c_str(), score(summary.overlap).c_str(),
                      100 * summary.share_75, score(summary.boundary).c_str(), summary.median_ms,
                      100 * summary.fold_mean, 100 * summary.fold_deviation)
      << std::flush;
}

void PrintMeanOverImages(std::ostream& out, const Summary& summary) {
  const Score& boxes = summary.boxes_by_image;
  out << fmt::sprintf("%-28s %6.1f %6.1f %6.1f\n", "  boxes, mean over images",
                      100 * boxes.precision, 100 * boxes.recall, 100 * boxes.f);
}

void PrintStages(std::ostream& out, const Summary& summary) {
  const std::set<std::string> fixation_stages = {"color_saliency", "depth_saliency", "seeds"};
  double fixation_ms = 0, segmentation_ms = 0;
  out << "\nmedian time per stage\n";
  for (const StageTime& time : summary.median_stage_ms) {
    out << fmt::sprintf("  %-28s %8.2f ms\n", time.stage.c_str(), time.duration_ms);
    (fixation_stages.contains(time.stage) ? fixation_ms : segmentation_ms) += time.duration_ms;
  }
  out << fmt::sprintf("  %-28s %8.2f ms\n", "detecting fixation points", fixation_ms);
  out << fmt::sprintf("  %-28s %8.2f ms\n", "segmentation", segmentation_ms);
  out << fmt::sprintf("  %-28s %8.2f ms\n", "whole frame", summary.median_ms);
}

nlohmann::json ToJson(const Summary& summary) {
  return {{"objects", summary.counts.truth},
          {"predictions", summary.counts.predicted},
          {"matched_boxes", summary.counts.matched_boxes},
          {"boxes", ToJson(summary.boxes)},
          {"boxes_by_image", ToJson(summary.boxes_by_image)},
          {"overlap", ToJson(summary.overlap)},
          {"boundary", ToJson(summary.boundary)},
          {"share_75", summary.share_75},
          {"median_ms", summary.median_ms},
          {"median_stage_ms", ToJson(summary.median_stage_ms)},
          {"box_f1_folds", {{"mean", summary.fold_mean}, {"deviation", summary.fold_deviation}}}};
}

nlohmann::json ToJson(const std::vector<SceneResult>& results) {
  nlohmann::json scenes = nlohmann::json::array();
  for (const SceneResult& result : results) {
    scenes.push_back({{"name", result.name},
                      {"objects", result.scores.counts.truth},
                      {"predictions", result.scores.counts.predicted},
                      {"matched_boxes", result.scores.counts.matched_boxes},
                      {"matched_75", result.scores.counts.matched_75},
                      {"overlap", ToJson(result.scores.overlap)},
                      {"boundary", ToJson(result.scores.boundary)},
                      {"total_ms", result.total_ms},
                      {"stage_ms", ToJson(result.stage_times)}});
  }
  return scenes;
}

cv::Mat DrawOverlay(const Scene& scene, const cv::Mat& labels) {
  const cv::Mat tint = scenes::ColorLabels(labels);
  cv::Mat picture;
  cv::cvtColor(scene.frame.color_rgb, picture, cv::COLOR_RGB2BGR);
  cv::Mat blended;
  cv::addWeighted(picture, 0.55, tint, 0.45, 0, blended);
  blended.copyTo(picture, labels > 0);
  tint.copyTo(picture, Outline(labels) & (labels > 0));
  picture.setTo(cv::Scalar::all(255), Outline(scene.truth) & (scene.truth > 0));
  return picture;
}

}  // namespace fovea::evaluation
