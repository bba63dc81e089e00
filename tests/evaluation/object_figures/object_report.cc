#include "tests/evaluation/object_figures/object_report.h"

#include <fmt/ostream.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/evaluation/generated/visibility.h"
#include "tests/evaluation/scores.h"
#include "tests/evaluation/statistics.h"

namespace fovea::evaluation {
namespace {

constexpr std::array<const char*, 6> kShapeNames = {"other",  "box",        "cylinder",
                                                    "sphere", "revolution", "flat"};

const char* NameOf(Shape::Kind kind) { return kShapeNames.at(static_cast<std::size_t>(kind)); }

MedianAndTail Spread(const std::vector<double>& values, double tail) {
  return {Median(values), Quantile(values, tail)};
}

BoxFigures FiguresOf(const std::string& name, const std::vector<const DescribedObject*>& objects) {
  constexpr double kMm = 1000;
  std::array<std::vector<double>, 3> sizes;
  std::vector<double> centers, yaws, ious;
  for (const DescribedObject* object : objects) {
    const BoxErrors& box = object->box;
    for (int i = 0; i < 3; ++i) sizes[i].push_back(kMm * std::abs(box.size_m[i]));
    centers.push_back(kMm * box.center_m);
    ious.push_back(box.iou);
    if (box.yaw_deg) yaws.push_back(*box.yaw_deg);
  }
  BoxFigures figures = {name, objects.size(), yaws.size(), {}, {}, {}, {}};
  for (int i = 0; i < 3; ++i) figures.size_mm[i] = Spread(sizes[i], 0.9);
  figures.center_mm = Spread(centers, 0.9);
  figures.yaw_deg = Spread(yaws, 0.9);
  figures.iou = Spread(ious, 0.1);
  return figures;
}

void PrintBoxes(std::ostream& out, const ObjectRun& run) {
  fmt::print(out, "{:30} {:>6} {:>11} {:>11} {:>11} {:>12} {:>11} {:>12}\n",
             "boxes: median/90 % (IoU 10 %)", "count", "length mm", "width mm", "height mm",
             "centre mm", "yaw deg", "IoU");
  const auto pair = [](const MedianAndTail& m) {
    return fmt::format("{:.1f}/{:.0f}", m.median, m.tail);
  };
  for (const BoxFigures& f : BoxFiguresOf(run)) {
    fmt::print(out, "{:30} {:6} {:>11} {:>11} {:>11} {:>12} {:>11} {:>12}\n", f.name, f.count,
               pair(f.size_mm[0]), pair(f.size_mm[1]), pair(f.size_mm[2]), pair(f.center_mm),
               pair(f.yaw_deg), fmt::format("{:.2f}/{:.2f}", f.iou.median, f.iou.tail));
  }
}

// [true][answered]
using Confusions = std::array<std::array<int, kShapeNames.size()>, kShapeNames.size()>;

Confusions ConfusionsOf(const ObjectRun& run) {
  Confusions counts = {};
  for (const DescribedObject& object : run.objects) {
    ++counts.at(static_cast<std::size_t>(object.true_shape))
          .at(static_cast<std::size_t>(object.answered_shape));
  }
  return counts;
}

// Of all, and of each class.
std::map<std::string, std::pair<int, int>> RightShapes(const ObjectRun& run) {
  std::map<std::string, std::pair<int, int>> right;
  for (const DescribedObject& object : run.objects) {
    for (const std::string& name :
         {std::string("all"), object.what, VisibilityName(object.visible_share)}) {
      right[name].first += object.shape_is_right;
      ++right[name].second;
    }
  }
  return right;
}

void PrintShapes(std::ostream& out, const ObjectRun& run) {
  fmt::print(out, "\nshape is right\n");
  for (const auto& [name, counts] : RightShapes(run)) {
    fmt::print(out, "  {:16} {:5.1f}% of {}\n", name, 100.0 * counts.first / counts.second,
               counts.second);
  }
  fmt::print(out, "  {:16}", "truth \\ answer");
  for (const char* name : kShapeNames) fmt::print(out, " {:>10}", name);
  const Confusions counts = ConfusionsOf(run);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    fmt::print(out, "\n  {:16}", kShapeNames[i]);
    for (const int count : counts[i]) fmt::print(out, " {:10}", count);
  }
  fmt::print(out, "\n");
}

Score ScoreOf(const Relations& relations) {
  return MakeScore(relations.right, relations.answered, relations.right, relations.truth);
}

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
  if (object.box.yaw_deg) json["yaw_error_deg"] = *object.box.yaw_deg;
  return json;
}

}  // namespace

std::vector<BoxFigures> BoxFiguresOf(const ObjectRun& run) {
  std::vector<BoxFigures> figures;
  for (const double seen : {0.95, 0.8, 0.5}) {
    const std::string visibility = VisibilityName(seen);
    std::map<std::string, std::vector<const DescribedObject*>> groups;
    for (const DescribedObject& object : run.objects) {
      if (VisibilityName(object.visible_share) != visibility) continue;
      for (const std::string& name : {std::string("all"), object.sensor, object.what}) {
        groups[name].push_back(&object);
      }
      if (object.what == "flat") groups["flat, " + object.sensor].push_back(&object);
    }
    for (const auto& [name, objects] : groups) {
      figures.push_back(FiguresOf(visibility + ", " + name, objects));
    }
  }
  return figures;
}

void PrintObjects(std::ostream& out, const ObjectRun& run) {
  PrintBoxes(out, run);
  PrintShapes(out, run);
  const Score score = ScoreOf(run.on_objects);
  fmt::print(out,
             "\nobjects on objects: {} true, {} answered, precision {:.1f}%, recall {:.1f}%; "
             "stands_on exactly right {:.1f}%\n",
             run.on_objects.truth, run.on_objects.answered, 100 * score.precision,
             100 * score.recall,
             100.0 * run.stands_right / std::max<std::size_t>(1, run.objects.size()));
  fmt::print(out, "stage \"objects\" {:.2f} ms (90 % below {:.2f}), for ten objects {:.2f} ms\n",
             Median(run.objects_ms), Quantile(run.objects_ms, 0.9), Median(run.per_ten_ms));
}

nlohmann::json ToJson(const ObjectRun& run) {
  const Score score = ScoreOf(run.on_objects);
  nlohmann::json json = {{"on_objects",
                          {{"truth", run.on_objects.truth},
                           {"answered", run.on_objects.answered},
                           {"precision", score.precision},
                           {"recall", score.recall}}},
                         {"stands_right", run.stands_right},
                         {"objects_ms", Median(run.objects_ms)},
                         {"objects_ms_for_ten", Median(run.per_ten_ms)},
                         {"shape_confusions", ConfusionsOf(run)},
                         {"shape_names", kShapeNames}};
  for (const BoxFigures& figures : BoxFiguresOf(run)) json["boxes"][figures.name] = ToJson(figures);
  for (const auto& [name, counts] : RightShapes(run)) {
    json["shape_right"][name] = {{"right", counts.first}, {"count", counts.second}};
  }
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
