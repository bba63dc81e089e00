#include "tests/evaluation/grasp_figures/grasp_statistics.h"

#include <functional>
#include <map>

#include "tests/evaluation/generated/visibility.h"

namespace fovea::evaluation {
namespace {

using NameOfGroup = std::function<std::string(const GraspedObject&)>;

void Add(GripperFigures& sum, const GripperResult& result) {
  ++sum.objects;
  sum.offered += !result.outcomes.empty();
  sum.first += result.FirstSucceeds();
  sum.any += result.AnySucceeds();
  sum.searched += result.possible.has_value();
  sum.possible += result.possible.value_or(false);
  if (!result.outcomes.empty()) return;
  ++sum.none;
  sum.none_right += result.possible && !*result.possible;
}

std::vector<GroupFigures> Grouped(const GraspRun& run, const NameOfGroup& name_of) {
  const std::size_t count = EvaluationGrippers().size();
  std::map<std::string, GroupFigures> groups;
  for (const GraspedObject& object : run.objects) {
    const std::string name = name_of(object);
    GroupFigures& group = groups.try_emplace(name, GroupFigures{name, {}, {}}).first->second;
    group.grippers.resize(count);
    group.with_cup.resize(count);
    for (std::size_t g = 0; g < count; ++g) {
      Add(group.grippers[g], object.grippers[g]);
      group.with_cup[g] +=
          object.grippers[g].FirstSucceeds() || object.grippers.back().FirstSucceeds();
    }
  }
  std::vector<GroupFigures> list;
  list.reserve(groups.size());
  for (auto& [name, group] : groups) list.push_back(std::move(group));
  return list;
}

}  // namespace

std::vector<Grouping> FiguresOf(const GraspRun& run) {
  const auto by = [&](const char* title, const NameOfGroup& name_of) {
    return Grouping{title, Grouped(run, name_of)};
  };
  return {by("all", [](const auto&) { return "all"; }),
          by("class", [](const auto& object) { return object.what; }),
          by("visibility", [](const auto& object) { return VisibilityName(object.visible_share); }),
          by("sensor", [](const auto& object) { return object.sensor; }),
          by("kind", [](const auto& object) { return object.kind; })};
}

// First grasps only: what is offered first is what a robot takes.
std::vector<Prediction> PredictionsOf(const GraspRun& run, std::size_t gripper) {
  std::vector<Prediction> predictions;
  for (const GraspedObject& object : run.objects) {
    const GripperResult& result = object.grippers[gripper];
    if (result.outcomes.empty()) continue;
    predictions.push_back({result.probabilities.front(), result.FirstSucceeds()});
  }
  return predictions;
}

std::vector<int> OutcomesOf(const GraspRun& run, std::size_t gripper) {
  std::vector<int> counts(kOutcomeNames.size());
  for (const GraspedObject& object : run.objects) {
    const auto& outcomes = object.grippers[gripper].outcomes;
    if (!outcomes.empty()) ++counts[static_cast<std::size_t>(outcomes.front())];
  }
  return counts;
}

}  // namespace fovea::evaluation
