#include "tests/evaluation/object_figures/object_export.h"

#include <nlohmann/json.hpp>

#include "tests/evaluation/generated/visibility.h"
#include "tests/evaluation/object_figures/object_statistics.h"
#include "tests/evaluation/statistics.h"

namespace fovea::evaluation {
namespace {

const char* NameOf(Shape::Kind kind) { return kShapeNames.at(static_cast<std::size_t>(kind)); }

nlohmann::json ToJson(const MedianAndTail& value) {
  return {{"median", value.median}, {"tail", value.tail}};
}

nlohmann::json ToJson(const BoxFigures& f) {
  return {{"count", f.count},
          {"length_mm", ToJson(f.size_mm[0])},
          {"width_mm", ToJson(f.size_mm[1])},
          {"height_mm", ToJson(f.size_mm[2])},
          {"center_mm", ToJson(f.center_mm)},
          {"yaw_deg", ToJson(f.yaw_deg)},
          {"iou", ToJson(f.iou)}};
}

nlohmann::json ToJson(const DescribedObject& object) {
  nlohmann::json json = {
      {"kind", object.kind},
      {"seed", object.seed},
      {"sensor", object.sensor},
      {"name", object.name},
      {"class", object.what},
      {"visible_share", object.visible_share},
      {"size_error_m", {object.box.size_m[0], object.box.size_m[1], object.box.size_m[2]}},
      {"center_error_m", object.box.center_m},
      {"iou", object.box.iou},
      {"true_shape", NameOf(object.true_shape)},
      {"answered_shape", NameOf(object.answered_shape)},
      {"shape_is_right", object.shape_is_right},
      {"shape_confidence", object.shape_confidence},
      {"unseen_share", object.unseen_share}};
  for (std::size_t i = 0; i < kUncertainNumbers.size(); ++i) {
    if (!object.uncertain[i]) continue;
    json["uncertain"][kUncertainNumbers[i]] = {{"error", object.uncertain[i]->error},
                                               {"sigma", object.uncertain[i]->sigma}};
  }
  if (object.color_is_right) json["color_is_right"] = *object.color_is_right;
  if (object.box.yaw_deg) json["yaw_error_deg"] = *object.box.yaw_deg;
  return json;
}

}  // namespace

nlohmann::json ToJson(const ObjectRun& run) {
  const Score score = ScoreOf(run.on_objects);
  nlohmann::json json = {{"on_objects",
                          {{"truth", run.on_objects.truth},
                           {"answered", run.on_objects.answered},
                           {"precision", score.precision},
                           {"recall", score.recall}}},
                         {"leaning",
                          {{"truth", run.leaning.truth},
                           {"answered", run.leaning.answered},
                           {"right", run.leaning.right}}},
                         {"stands_right", run.stands_right},
                         {"objects_ms", Median(run.objects_ms)},
                         {"objects_ms_for_ten", TenObjectsMs(run)},
                         {"shape_confusions", ConfusionsOf(run)},
                         {"shape_names", kShapeNames}};
  for (const BoxFigures& figures : BoxFiguresOf(run)) json["boxes"][figures.name] = ToJson(figures);
  for (const auto& [name, counts] : RightShapes(run)) {
    json["shape_right"][name] = {{"right", counts.first}, {"count", counts.second}};
  }
  for (const auto& [group, numbers] : HonestiesOf(run)) {
    for (const Honesty& h : numbers) {
      json["honesty"][group][h.name] = {{"count", h.count},
                                        {"within_one", h.within_one},
                                        {"within_two", h.within_two},
                                        {"median_error", h.median_error},
                                        {"median_sigma", h.median_sigma}};
    }
  }
  const auto [right_colors, num_colors] = RightColors(run);
  json["color_right"] = {{"right", right_colors}, {"count", num_colors}};
  json["objects"] = nlohmann::json::array();
  for (const DescribedObject& object : run.objects) json["objects"].push_back(ToJson(object));
  return json;
}

std::vector<Chart> ObjectCharts(const ObjectRun& run) {
  Chart chart;
  chart.title = "3D IoU of boxes, seen to 90 %";
  chart.y_label = "IoU";
  Series median = {"median", {}, {}}, tail = {"tenth percentile", {}, {}};
  const std::string seen = VisibilityName(1) + ", ";
  for (const BoxFigures& figures : BoxFiguresOf(run)) {
    if (figures.name.substr(0, seen.size()) != seen) continue;
    const std::string name = figures.name.substr(seen.size());
    if (name.find(',') != std::string::npos) continue;
    chart.categories.push_back(name);
    median.y.push_back(figures.iou.median);
    tail.y.push_back(figures.iou.tail);
  }
  if (chart.categories.empty()) return {};
  chart.series = {median, tail};
  return {chart};
}

}  // namespace fovea::evaluation
