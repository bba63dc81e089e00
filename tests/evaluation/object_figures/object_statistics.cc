#include "tests/evaluation/object_figures/object_statistics.h"

#include <cmath>

#include "tests/evaluation/generated/visibility.h"
#include "tests/evaluation/statistics.h"

namespace fovea::evaluation {
namespace {

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

Confusions ConfusionsOf(const ObjectRun& run) {
  Confusions counts = {};
  for (const DescribedObject& object : run.objects) {
    ++counts.at(static_cast<std::size_t>(object.true_shape))
          .at(static_cast<std::size_t>(object.answered_shape));
  }
  return counts;
}

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

std::map<std::string, std::vector<Honesty>> HonestiesOf(const ObjectRun& run) {
  std::map<std::string, std::vector<UncertainBox>> groups;
  for (const DescribedObject& object : run.objects) {
    groups["all"].push_back(object.uncertain);
    groups[VisibilityName(object.visible_share)].push_back(object.uncertain);
  }
  std::map<std::string, std::vector<Honesty>> honesties;
  for (const auto& [name, boxes] : groups) honesties[name] = HonestyOf(boxes);
  return honesties;
}

std::pair<int, int> RightColors(const ObjectRun& run) {
  std::pair<int, int> right;
  for (const DescribedObject& object : run.objects) {
    if (!object.color_is_right) continue;
    right.first += *object.color_is_right;
    ++right.second;
  }
  return right;
}

Score ScoreOf(const Relations& relations) {
  return MakeScore(relations.right, relations.answered, relations.right, relations.truth);
}

}  // namespace fovea::evaluation
